// KML and GML by their geometry elements: OGR's own GML reader wants a schema, and writes one
// beside the file. OGR builds the geometries; polygons of KML are written as in GML 2.
#include "exchange/formats/formats.hpp"
#include "exchange/formats/isoxml.hpp"
#include "exchange/formats/xml_tree.hpp"
#include "exchange/gdal.hpp"

#include <ogr_api.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace furrow::exchange {

namespace {

constexpr std::array areal{"Polygon",      "MultiPolygon",     "Surface",      "MultiSurface",
                           "PolygonPatch", "CompositeSurface", "MultiGeometry"};
constexpr std::array other_geometry{"Point",      "LineString", "Curve",          "LinearRing",
                                    "MultiPoint", "MultiCurve", "MultiLineString"};

template <std::size_t N>
bool is_one_of(const CPLXMLNode* node, const std::array<const char*, N>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return is_element(node, name); });
}

// What elements around a geometry say of it.
struct Context {
  std::string name, srs_name;
  std::optional<Area> stated_area;
};

struct MarkedUp {
  bool is_kml, is_gaos;
  std::string file_srs_name;  // of the first element that has one
  Polygons& found;
  std::optional<Fault> fault = {};
};

/// The CRS of "EPSG:4258", ".../epsg.xml#4258" (longitude first) and of the URN and URL forms
/// (axes as the authority has them).
Expected<OGRSpatialReference, Fault> crs_of(const std::string& srs_name) {
  if (srs_name.find("CRS84") != std::string::npos) return wgs84();
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto digits = std::find_if_not(srs_name.rbegin(), srs_name.rend(), is_digit).base();
  const auto code = number(std::string{digits, srs_name.end()});
  OGRSpatialReference crs;
  const bool is_known =
      code && *code <= 999'999 && crs.importFromEPSG(static_cast<int>(*code)) == OGRERR_NONE;
  if (!is_known) return Unexpected{Fault{"srsName must end in a known EPSG code", shown(srs_name)}};
  const bool is_strict =
      srs_name.find("urn:") != std::string::npos || srs_name.find("/def/crs/") != std::string::npos;
  crs.SetAxisMappingStrategy(is_strict ? OAMS_AUTHORITY_COMPLIANT : OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string first_srs_name(const CPLXMLNode* node, int depth) {
  std::string name = attribute(node, "srsName");
  for (const CPLXMLNode* child = node->psChild; child && name.empty(); child = child->psNext) {
    if (child->eType == CXT_Element && depth < deepest_element) {
      name = first_srs_name(child, depth + 1);
    }
  }
  return name;
}

// What `node` itself says takes the place of what the elements around it said.
Context within(const CPLXMLNode* node, Context context, bool is_gaos) {
  if (auto name = child_text(node, "name"); !name.empty()) context.name = std::move(name);
  if (auto srs = attribute(node, "srsName"); !srs.empty()) context.srs_name = std::move(srs);
  if (is_gaos) {
    const auto area = number(attribute(node, "area"));  // GAOS: hectares
    if (area && *area > 0) context.stated_area = hectares(*area);
  }
  for_each_child(node, [&](const CPLXMLNode* child) {
    const bool is_text = child->psChild && child->psChild->eType == CXT_Text;
    const std::string key{local_name(child)};
    const auto area = is_text ? stated_area(key, child->psChild->pszValue) : std::nullopt;
    if (area) context.stated_area = area;
  });
  return context;
}

void take(const CPLXMLNode* node, const Context& context, MarkedUp& document) {
  // OGR wants a geometry without its siblings.
  CPLXMLNode alone = *node;
  alone.psNext = nullptr;
  const std::unique_ptr<OGRGeometry> geometry{
      OGRGeometry::FromHandle(OGR_G_CreateFromGMLTree(&alone))};
  if (!geometry) {
    document.fault = Fault{"must hold sound polygons", shown(local_name(node))};
    return;
  }
  std::string srs_name = attribute(node, "srsName");
  if (srs_name.empty()) srs_name = context.srs_name;
  if (srs_name.empty()) srs_name = first_srs_name(node, 0);
  if (srs_name.empty()) srs_name = document.file_srs_name;
  Tag tag{.name = context.name, .stated_area = context.stated_area};
  if (!document.is_kml && srs_name.empty()) {
    document.fault = Fault{"must say its CRS in a srsName", "none"};
    return;
  }
  auto crs = document.is_kml ? Expected<OGRSpatialReference, Fault>{wgs84()} : crs_of(srs_name);
  if (!crs) {
    document.fault = crs.error();
    return;
  }
  tag.crs = &*crs;
  document.found.add(*geometry, tag);
}

// KML's MultiGeometry may mix what OGR's GML does not: its members are taken one by one.
void walk(const CPLXMLNode* node, const Context& around, MarkedUp& document, int depth) {
  if (document.fault || depth > deepest_element) return;
  const bool is_whole =
      is_one_of(node, areal) && !(document.is_kml && is_element(node, "MultiGeometry"));
  if (is_whole) return take(node, around, document);
  if (is_one_of(node, other_geometry)) return document.found.add(OGRPoint{}, {});
  const Context context = within(node, around, document.is_gaos);
  for_each_child(node, [&](const CPLXMLNode* child) { walk(child, context, document, depth + 1); });
}

}  // namespace

std::optional<Fault> read_xml(const LandFile& file, Polygons& found) {
  const GdalScope gdal;
  const XmlTree tree = xml_tree(file.bytes);
  const CPLXMLNode* top = root(tree.get());
  if (!top) {
    return Fault{"must be sound XML", gdal.complaint().empty() ? "no element" : gdal.complaint()};
  }
  if (is_element(top, "ISO11783_TaskData")) return read_isoxml(top, file, found);
  MarkedUp document{.is_kml = is_element(top, "kml"),
                    .is_gaos = is_element(top, "GAOS_parcel"),
                    .file_srs_name = first_srs_name(top, 0),
                    .found = found};
  walk(top, {}, document, 0);
  return document.fault;
}

}  // namespace furrow::exchange
