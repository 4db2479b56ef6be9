#include "model/io/gdal_support.h"

#include <algorithm>
#include <mutex>
#include <string_view>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <proj.h>

namespace lodestone {
namespace {

constexpr std::size_t kKept = 10;
constexpr const char* kOsmConfiguration = "/vsimem/lodestone/osm.ini";

// All tags of everything, so that none has to be named; closed ways are areas where they are buildings.
constexpr std::string_view kOsmText = R"(closed_ways_are_polygons=building,building:part
attribute_name_laundering=no
[points]
osm_id=no
[lines]
osm_id=yes
attributes=highway,railway,waterway
all_tags=no
other_tags=no
[multipolygons]
osm_id=yes
attributes=building
all_tags=yes
[multilinestrings]
osm_id=yes
attributes=highway,railway,waterway
all_tags=no
other_tags=no
[other_relations]
osm_id=no
)";

void CPL_STDCALL keepError(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
  if (severity < CE_Failure) return;
  auto& kept = *static_cast<std::vector<std::string>*>(CPLGetErrorHandlerUserData());
  if (kept.size() < kKept && std::find(kept.begin(), kept.end(), message) == kept.end())
    kept.emplace_back(message);
}

bool isOsm(const std::string& path) {
  GDALOpenInfo info(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("OSM");
  return driver && driver->pfnIdentify && driver->pfnIdentify(&info) != 0;
}

}  // namespace

GdalErrors::GdalErrors() {
  useGdal();
  CPLPushErrorHandlerEx(keepError, &failures_);
}

GdalErrors::~GdalErrors() {
  CPLPopErrorHandler();
}

std::string GdalErrors::joined() const {
  std::string text;
  for (const std::string& failure : failures_) text += (text.empty() ? "" : "; ") + failure;
  return text;
}

void DatasetCloser::operator()(GDALDataset* dataset) const {
  GDALClose(dataset);
}

void useGdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALAllRegister();
    CPLSetConfigOption("GDAL_HTTP_MAX_RETRY", "0");
    proj_context_set_enable_network(nullptr, 0);
    VSILFILE* file = VSIFOpenL(kOsmConfiguration, "wb");
    VSIFWriteL(kOsmText.data(), 1, kOsmText.size(), file);
    VSIFCloseL(file);
  });
}

DatasetPtr openVector(const std::string& virtualPath) {
  useGdal();
  static const char* const kDrivers[] = {"GeoJSON",      "GeoJSONSeq", "TopoJSON", "ESRI Shapefile",
                                         "GPKG",         "FlatGeobuf", "OSM",      "SQLite",
                                         "MapInfo File", "KML",        "LIBKML",   nullptr};
  static const char* const kOsmOptions[] = {"CONFIG_FILE=/vsimem/lodestone/osm.ini", "USE_CUSTOM_INDEXING=NO",
                                            nullptr};
  const bool osm = isOsm(virtualPath);
  return DatasetPtr(GDALDataset::Open(virtualPath.c_str(),
                                      GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, kDrivers,
                                      osm ? kOsmOptions : nullptr, nullptr));
}

std::string spellingOf(const OGRSpatialReference* srs) {
  if (!srs) return {};
  const char* authority = srs->GetAuthorityName(nullptr);
  const char* code = srs->GetAuthorityCode(nullptr);
  if (authority && code && std::string_view(authority) == "EPSG") return std::string("EPSG:") + code;
  char* wkt = nullptr;
  static const char* const kWkt2[] = {"FORMAT=WKT2_2018", nullptr};
  const bool exported = srs->exportToWkt(&wkt, kWkt2) == OGRERR_NONE;
  std::string text = exported && wkt ? wkt : "";
  CPLFree(wkt);
  return text;
}

}  // namespace lodestone
