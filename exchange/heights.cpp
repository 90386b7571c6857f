#include "exchange/heights.hpp"

#include "exchange/ascii_grid.hpp"
#include "exchange/formats/polygons.hpp"
#include "exchange/gdal.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace furrow::exchange {

namespace {

constexpr double most_samples = 1 << 26;

// The file in GDAL's memory, opened as one of the two formats.
class OpenGrid {
 public:
  explicit OpenGrid(const LandFile& file)
      : name_{fmt::format("/vsimem/furrow_grid_{}", static_cast<const void*>(this))} {
    keep(name_ + ".asc", file.bytes);
    if (const auto prj = file.companions.find("prj"); prj != file.companions.end()) {
      keep(name_ + ".prj", prj->second);
    }
    const char* const drivers[] = {"AAIGrid", "GTiff", nullptr};
    set_.reset(GDALDataset::Open((name_ + ".asc").c_str(), GDAL_OF_RASTER, drivers));
  }
  ~OpenGrid() {
    set_.reset();
    VSIUnlink((name_ + ".asc").c_str());
    VSIUnlink((name_ + ".prj").c_str());
  }
  OpenGrid(const OpenGrid&) = delete;
  OpenGrid& operator=(const OpenGrid&) = delete;

  GDALDataset* operator->() const { return set_.get(); }
  explicit operator bool() const { return set_ != nullptr; }

 private:
  static void keep(const std::string& name, const std::string& bytes) {
    const auto* data = reinterpret_cast<const GByte*>(bytes.data());
    VSIFCloseL(VSIFileFromMemBuffer(name.c_str(), const_cast<GByte*>(data), bytes.size(), FALSE));
  }

  std::string name_;
  GDALDatasetUniquePtr set_;
};

// Samples of the file, from its north-west, and where they lie in its own coordinates.
struct Grid {
  int columns, rows;
  std::vector<float> heights_m;
  double west, north;          // the first sample
  double per_column, per_row;  // to the next eastwards, southwards; per_row > 0

  float at(double column, double row) const {
    const double x = std::clamp(column, 0.0, columns - 1.0), y = std::clamp(row, 0.0, rows - 1.0);
    const int i = std::min(static_cast<int>(x), columns - 2),
              j = std::min(static_cast<int>(y), rows - 2);
    const double u = x - i, v = y - j;
    const float* p = &heights_m[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                                static_cast<std::size_t>(i)];
    const double upper = (1 - u) * p[0] + u * p[1];
    const double lower = (1 - u) * p[columns] + u * p[columns + 1];
    return static_cast<float>((1 - v) * upper + v * lower);
  }
};

// GDAL takes 0 for text in place of a number, and whole numbers for all where the first are whole.
Expected<std::vector<float>, Fault> read_samples(const OpenGrid& set, const LandFile& file,
                                                 int columns, int rows) {
  if (set->GetDriver()->GetDescription() == std::string_view{"AAIGrid"}) {
    return ascii_samples(file.bytes, static_cast<std::size_t>(columns),
                         static_cast<std::size_t>(rows));
  }
  std::vector<float> read(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  if (set->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, read.data(), columns, rows,
                                      GDT_Float32, 0, 0) != CE_None) {
    return Unexpected{Fault{"must be whole", "samples that cannot be read"}};
  }
  return read;
}

std::optional<Fault> missing_heights(const Grid& grid, GDALRasterBand& band) {
  int has_none = 0;
  const auto none = static_cast<float>(band.GetNoDataValue(&has_none));
  const auto is_none = [&](float h) { return has_none && h == none; };
  const auto is_missing = [&](float h) { return !(std::abs(h) < 20'000) || is_none(h); };
  const auto& all = grid.heights_m;
  const auto first = std::find_if(all.begin(), all.end(), is_missing);
  if (first == all.end()) return std::nullopt;
  const auto count = std::count_if(first, all.end(), is_missing);
  const auto before = first - all.begin();
  return Fault{"must have a height within 20 km for every sample, never NODATA",
               fmt::format("{} {} without, the first in row {}, column {}: {}", count,
                           count == 1 ? "sample" : "samples", before / grid.columns + 1,
                           before % grid.columns + 1,
                           is_none(*first) ? "NODATA" : fmt::format("{:g}", *first))};
}

Expected<Grid, Fault> grid_of(const OpenGrid& set, const LandFile& file) {
  Grid grid{.columns = set->GetRasterXSize(),
            .rows = set->GetRasterYSize(),
            .heights_m = {},
            .west = 0,
            .north = 0,
            .per_column = 0,
            .per_row = 0};
  const double count = double(grid.columns) * grid.rows;
  if (grid.columns < 2 || grid.rows < 2 || count > most_samples || set->GetRasterCount() < 1) {
    return Unexpected{Fault{"must have 2 samples or more on each axis, at most 2^26 in all",
                            fmt::format("{} x {}", grid.columns, grid.rows)}};
  }
  std::array<double, 6> g{};
  if (set->GetGeoTransform(g.data()) != CE_None || g[2] != 0 || g[4] != 0 || !(g[1] > 0) ||
      !(g[5] < 0) || !std::isfinite(g[0] + g[1] + g[3] + g[5])) {
    return Unexpected{Fault{"must say where it lies, with north up", "another placement"}};
  }
  grid.per_column = g[1];
  grid.per_row = -g[5];
  grid.west = g[0] + g[1] / 2;  // GDAL places the corner of the first sample's square
  grid.north = g[3] + g[5] / 2;
  auto read = read_samples(set, file, grid.columns, grid.rows);
  if (!read) return Unexpected{read.error()};
  grid.heights_m = std::move(*read);
  if (auto fault = missing_heights(grid, *set->GetRasterBand(1))) {
    return Unexpected{std::move(*fault)};
  }
  return grid;
}

using Transform = std::unique_ptr<OGRCoordinateTransformation>;

// Between the field frame and the file's coordinates; both ways the identity without a CRS.
class Placement {
 public:
  Placement(const OGRSpatialReference* crs, const LocalFrame& frame) : frame_{frame} {
    if (!crs || crs->IsEmpty()) return;
    OGRSpatialReference own{*crs};
    own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const OGRSpatialReference globe = wgs84();
    to_globe_.reset(OGRCreateCoordinateTransformation(&own, &globe));
    from_globe_.reset(OGRCreateCoordinateTransformation(&globe, &own));
    has_crs_ = true;
  }

  bool is_sound() const { return !has_crs_ || (to_globe_ && from_globe_); }

  std::optional<FieldPoint> to_field(double x, double y) const {
    if (!has_crs_) return at_m(x, y);
    if (!to_globe_->Transform(1, &x, &y)) return std::nullopt;
    const Datum datum = frame_.datum();
    if (!(std::abs(x - datum.lon_deg) < 5 && std::abs(y - datum.lat_deg) < 5)) return std::nullopt;
    return frame_.to_field({x, y});
  }

  // A row of places at a time: transforming one by one is slow.
  bool to_file(std::vector<double>& x, std::vector<double>& y) const {
    if (!has_crs_) return true;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const GeoPoint p = frame_.to_wgs84(at_m(x[i], y[i]));
      x[i] = p.lon_deg;
      y[i] = p.lat_deg;
    }
    return from_globe_->Transform(static_cast<int>(x.size()), x.data(), y.data());
  }

 private:
  const LocalFrame& frame_;
  Transform to_globe_, from_globe_;
  bool has_crs_ = false;
};

Fault misplaced() { return {"must lie within 5 degrees of the field", "a place elsewhere"}; }

// The empty raster that covers the grid, as fine as its finer axis.
Expected<Raster, Fault> cover(const Grid& grid, const Placement& placement) {
  const double east = grid.west + (grid.columns - 1) * grid.per_column;
  const double south = grid.north - (grid.rows - 1) * grid.per_row;
  const auto origin = placement.to_field(grid.west, south);
  const auto next_x = placement.to_field(grid.west + grid.per_column, south);
  const auto next_y = placement.to_field(grid.west, south + grid.per_row);
  if (!origin || !next_x || !next_y) return Unexpected{misplaced()};
  Raster raster{.south_west = *origin,
                .step = std::min(distance(*origin, *next_x), distance(*origin, *next_y)),
                .columns = 0,
                .rows = 0,
                .heights_m = {}};
  FieldPoint far = *origin;
  for (const auto& [x, y] : {std::pair{grid.west, grid.north}, {east, south}, {east, grid.north}}) {
    const auto corner = placement.to_field(x, y);
    if (!corner) return Unexpected{misplaced()};
    raster.south_west = {std::min(raster.south_west.x, corner->x),
                         std::min(raster.south_west.y, corner->y)};
    far = {std::max(far.x, corner->x), std::max(far.y, corner->y)};
  }
  const auto samples = [&](Length side) { return std::ceil(side / raster.step - 1e-6) + 1; };
  const double columns = samples(far.x - raster.south_west.x),
               rows = samples(far.y - raster.south_west.y);
  if (!(columns * rows <= most_samples) || columns < 2 || rows < 2) {
    return Unexpected{Fault{"must have at most 2^26 samples in the field frame",
                            fmt::format("{:.0f} x {:.0f}", columns, rows)}};
  }
  raster.columns = static_cast<std::uint32_t>(columns);
  raster.rows = static_cast<std::uint32_t>(rows);
  return raster;
}

Expected<Raster, Fault> resampled(const Grid& grid, const Placement& placement) {
  auto raster = cover(grid, placement);
  if (!raster) return raster;
  raster->heights_m.reserve(std::size_t{raster->columns} * raster->rows);
  std::vector<double> x(raster->columns), y(raster->columns);
  for (std::uint32_t j = 0; j < raster->rows; ++j) {
    for (std::uint32_t i = 0; i < raster->columns; ++i) {
      x[i] = (raster->south_west.x + double(i) * raster->step).base();
      y[i] = (raster->south_west.y + double(j) * raster->step).base();
    }
    if (!placement.to_file(x, y)) return Unexpected{misplaced()};
    for (std::uint32_t i = 0; i < raster->columns; ++i) {
      raster->heights_m.push_back(
          grid.at((x[i] - grid.west) / grid.per_column, (grid.north - y[i]) / grid.per_row));
    }
  }
  return raster;
}

Expected<Raster, Fault> heights(const LandFile& file, const LocalFrame& frame) {
  const GdalScope quiet;
  const OpenGrid set{file};
  if (!set) {
    return Unexpected{
        Fault{"must be an ESRI ASCII grid or a GeoTIFF",
              fmt::format("\"{}\"", shown(std::string_view{file.bytes}.substr(0, 12)))}};
  }
  const auto grid = grid_of(set, file);
  if (!grid) return Unexpected{grid.error()};
  const Placement placement{set->GetSpatialRef(), frame};
  if (!placement.is_sound()) {
    return Unexpected{Fault{"CRS must be one that can be brought to WGS84", "another"}};
  }
  return resampled(*grid, placement);
}

}  // namespace

Expected<Raster, LandError> read_heights(const LandFile& file, const LocalFrame& frame) {
  auto raster = heights(file, frame);
  if (raster) return std::move(*raster);
  return Unexpected{LandError{file.path, raster.error().rule, raster.error().value}};
}

Expected<Raster, LandError> read_heights(const std::string& path, const LocalFrame& frame) {
  auto file = land_file(path);
  if (!file) return Unexpected{file.error()};
  return read_heights(*file, frame);
}

}  // namespace furrow::exchange
