#include "exchange/heights.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

using namespace furrow;
using namespace furrow::exchange;

const Datum datum{.lat_deg = 30.0, .lon_deg = 114.0};

Raster read(const LandFile& file) {
  const auto raster = read_heights(file, LocalFrame{datum});
  INFO((raster ? "" : text(raster.error())));
  REQUIRE(raster);
  return *raster;
}
std::string refusal(const LandFile& file) {
  const auto raster = read_heights(file, LocalFrame{datum});
  REQUIRE(!raster);
  return text(raster.error());
}

const std::string grid_text =
    "ncols 3\nnrows 2\nxllcorner 95\nyllcorner 195\ncellsize 10\nNODATA_value -9999\n"
    "1 2 3\n4 5 6.5\n";

TEST_CASE("An ASCII grid without a CRS lies in the field frame, its southern row first") {
  // Squares of 10 m from (95, 195): the first sample, in the middle of its square, at (100, 200).
  const Raster raster = read({"hill.asc", grid_text});
  CHECK(raster.south_west == at_m(100, 200));
  CHECK(raster.step == metres(10));
  REQUIRE((raster.columns == 3 && raster.rows == 2));
  CHECK(raster.heights_m == std::vector<float>{4, 5, 6.5, 1, 2, 3});
}

TEST_CASE("A grid in degrees is brought into the field frame") {
  // 5 x 5 squares of 0.001 degrees around the datum; heights rise 1 m a column eastwards. On the
  // ellipsoid 0.001 degrees of longitude at 30 degrees north are 96.486 m, of latitude 110.852 m.
  std::string grid = "ncols 5\nnrows 5\nxllcorner 113.9975\nyllcorner 29.9975\ncellsize 0.001\n";
  for (int j = 0; j < 5; ++j) grid += "0 1 2 3 4\n";
  const std::string prj =
      R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
  const Raster raster = read({"hill.asc", grid, {{"prj", prj}}});
  CHECK(raster.step.base() == Approx(96.486).margin(0.01));
  CHECK(raster.south_west.x.base() == Approx(-2 * 96.486).margin(0.05));
  CHECK(raster.south_west.y.base() == Approx(-2 * 110.852).margin(0.05));
  REQUIRE((raster.columns == 5 && raster.rows == 6));  // 4 x 110.852 / 96.486 = 4.6 steps north
  for (std::uint32_t i = 0; i < 5; ++i) {
    CHECK(raster.heights_m[2 * raster.columns + i] == Approx(static_cast<double>(i)).margin(0.01));
  }
}

TEST_CASE("The .prj beside a grid is its CRS") {
  const auto folder = std::filesystem::temp_directory_path() / "furrow_heights_test";
  std::filesystem::create_directories(folder);
  // Squares of 0.001 degrees: in the field frame they are about 100 m wide, and 0.001 m without it.
  std::ofstream{folder / "hill.asc"} << "ncols 2\nnrows 2\nxllcorner 113.999\nyllcorner 29.999\n"
                                        "cellsize 0.001\n0 1\n0 1\n";
  std::ofstream{folder / "hill.prj"}
      << R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
  const auto raster = read_heights((folder / "hill.asc").string(), LocalFrame{datum});
  std::filesystem::remove_all(folder);
  REQUIRE(raster);
  CHECK(raster->step.base() == Approx(96.486).margin(0.01));
}

TEST_CASE("A GeoTIFF gives the heights that were written") {
  read({"hill.asc", grid_text});  // registers the drivers
  const std::string name = "/vsimem/written.tif";
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  REQUIRE(driver);
  {
    GDALDatasetUniquePtr set{driver->Create(name.c_str(), 4, 3, 1, GDT_Float32, nullptr)};
    double where[] = {0, 2, 0, 6, 0, -2};  // squares of 2 m, the north-west corner at (0, 6)
    REQUIRE(set->SetGeoTransform(where) == CE_None);
    std::vector<float> heights(12);
    for (int i = 0; i < 12; ++i) heights[static_cast<std::size_t>(i)] = static_cast<float>(i * i);
    REQUIRE(set->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 4, 3, heights.data(), 4, 3, GDT_Float32,
                                            0, 0) == CE_None);
  }
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(name.c_str(), &size, FALSE);
  const Raster raster = read({"hill.tif", {reinterpret_cast<const char*>(bytes), size}});
  VSIUnlink(name.c_str());
  CHECK(raster.south_west == at_m(1, 1));
  REQUIRE((raster.columns == 4 && raster.rows == 3));
  CHECK(raster.heights_m == std::vector<float>{64, 81, 100, 121, 16, 25, 36, 49, 0, 1, 4, 9});
}

TEST_CASE("What is no grid of heights is refused with the rule") {
  CHECK(refusal({"a.asc", "hello"}) ==
        "a.asc: must be an ESRI ASCII grid or a GeoTIFF (got \"hello\")");
  CHECK(refusal({"a.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n"}) ==
        "a.asc: must have 2 samples or more on each axis, at most 2^26 in all (got 1 x 1)");
  std::string hole = grid_text;
  hole.replace(hole.find("6.5"), 3, "-9999");
  CHECK(refusal({"a.asc", hole}) ==
        "a.asc: must have a height within 20 km for every sample, never NODATA (got 1 sample "
        "without, the first in row 2, column 3: NODATA)");
  const auto none = read_heights("no/such.asc", LocalFrame{datum});
  CHECK(!none);
}

std::string with(const std::string& old, const std::string& other) {
  const std::size_t at = grid_text.find(old);
  REQUIRE(at != std::string::npos);
  return grid_text.substr(0, at) + other + grid_text.substr(at + old.size());
}

TEST_CASE("Samples of a grid without a height are counted, and the first is named") {
  CHECK(refusal({"a.asc", with("2 3\n4", "-9999 30000\nnan")}) ==
        "a.asc: must have a height within 20 km for every sample, never NODATA (got 3 samples "
        "without, the first in row 1, column 2: NODATA)");
  CHECK(refusal({"a.asc", with("5 6.5", "5 30000.5")}) ==
        "a.asc: must have a height within 20 km for every sample, never NODATA (got 1 sample "
        "without, the first in row 2, column 3: 30000.5)");
}

TEST_CASE("Text in place of a height is refused with its place, and so are too few or too many") {
  CHECK(refusal({"a.asc", with("5 6.5", "abc 6.5")}) ==
        "a.asc: must have a number for every sample (got \"abc\" in line 8, row 2, column 2)");
  CHECK(refusal({"a.asc", with("1 2", "x 2")}) ==
        "a.asc: must have a number for every sample (got \"x\" in line 7, row 1, column 1)");
  CHECK(refusal({"a.asc", with("5 6.5", "5 6.5m")}) ==
        "a.asc: must have a number for every sample (got \"6.5m\" in line 8, row 2, column 3)");
  CHECK(refusal({"a.asc", with("4 5 6.5", "4 5")}) ==
        "a.asc: must have as many samples as its header says (got 5 for 3 x 2)");
  CHECK(refusal({"a.asc", with("4 5 6.5", "4 5 6.5 7")}) ==
        "a.asc: must have as many samples as its header says (got 7 for 3 x 2)");
}

TEST_CASE("Heights with a decimal comma, an exponent or a sign are read, whatever ends the lines") {
  std::string text;
  for (const char c : with("1 2 3\n4 5 6.5\n", "1,5\t+2 -3\n\n4e0  5.25 6")) {
    if (c == '\n') text += '\r';
    text += c;
  }
  CHECK(read({"hill.asc", text}).heights_m == std::vector<float>{4, 5.25, 6, 1.5, 2, -3});
}

}  // namespace
