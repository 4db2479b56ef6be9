#include "model/io/footprints/footprint_layers.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "model/io/gdal_support.h"
#include "model/io/input_file.h"

namespace lodestone {
namespace {

constexpr std::array<std::string_view, 6> kBuildingWords{"build",    "bldg",     "footprint",
                                                         "batiment", "gebaeude", "gebäude"};

constexpr std::size_t kBetweenReports = 4096;

bool hasPolygons(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type == wkbUnknown || type == wkbGeometryCollection || OGR_GT_IsSubClassOf(type, wkbSurface) ||
         OGR_GT_IsSubClassOf(type, wkbMultiSurface);
}

bool speaksOfBuildings(OGRLayer& layer) {
  const std::string name = CPLString(layer.GetName()).tolower();
  return std::any_of(kBuildingWords.begin(), kBuildingWords.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// Layers that may hold footprints, in the order of the file.
std::vector<OGRLayer*> polygonLayers(GDALDataset& dataset) {
  if (layerKind(dataset) == LayerKind::Osm) return {dataset.GetLayerByName("multipolygons")};
  std::vector<OGRLayer*> layers;
  for (OGRLayer* layer : dataset.GetLayers()) {
    if (hasPolygons(*layer)) layers.push_back(layer);
  }
  return layers;
}

std::string namesOf(const std::vector<OGRLayer*>& layers) {
  std::string names;
  for (OGRLayer* layer : layers) names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
  return names;
}

std::string allNames(GDALDataset& dataset) {
  std::vector<OGRLayer*> layers;
  for (OGRLayer* layer : dataset.GetLayers()) layers.push_back(layer);
  return namesOf(layers);
}

/// OSM files hold their layers mixed: one pass counts all of them.
std::map<OGRLayer*, std::int64_t> countOsm(GDALDataset& dataset, const Progress& progress) {
  std::map<OGRLayer*, std::int64_t> counts;
  std::size_t read = 0;
  OGRLayer* layer = nullptr;
  dataset.ResetReading();
  while (const OGRFeatureUniquePtr feature{dataset.GetNextFeature(&layer, nullptr, nullptr, nullptr)}) {
    ++counts[layer];
    if (++read % kBetweenReports == 0) progress.checkpoint();
  }
  return counts;
}

void listMember(const std::string& member, const std::string& wanted, std::vector<LayerEntry>& entries,
                const Progress& progress) {
  const GdalErrors errors;
  const DatasetPtr dataset = openVector(member);
  if (!dataset) return;
  const bool osm = layerKind(*dataset) == LayerKind::Osm;
  const Result<OGRLayer*> chosen = chooseLayer(*dataset, wanted, {});
  std::map<OGRLayer*, std::int64_t> counts;
  if (osm) counts = countOsm(*dataset, progress);
  for (OGRLayer* layer : dataset->GetLayers()) {
    const std::int64_t count = osm ? counts[layer] : layer->GetFeatureCount();
    entries.push_back({layer->GetName(), OGRGeometryTypeToName(layer->GetGeomType()), count,
                       chosen.ok() && *chosen == layer});
    progress.checkpoint();
  }
}

}  // namespace

LayerKind layerKind(GDALDataset& dataset) {
  const std::string_view driver = dataset.GetDriverName();
  if (driver == "OSM") return LayerKind::Osm;
  return driver.starts_with("GeoJSON") ? LayerKind::GeoJson : LayerKind::Plain;
}

Result<OGRLayer*> chooseLayer(GDALDataset& dataset, const std::string& wanted, const std::string& place) {
  const bool osm = layerKind(dataset) == LayerKind::Osm;
  const std::vector<OGRLayer*> layers = polygonLayers(dataset);
  if (!wanted.empty()) {
    OGRLayer* named = dataset.GetLayerByName(wanted.c_str());
    if (!named) {
      return diagnose(Code::LayerMissing, fmt::format("{} is not among {}", wanted, allNames(dataset)), {},
                      place);
    }
    if (osm && named != layers.front()) {
      return diagnose(Code::LayerMissing, fmt::format("{}: OSM has its buildings in multipolygons", wanted),
                      {}, place);
    }
    return named;
  }
  if (layers.empty()) {
    return diagnose(Code::LayerMissing, "no layer of polygons among " + allNames(dataset), {}, place);
  }
  const auto speaking =
      std::find_if(layers.begin(), layers.end(), [](OGRLayer* layer) { return speaksOfBuildings(*layer); });
  Result<OGRLayer*> chosen(speaking == layers.end() ? layers.front() : *speaking);
  if (layers.size() > 1) {
    chosen.diagnostics.push_back(
        diagnose(Code::LayerChosen,
                 fmt::format("{} of {}, which hold polygons", (*chosen.value)->GetName(), namesOf(layers)),
                 {}, place));
  }
  return chosen;
}

std::vector<LayerEntry> listLayers(const std::filesystem::path& path, const std::string& wanted,
                                   const Progress& progress) {
  std::vector<LayerEntry> entries;
  if (!isArchive(path)) {
    listMember(virtualPath(path), wanted, entries, progress);
    return entries;
  }
  const Result<std::vector<std::string>> members = archiveMembers(path);
  if (!members) return entries;
  for (const std::string& member : *members) listMember(member, wanted, entries, progress);
  return entries;
}

}  // namespace lodestone
