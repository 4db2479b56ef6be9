// readLines() of read_city.h.
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "model/io/gdal_support.h"
#include "model/io/input_file.h"
#include "model/io/places/georeference.h"
#include "model/io/read_city.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBetweenReports = 1024;
/// Columns that say what a line is, the first that is filled counts.
constexpr std::array<const char*, 9> kKindFields{"highway", "railway", "waterway", "fclass",    "type",
                                                 "TYPE",    "kind",    "class",    "road_class"};

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

/// From a layer's coordinates to the model's metres.
class ToModel {
 public:
  ToModel(const Crs& layer, const CityModel& model) : frame_(model) {
    const bool comparable = known(layer) && known(model.crs);
    const bool same = layer.source == model.crs.source || (layer.epsg != 0 && layer.epsg == model.crs.epsg);
    if (!comparable || same) return;
    const auto from = horizontalReference(layer);
    const auto to = horizontalReference(model.crs);
    transformation_.reset(from && to ? OGRCreateCoordinateTransformation(from.get(), to.get()) : nullptr);
    failed_ = transformation_ == nullptr;
  }

  /// False when there is no way from one system to the other.
  [[nodiscard]] bool possible() const { return !failed_; }

  /// False when the point has no place in the model's system.
  bool operator()(Vec2& p) const {
    if (transformation_ && !transformation_->Transform(1, &p.x(), &p.y())) return false;
    p = frame_.toLocal(p);
    return p.allFinite();
  }

 private:
  static bool known(const Crs& crs) {
    return crs.kind == CrsKind::Projected || crs.kind == CrsKind::Geographic;
  }
  Frame frame_;
  Transformation transformation_;
  bool failed_ = false;
};

class LineCollector {
 public:
  LineCollector(LineLayer& layer, const ToModel& toModel) : layer_(layer), toModel_(toModel) {}

  void add(const OGRGeometry& geometry, const std::string& kind) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbLineString || type == wkbLinearRing) {
      lines_ += addLine(*geometry.toLineString(), kind) ? 1 : 0;
    } else if (type == wkbPolygon) {
      ++polygons_;
      for (const OGRLinearRing* ring : *geometry.toPolygon()) addLine(*ring, kind);
    } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, kind);
    } else if (OGR_GT_IsNonLinear(type)) {
      const std::unique_ptr<OGRGeometry> linear(geometry.getLinearGeometry());
      if (linear && !OGR_GT_IsNonLinear(linear->getGeometryType())) add(*linear, kind);
    }
  }
  [[nodiscard]] std::size_t ignored() const { return ignored_; }
  /// "873 lines", "the outlines of 12 polygons"; empty when there is nothing.
  [[nodiscard]] std::string taken() const {
    std::string text = lines_ > 0 ? fmt::format("{} lines", lines_) : "";
    if (polygons_ > 0)
      text += fmt::format("{}the outlines of {} polygons", lines_ > 0 ? " and " : "", polygons_);
    return text;
  }

 private:
  bool addLine(const OGRSimpleCurve& source, const std::string& kind) {
    std::vector<Vec2> line;
    bool good = true;
    for (int i = 0; i < source.getNumPoints(); ++i) {
      Vec2 p(source.getX(i), source.getY(i));
      good = good && toModel_(p);
      if (line.empty() || line.back() != p) line.push_back(p);
    }
    if (!good || line.size() < 2) {
      ++ignored_;
      return false;
    }
    layer_.lines.push_back(std::move(line));
    layer_.kinds.push_back(kind);
    return true;
  }

  LineLayer& layer_;
  const ToModel& toModel_;
  std::size_t ignored_ = 0;
  std::size_t lines_ = 0;
  std::size_t polygons_ = 0;
};

std::string kindOf(const OGRFeature& feature) {
  for (const char* name : kKindFields) {
    const int index = feature.GetFieldIndex(name);
    if (index >= 0 && feature.IsFieldSetAndNotNull(index)) return feature.GetFieldAsString(index);
  }
  return {};
}

bool isStreetRailOrRiver(const OGRFeature& feature) {
  for (const char* name : {"highway", "railway", "waterway"}) {
    const int index = feature.GetFieldIndex(name);
    if (index >= 0 && feature.IsFieldSetAndNotNull(index)) return true;
  }
  return false;
}

bool hasLines(OGRLayer& layer) {
  const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
  return type == wkbUnknown || type == wkbGeometryCollection || OGR_GT_IsSubClassOf(type, wkbCurve) ||
         OGR_GT_IsSubClassOf(type, wkbMultiCurve);
}

using Layers = std::vector<OGRLayer*>;

/// The layer named, of a file with several; else layers of lines; where there are none, of polygons, whose
/// outlines are lines as well (rivers, blocks).
Result<Layers> chooseLayers(GDALDataset& dataset, const std::string& wanted, const std::string& place) {
  if (std::string_view(dataset.GetDriverName()) == "OSM") {
    const std::string name = wanted.empty() ? "lines" : wanted;
    OGRLayer* named = dataset.GetLayerByName(name.c_str());
    if (!named) {
      return diagnose(Code::LayerMissing, name + " is not among lines, multilinestrings, multipolygons", {},
                      place);
    }
    dataset.ExecuteSQL(("SET interest_layers = " + std::string(named->GetName())).c_str(), nullptr, nullptr);
    return Layers{named};
  }
  Layers all;
  Layers lines;
  std::string names;
  for (OGRLayer* layer : dataset.GetLayers()) {
    all.push_back(layer);
    if (hasLines(*layer)) lines.push_back(layer);
    names += (names.empty() ? "" : ", ") + std::string(layer->GetName());
  }
  if (!wanted.empty() && all.size() > 1) {
    if (OGRLayer* named = dataset.GetLayerByName(wanted.c_str())) return Layers{named};
    return diagnose(Code::LayerMissing, fmt::format("{} is not among {}", wanted, names), {}, place);
  }
  Result<Layers> chosen(lines.empty() ? all : lines);
  if (!wanted.empty() && !dataset.GetLayerByName(wanted.c_str()))
    chosen.diagnostics.push_back(diagnose(
        Code::OptionUnused, fmt::format("barrier-layer: {}; the one layer is {}", wanted, names), {}, place));
  return chosen;
}

void readLayer(OGRLayer& source, bool osm, const CityModel& model, LineLayer& into, Diagnostics& diagnostics,
               const Progress& progress) {
  const ToModel toModel(resolveCrs(spellingOf(source.GetSpatialRef())), model);
  if (!toModel.possible()) {
    diagnostics.push_back(diagnose(Code::CrsTransformFailed, {}, {}, source.GetName()));
    return;
  }
  LineCollector collector(into, toModel);
  std::size_t count = 0;
  for (const auto& feature : source) {
    if (++count % kBetweenReports == 0) progress.checkpoint();
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry && (!osm || isStreetRailOrRiver(*feature))) collector.add(*geometry, kindOf(*feature));
  }
  if (const std::string taken = collector.taken(); !taken.empty()) {
    diagnostics.push_back(diagnose(Code::BarriersTaken,
                                   fmt::format("{} of layer {} of {}", taken, source.GetName(), into.name)));
  }
  if (collector.ignored() > 0) {
    diagnostics.push_back(diagnose(
        Code::LineIgnored, fmt::format("{} without two places", collector.ignored()), {}, source.GetName()));
  }
}

/// Whether any line comes as near to the buildings as their extent is wide, or within a kilometre.
bool anyNear(const std::vector<std::vector<Vec2>>& lines, const CityModel& model) {
  const Box3 extent = bounds(model);
  if (extent.empty()) return true;
  Box2 near;
  constexpr double kNear = 1000;
  const Vec2 reach = Vec2::Constant(std::max(kNear, extent.size().head<2>().maxCoeff()));
  near.add(extent.min.head<2>() - reach);
  near.add(extent.max.head<2>() + reach);
  return std::any_of(lines.begin(), lines.end(), [&](const std::vector<Vec2>& line) {
    Box2 box;
    for (const Vec2& p : line) box.add(p);
    return (box.min.array() <= near.max.array()).all() && (box.max.array() >= near.min.array()).all();
  });
}

}  // namespace

Result<LineLayer> readLines(const fs::path& path, const CityModel& model, const std::string& layer,
                            const Progress& progress) {
  std::error_code error;
  if (!fs::exists(path, error)) return diagnose(Code::FileNotFound, path.string());
  std::vector<std::string> members{virtualPath(path)};
  Result<LineLayer> result{LineLayer{path.filename().string(), {}, {}}};
  if (isArchive(path)) {
    Result<std::vector<std::string>> inside = archiveMembers(path);
    if (!inside) return Result<LineLayer>::failure(std::move(inside.diagnostics));
    members = std::move(*inside);
  }
  std::string failures;
  for (const std::string& member : members) {
    const GdalErrors errors;
    const std::string place = members.size() > 1
                                  ? path.filename().string() + "!" + fs::path(member).filename().string()
                                  : path.filename().string();
    const DatasetPtr dataset = openVector(member);
    if (!dataset) {
      failures += errors.joined();
      if (members.size() > 1) result.diagnostics.push_back(diagnose(Code::MemberSkipped, {}, {}, place));
      continue;
    }
    const bool osm = std::string_view(dataset->GetDriverName()) == "OSM";
    const Result<Layers> layers = chooseLayers(*dataset, layer, path.filename().string());
    if (!layers) return Result<LineLayer>::failure(layers.diagnostics);
    result.diagnostics.insert(result.diagnostics.end(), layers.diagnostics.begin(), layers.diagnostics.end());
    for (OGRLayer* source : *layers) {
      if (source) readLayer(*source, osm, model, *result.value, result.diagnostics, progress);
      progress.checkpoint();
    }
    if (!errors.failures().empty())
      result.diagnostics.push_back(diagnose(Code::FileTruncated, errors.joined(), {}, place));
  }
  if (!result->lines.empty()) {
    if (!anyNear(result->lines, model))
      result.diagnostics.push_back(diagnose(Code::BarriersFarAway, {}, {}, path.filename().string()));
    return result;
  }
  result.diagnostics.push_back(diagnose(Code::BarrierFileBad, failures, {}, path.filename().string()));
  return Result<LineLayer>::failure(std::move(result.diagnostics));
}

}  // namespace lodestone
