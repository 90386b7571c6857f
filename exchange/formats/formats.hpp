#pragma once
// One reader per family of formats. Each adds what it finds, and returns why it could not.

#include "exchange/formats/polygons.hpp"
#include "exchange/land_file.hpp"

#include <optional>

namespace furrow::exchange {

/// Drivers of GDAL in use.
enum class Driver { geojson, shapefile, geopackage };

/// GeoJSON, shapefile and GeoPackage, through OGR.
std::optional<Fault> read_vector_layers(const LandFile& file, Driver driver, Polygons& found);

/// WKT or EWKT geometries, one after the other.
std::optional<Fault> read_well_known_text(const LandFile& file, Polygons& found);

/// KML, GML or ISOXML, told by the root element.
std::optional<Fault> read_xml(const LandFile& file, Polygons& found);

}  // namespace furrow::exchange
