#include "model/io/footprints/vector_preview.h"

#include <algorithm>
#include <cctype>
#include <memory>

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "model/attributes.h"
#include "model/io/footprints/footprint_heights.h"
#include "model/io/footprints/footprint_layers.h"
#include "model/io/gdal_support.h"
#include "model/io/input_file.h"

namespace lodestone {
namespace {

constexpr int kMostFeatures = 2000;
constexpr std::size_t kMostSamples = 5;
constexpr std::size_t kMostRingVertices = 200000;

bool isNumber(OGRFieldType type) {
  return type == OFTInteger || type == OFTInteger64 || type == OFTReal;
}

void addRing(const OGRLinearRing& ring, std::vector<Ring>& outlines, std::size_t& vertices) {
  if (vertices > kMostRingVertices) return;
  Ring result;
  for (int i = 0; i < ring.getNumPoints(); ++i) result.emplace_back(ring.getX(i), ring.getY(i));
  vertices += result.size();
  outlines.push_back(std::move(result));
}

void addOutlines(const OGRGeometry& geometry, LayerPreview& layer, std::size_t& vertices) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    layer.hasPolygons = true;
    if (const OGRLinearRing* ring = geometry.toPolygon()->getExteriorRing())
      addRing(*ring, layer.outlines, vertices);
  } else if (type == wkbLineString) {
    layer.hasLines = true;
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) addOutlines(*part, layer, vertices);
  }
}

/// Collects the sampled values of one field.
struct FieldSampler {
  FieldPreview field;
  bool numberByType = false;
  bool allNumbers = true;
  bool any = false;

  void add(const std::string& text) {
    if (text.empty()) return;
    const std::optional<double> number = parseNumber(text);
    allNumbers = allNumbers && number.has_value();
    if (number) {
      field.min = any ? std::min(field.min, *number) : *number;
      field.max = any ? std::max(field.max, *number) : *number;
    }
    any = true;
    const bool known = std::find(field.samples.begin(), field.samples.end(), text) != field.samples.end();
    if (!known && field.samples.size() < kMostSamples) field.samples.push_back(text);
  }
};

bool isUsual(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto holds = [&](auto names) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return holds(usualHeightFields()) || holds(usualFloorFields());
}

std::string crsName(const OGRSpatialReference* crs) {
  if (!crs) return {};
  const char* name = crs->GetName();
  const char* code = crs->GetAuthorityCode(nullptr);
  const std::string text = name ? name : "";
  return code ? text + " (EPSG:" + code + ")" : text;
}

LayerPreview previewLayer(OGRLayer& source) {
  LayerPreview layer;
  layer.name = source.GetName();
  layer.crs = crsName(source.GetSpatialRef());
  if (source.TestCapability(OLCFastFeatureCount)) layer.features = source.GetFeatureCount(FALSE);
  const OGRFeatureDefn& definition = *source.GetLayerDefn();
  std::vector<FieldSampler> samplers(static_cast<std::size_t>(definition.GetFieldCount()));
  for (std::size_t i = 0; i < samplers.size(); ++i) {
    const OGRFieldDefn& field = *definition.GetFieldDefn(static_cast<int>(i));
    samplers[i].field.name = field.GetNameRef();
    samplers[i].numberByType = isNumber(field.GetType());
  }
  std::size_t vertices = 0;
  source.ResetReading();
  int count = 0;
  for (; count < kMostFeatures; ++count) {
    const std::unique_ptr<OGRFeature> feature(source.GetNextFeature());
    if (!feature) break;
    if (const OGRGeometry* geometry = feature->GetGeometryRef()) addOutlines(*geometry, layer, vertices);
    for (std::size_t i = 0; i < samplers.size(); ++i) {
      const int at = static_cast<int>(i);
      if (feature->IsFieldSetAndNotNull(at)) samplers[i].add(feature->GetFieldAsString(at));
    }
  }
  if (layer.features < 0 && count < kMostFeatures) layer.features = count;
  for (FieldSampler& sampler : samplers) {
    layer.saysHeights = layer.saysHeights || (sampler.any && isUsual(sampler.field.name));
    sampler.field.numeric = sampler.numberByType || (sampler.any && sampler.allNumbers);
    layer.fields.push_back(std::move(sampler.field));
  }
  return layer;
}

}  // namespace

Result<VectorPreview> previewVector(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return diagnose(Code::FileNotFound, path.string());
  const GdalErrors errors;
  useGdal();
  const DatasetPtr dataset = openVector(virtualPath(path));
  if (!dataset) return diagnose(Code::FormatUnknown, path.string());
  VectorPreview preview;
  const Result<OGRLayer*> chosen = chooseLayer(*dataset, {}, {});
  for (OGRLayer* layer : dataset->GetLayers()) {
    LayerPreview found = previewLayer(*layer);
    found.read = chosen.ok() && *chosen == layer;
    if (found.hasPolygons || found.hasLines) preview.layers.push_back(std::move(found));
  }
  return preview;
}

}  // namespace lodestone
