#include "exchange/gdal.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_http.h>
#include <gdal_frmts.h>
#include <ogrsf_frmts.h>

#include <algorithm>

namespace furrow::exchange {

namespace {

CPLHTTPResult* refuse(const char*, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc,
                      void*, void*) {
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("nothing is read from a network");
  return result;
}

// A file must not make the reader fetch anything, nor spend more than its own size.
bool set_up() {
  CPLHTTPSetFetchCallback(refuse, nullptr);
  OSRSetPROJEnableNetwork(0);
  CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_EXTENSIONS", "{noext}.none");
  CPLSetConfigOption("SHAPE_RESTORE_SHX", "YES");
  CPLSetConfigOption("OGR_GEOJSON_MAX_OBJ_SIZE", "64");
  RegisterOGRGeoJSON();
  RegisterOGRShape();
  RegisterOGRGeoPackage();
  GDALRegister_AAIGrid();
  GDALRegister_GTiff();
  return true;
}

void CPL_STDCALL remember(CPLErr severity, CPLErrorNum, const char* message) {
  if (severity < CE_Warning) return;
  *static_cast<std::string*>(CPLGetErrorHandlerUserData()) = shown(message);
}

}  // namespace

GdalScope::GdalScope() {
  CPLPushErrorHandlerEx(remember, &complaint_);
  [[maybe_unused]] static const bool once = set_up();
}

GdalScope::~GdalScope() { CPLPopErrorHandler(); }

OGRSpatialReference wgs84() {
  OGRSpatialReference crs;
  crs.importFromEPSG(4326);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string shown(std::string_view raw) {
  constexpr std::size_t longest = 80;
  std::string line{raw.substr(0, longest)};
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  return raw.size() > longest ? line + "..." : line;
}

}  // namespace furrow::exchange
