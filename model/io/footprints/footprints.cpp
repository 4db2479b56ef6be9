#include "model/io/footprints/footprints.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "model/io/footprints/deckgl_buildings.h"
#include "model/io/footprints/footprint_finish.h"
#include "model/io/footprints/footprint_layers.h"
#include "model/io/gdal_support.h"
#include "model/io/input_file.h"
#include "model/io/places/georeference.h"
#include "model/io/read_archive.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kId = "footprints";
constexpr std::array<std::string_view, 6> kMemberEndings{".shp",  ".geojson", ".geojsonl",
                                                         ".gpkg", ".fgb",     ".json"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool endsWithAny(const std::string& name, std::span<const std::string_view> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

int probeJson(std::string_view head) {
  const auto has = [&](std::string_view word) { return head.find(word) != std::string_view::npos; };
  if (has("\"CityJSON")) return 0;
  if (looksLikeDeckGl(head)) return 70;
  if (has("\"FeatureCollection\"") || has("\"Feature\"") || has("\"Topology\"")) return 90;
  return has("\"coordinates\"") ? 60 : 0;
}

int probe(const fs::path& path, std::string_view head) {
  const std::string name = lower(path.filename().string());
  if (head.starts_with(std::string_view("SQLite format 3\0", 16))) return name.ends_with(".gpkg") ? 100 : 60;
  if (head.starts_with("fgb\x03") || head.starts_with(std::string_view("\0\0\x27\x0a", 4))) return 100;
  if (head.substr(0, 64).find("OSMHeader") != std::string_view::npos) return 100;
  const std::size_t first = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF\x1E");
  if (first == std::string_view::npos) return 0;
  if (head[first] == '<') return head.find("<osm") != std::string_view::npos ? 100 : 0;
  if (head[first] == '{' || head[first] == '[') return probeJson(head);
  return 0;
}

// GDAL takes GeoJSON for longitude and latitude when it does not say; metres give themselves away.
bool beyondDegrees(const std::vector<Building>& buildings) {
  return std::any_of(buildings.begin(), buildings.end(), [](const Building& building) {
    const Box2 box = bounds(building.footprint);
    return !building.footprint.empty() &&
           (box.min.x() < -360 || box.max.x() > 360 || box.min.y() < -90 || box.max.y() > 90);
  });
}

std::optional<Diagnostic> missingField(OGRLayer& layer, const std::string& name, bool isNumber) {
  if (name.empty() || isNumber || layer.GetLayerDefn()->GetFieldIndex(name.c_str()) >= 0) return std::nullopt;
  std::string fields;
  const OGRFeatureDefn* definition = layer.GetLayerDefn();
  for (int i = 0; i < definition->GetFieldCount(); ++i) {
    fields += (i == 0 ? "" : ", ") + std::string(definition->GetFieldDefn(i)->GetNameRef());
  }
  return diagnose(Code::FieldMissing, fmt::format("{} is not among {}", name, fields), {}, layer.GetName());
}

// Where objects have tags and no fields, any may lack any: one that all lack may be mistyped, or nobody in
// this place has tagged it.
void sayMissingFields(const std::vector<Building>& buildings, const ImportOptions& options,
                      const std::string& place, Diagnostics& diagnostics) {
  const HeightRule rule(options);
  const auto none = [&](bool (HeightRule::*has)(const Attributes&) const) {
    return !buildings.empty() && std::none_of(buildings.begin(), buildings.end(), [&](const Building& b) {
      return (rule.*has)(b.object.attributes);
    });
  };
  const auto say = [&](const std::string& tag) {
    diagnostics.push_back(diagnose(Code::FieldMissing, "no building has " + tag, {}, place));
    diagnostics.back().severity = Severity::Warning;
  };
  if (none(&HeightRule::hasNamedHeight)) say(options.height);
  if (none(&HeightRule::hasNamedFloors)) say(options.floors);
}

void sayWhatWasLeft(const LayerFeatures& features, std::size_t all, const std::string& place,
                    Diagnostics& diagnostics) {
  const auto count = [](std::size_t n) { return fmt::format("{} features", n); };
  if (features.otherGeometry > 0) {
    diagnostics.push_back(
        diagnose(Code::GeometryUnsupported, count(features.otherGeometry) + " are no polygons", {}, place));
  }
  if (features.withoutGeometry > 0) {
    diagnostics.push_back(
        diagnose(Code::GeometryEmpty, count(features.withoutGeometry) + " without geometry", {}, place));
  }
  if (features.withoutId > 0) {
    diagnostics.push_back(
        diagnose(Code::IdMissing, fmt::format("{} of {}", features.withoutId, all), {}, place));
  }
  if (features.parts > 0) {
    Diagnostic parts = diagnose(Code::ObjectSkipped,
                                fmt::format("{} areas are building:part only", features.parts), {}, place);
    parts.severity = Severity::Info;
    diagnostics.push_back(std::move(parts));
  }
}

Result<CityModel> readMember(const std::string& member, bool one, const ImportOptions& options,
                             const Progress& progress) {
  GdalErrors errors;
  const DatasetPtr dataset = openVector(member);
  const std::string place = fs::path(member).filename().string();
  if (!dataset) return diagnose(Code::FileMalformed, errors.joined(), {}, place);
  const LayerKind kind = layerKind(*dataset);
  Result<OGRLayer*> chosen = chooseLayer(*dataset, options.layer, place);
  if (!chosen) return Result<CityModel>::failure(std::move(chosen.diagnostics));
  OGRLayer* layer = *chosen.value;
  if (kind == LayerKind::Osm) dataset->ExecuteSQL("SET interest_layers = multipolygons", nullptr, nullptr);
  if (kind != LayerKind::Osm) {
    if (auto why = missingField(*layer, options.height, parseLength(options.height).has_value())) return *why;
    if (auto why = missingField(*layer, options.floors, false)) return *why;
  }

  Result<CityModel> result{CityModel{}, std::move(chosen.diagnostics)};
  CityModel& model = *result.value;
  LayerFeatures features = readFeatures(
      *layer, kind, one ? std::string() : std::string(layer->GetName()) + "/", progress.part(0, 0.7));
  sayWhatWasLeft(features, features.buildings.size(), place, result.diagnostics);
  if (kind == LayerKind::Osm) sayMissingFields(features.buildings, options, place, result.diagnostics);
  if (!errors.failures().empty()) {
    result.diagnostics.push_back(diagnose(Code::FileTruncated, errors.joined(), {}, place));
  }
  model.crs.source = spellingOf(layer->GetSpatialRef());
  if (kind == LayerKind::GeoJson && model.crs.source == "EPSG:4326" && beyondDegrees(features.buildings))
    model.crs.source.clear();
  model.sources.push_back({member, std::string(kId), dataset->GetDriverName(), layer->GetName()});
  model.buildings = finishFootprints(std::move(features), options, result.diagnostics, progress.part(0.7, 1));
  return result;
}

Result<CityModel> readDeckGl(const fs::path& path, const ImportOptions& options, const Progress& progress) {
  Result<std::vector<Building>> parsed = parseDeckGl(readWholeFile(path));
  if (!parsed) return Result<CityModel>::failure(std::move(parsed.diagnostics));
  LayerFeatures features;
  features.buildings = std::move(*parsed);
  features.zRange.assign(features.buildings.size(), Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
  Result<CityModel> result{CityModel{}};
  sayMissingFields(features.buildings, options, path.filename().string(), result.diagnostics);
  result->crs.source = "EPSG:4326";
  result->sources.push_back({path.string(), std::string(kId), "deck.gl", {}});
  result->buildings = finishFootprints(std::move(features), options, result.diagnostics, progress);
  return result;
}

Result<CityModel> read(const fs::path& path, const ImportOptions& options, const Progress& progress) {
  if (isArchive(path)) {
    const auto isOurs = [](const std::string& name) { return endsWithAny(lower(name), kMemberEndings); };
    const auto readOne = [&](const std::string& member, const std::string&, std::size_t count,
                             const Progress& share) {
      return readMember(member, count == 1, options, share);
    };
    return readArchive(path, options, {isOurs, readOne, true}, progress);
  }
  if (looksLikeDeckGl(readHead(path))) return readDeckGl(path, options, progress);
  Result<CityModel> result = readMember(virtualPath(path), true, options, progress);
  if (result) result->sources.front().path = path.string();
  return result;
}

}  // namespace

Format footprintFormat() {
  Format format;
  format.id = kId;
  format.title = "Footprints (GeoJSON, Shapefile, GeoPackage, FlatGeobuf, OSM, …)";
  format.extensions = {".geojson", ".geojsonl", ".json", ".shp",    ".gpkg",
                       ".fgb",     ".osm",      ".pbf",  ".osm.gz", ".zip"};
  format.probe = probe;
  format.read = read;
  format.listensTo = {"height", "floors", "floor-height", "default-height", "layer"};
  return format;
}

}  // namespace lodestone
