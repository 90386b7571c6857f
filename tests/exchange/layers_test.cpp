// Shapefile and GeoPackage, written by OGR in place.
#include "exchange/gdal.hpp"
#include "exchange/land.hpp"
#include "tests/exchange/ground.hpp"

#include <catch2/catch.hpp>

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace {

using namespace furrow;
using namespace furrow::exchange;
namespace fs = std::filesystem;

class Folder {
 public:
  Folder() {
    // Its name ends as mkdtemp asks for.
    std::string name =
        (fs::temp_directory_path() / "furrow_layers_").string() + std::string(6, 'X');
    REQUIRE(mkdtemp(name.data()));
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(const std::string& file) const { return (path_ / file).string(); }

 private:
  fs::path path_;
};

void append(OGRLayer& layer, const char* wkt, const char* name, double area_ha) {
  const std::unique_ptr<OGRFeature> feature{OGRFeature::CreateFeature(layer.GetLayerDefn())};
  OGRGeometry* geometry = nullptr;
  REQUIRE(OGRGeometryFactory::createFromWkt(wkt, nullptr, &geometry) == OGRERR_NONE);
  feature->SetGeometryDirectly(geometry);
  feature->SetField("name", name);
  feature->SetField("area_ha", area_ha);
  REQUIRE(layer.CreateFeature(feature.get()) == OGRERR_NONE);
}

// Two polygons in UTM 33 south, near Windhoek: 400 m x 250 m, and 100 m x 100 m with a hole.
void write(const std::string& path, const char* driver, bool has_crs) {
  const GdalScope gdal;
  GDALDriver* with = GetGDALDriverManager()->GetDriverByName(driver);
  REQUIRE(with);
  const std::unique_ptr<GDALDataset> file{
      with->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr)};
  REQUIRE(file);
  OGRSpatialReference utm;
  utm.importFromEPSG(32733);
  OGRLayer* layer = file->CreateLayer("fields", has_crs ? &utm : nullptr, wkbPolygon);
  REQUIRE(layer);
  OGRFieldDefn name{"name", OFTString}, area{"area_ha", OFTReal};
  REQUIRE(layer->CreateField(&name) == OGRERR_NONE);
  REQUIRE(layer->CreateField(&area) == OGRERR_NONE);
  append(*layer,
         "POLYGON ((500000 7500000, 500400 7500000, 500400 7500250, 500000 7500250, "
         "500000 7500000))",
         "west", 10.008);
  append(*layer,
         "POLYGON ((501000 7500000, 501100 7500000, 501100 7500100, 501000 7500100, "
         "501000 7500000), (501040 7500040, 501040 7500060, 501060 7500060, 501060 7500040, "
         "501040 7500040))",
         "east", 0.9608);
}

void check_both_fields(const std::string& path) {
  const double map_scale2 = 0.9996 * 0.9996;  // of UTM at its central meridian
  const auto west = read_land(path, 0), east = read_land(path, 1);
  INFO((west ? "" : text(west.error())));
  REQUIRE(west);
  REQUIRE(east);
  CHECK(west->features == 2);
  CHECK(west->name == "west");
  CHECK(west->datum.lat_deg < 0);
  CHECK(ground::area_m2(west->field) == Approx(100000 / map_scale2).epsilon(1e-6));
  CHECK(ground::area_m2(west->field) == Approx(west->stated_area->base()).epsilon(1e-3));
  CHECK(east->field.holes.size() == 1);
  CHECK(ground::area_m2(east->field) == Approx(9600 / map_scale2).epsilon(1e-6));
  CHECK(!read_land(path, 2));
}

TEST_CASE("A shapefile is read with its CRS and names, also without its index") {
  const Folder folder;
  write(folder / "farm.shp", "ESRI Shapefile", true);
  check_both_fields(folder / "farm.shp");
  fs::remove(folder / "farm.shx");
  check_both_fields(folder / "farm.shp");
  CHECK(!fs::exists(folder / "farm.shx"));  // reading writes nothing
  const GdalScope gdal;
  const CPLStringList kept{VSIReadDirRecursive("/vsimem/")};
  CHECK(kept.empty());  // nor keeps anything
}

TEST_CASE("A shapefile without its .prj is refused") {
  const Folder folder;
  write(folder / "farm.shp", "ESRI Shapefile", false);
  const auto read = read_land(folder / "farm.shp", 0);
  REQUIRE(!read);
  CHECK(text(read.error()) ==
        (folder / "farm.shp") + ": must have its CRS in a .prj file beside it (got none)");
}

TEST_CASE("A shapefile of a local CRS is refused") {
  const Folder folder;
  write(folder / "farm.shp", "ESRI Shapefile", false);
  std::ofstream{folder / "farm.prj"} << R"(LOCAL_CS["yard",UNIT["metre",1]])";
  const auto read = read_land(folder / "farm.shp", 0);
  REQUIRE(!read);
  CHECK(text(read.error()) ==
        (folder / "farm.shp") + ": CRS must be one that can be brought to WGS84 (got yard)");
}

TEST_CASE("A GeoPackage is read with its CRS and names") {
  const Folder folder;
  write(folder / "farm.gpkg", "GPKG", true);
  check_both_fields(folder / "farm.gpkg");
}

TEST_CASE("A GeoPackage of an undefined CRS is refused") {
  const Folder folder;
  write(folder / "farm.gpkg", "GPKG", false);
  const auto read = read_land(folder / "farm.gpkg", 0);
  REQUIRE(!read);
  CHECK(read.error().file == folder / "farm.gpkg");
  CHECK(read.error().rule == "CRS must be one that can be brought to WGS84");
  CHECK(read.error().value.find("ndefined") != std::string::npos);
}

}  // namespace
