// Source: ISO 11783-10:2015, annex D: PFD part field, PLN polygon, LSG line string, PNT point.
#include "exchange/formats/isoxml.hpp"

#include "exchange/gdal.hpp"

#include <utility>
#include <vector>

namespace furrow::exchange {

namespace {

struct IsoPolygon {
  std::vector<OGRLinearRing> exteriors, interiors;
  std::optional<Area> area;
};

std::optional<Fault> append_point(const CPLXMLNode* point, OGRLinearRing& ring) {
  const std::string north = attribute(point, "C"), east = attribute(point, "D");
  const auto lat = number(north), lon = number(east);
  if (!lat || !lon) {
    return Fault{"PNT must have a latitude C and a longitude D", shown(north + ", " + east)};
  }
  ring.addPoint(*lon, *lat);
  return std::nullopt;
}

// LSG types 1 and 2 are rings; the others are lines for guidance.
std::optional<Fault> append_ring(const CPLXMLNode* line, IsoPolygon& polygon) {
  const std::string type = attribute(line, "A");
  if (type != "1" && type != "2") return std::nullopt;
  OGRLinearRing ring;
  std::optional<Fault> fault;
  for_each_child(line, [&](const CPLXMLNode* child) {
    if (!fault && is_element(child, "PNT")) fault = append_point(child, ring);
  });
  ring.closeRings();
  (type == "1" ? polygon.exteriors : polygon.interiors).push_back(std::move(ring));
  return fault;
}

Expected<IsoPolygon, Fault> iso_polygon(const CPLXMLNode* node) {
  IsoPolygon polygon;
  std::optional<Fault> fault;
  for_each_child(node, [&](const CPLXMLNode* child) {
    if (!fault && is_element(child, "LSG")) fault = append_ring(child, polygon);
  });
  if (fault) return Unexpected{*fault};
  const auto area = number(attribute(node, "C"));
  if (area && *area > 0) polygon.area = square_metres(*area);
  return polygon;
}

// A hole belongs to the exterior that has its first vertex inside; most files have one exterior.
OGRMultiPolygon with_holes(const IsoPolygon& source) {
  OGRMultiPolygon parts;
  for (const OGRLinearRing& exterior : source.exteriors) {
    OGRPolygon part;
    part.addRingDirectly(exterior.clone());
    for (const OGRLinearRing& interior : source.interiors) {
      if (interior.IsEmpty()) continue;
      OGRPoint first;
      interior.getPoint(0, &first);
      if (source.exteriors.size() == 1 || exterior.isPointInRing(&first))
        part.addRingDirectly(interior.clone());
    }
    parts.addGeometry(&part);
  }
  return parts;
}

// Water, building, road, obstacle: land that is not sprayed.
bool is_cut_out(std::string_view type) {
  return type == "3" || type == "4" || type == "5" || type == "6";
}

struct PartField {
  OGRMultiPolygon cut_outs;
  std::vector<std::pair<OGRMultiPolygon, std::optional<Area>>> boundaries;
};

std::optional<Fault> append_polygon(const CPLXMLNode* node, PartField& part_field) {
  const std::string type = attribute(node, "A");
  if (type != "1" && !is_cut_out(type)) return std::nullopt;
  auto polygon = iso_polygon(node);
  if (!polygon) return polygon.error();
  const OGRMultiPolygon parts = with_holes(*polygon);
  if (type == "1") {
    part_field.boundaries.emplace_back(parts, polygon->area);
  } else {
    for (const OGRPolygon* part : parts) part_field.cut_outs.addGeometry(part);
  }
  return std::nullopt;
}

std::unique_ptr<OGRGeometry> without(const OGRMultiPolygon& land, const OGRMultiPolygon& cut_outs) {
  std::unique_ptr<OGRGeometry> rest{land.clone()};
  for (const OGRPolygon* cut : cut_outs) {
    if (!rest->Intersects(cut)) continue;
    std::unique_ptr<OGRGeometry> smaller{rest->Difference(cut)};
    if (smaller) rest = std::move(smaller);
  }
  return rest;
}

std::optional<Fault> read_part_field(const CPLXMLNode* node, Polygons& found) {
  PartField part_field;
  std::optional<Fault> fault;
  for_each_child(node, [&](const CPLXMLNode* child) {
    if (!fault && is_element(child, "PLN")) fault = append_polygon(child, part_field);
  });
  if (fault) return fault;
  const OGRSpatialReference crs = wgs84();
  const auto whole = number(attribute(node, "D"));
  for (const auto& [boundary, area] : part_field.boundaries) {
    Tag tag{.name = attribute(node, "C"), .stated_area = area, .crs = &crs};
    const bool is_whole = part_field.boundaries.size() == 1;
    if (!area && is_whole && whole && *whole > 0) tag.stated_area = square_metres(*whole);
    found.add(*without(boundary, part_field.cut_outs), tag);
  }
  return std::nullopt;
}

std::optional<Fault> read_part_fields(const CPLXMLNode* parent, Polygons& found) {
  std::optional<Fault> fault;
  for_each_child(parent, [&](const CPLXMLNode* child) {
    if (!fault && is_element(child, "PFD")) fault = read_part_field(child, found);
  });
  return fault;
}

}  // namespace

std::optional<Fault> read_isoxml(const CPLXMLNode* root, const LandFile& file, Polygons& found) {
  if (auto fault = read_part_fields(root, found)) return fault;
  for (const auto& [name, bytes] : file.companions) {
    if (name == "prj") continue;  // of whatever lies beside: ISOXML is WGS84
    const XmlTree tree = xml_tree(bytes);
    const CPLXMLNode* part = furrow::exchange::root(tree.get());
    if (!part || !is_element(part, "XFC")) {
      return Fault{"external files must be sound ISOXML", shown(name)};
    }
    if (auto fault = read_part_fields(part, found)) return fault;
  }
  if (found.count() == 0) {
    return Fault{"must have a part field (PFD) with a boundary (PLN of type 1)", "none"};
  }
  return std::nullopt;
}

}  // namespace furrow::exchange
