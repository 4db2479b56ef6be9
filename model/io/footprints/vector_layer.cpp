#include "model/io/footprints/vector_layer.h"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <ogr_geometry.h>
#include <ogrsf_frmts.h>

namespace lodestone {
namespace {

constexpr std::array<std::string_view, 3> kIdFields{"id", "gml_id", "gml:id"};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A column of the layer, looked up once.
struct Column {
  int index;
  std::string name;
  OGRFieldType type;
  OGRFieldSubType subType;
};

std::vector<Column> columnsOf(OGRLayer& layer) {
  std::vector<Column> columns;
  OGRFeatureDefn* definition = layer.GetLayerDefn();
  for (int i = 0; i < definition->GetFieldCount(); ++i) {
    const OGRFieldDefn* field = definition->GetFieldDefn(i);
    columns.push_back({i, field->GetNameRef(), field->GetType(), field->GetSubType()});
  }
  return columns;
}

AttributeValue valueOf(const OGRFeature& feature, const Column& column) {
  switch (column.type) {
    case OFTInteger:
      if (column.subType == OFSTBoolean) return feature.GetFieldAsInteger(column.index) != 0;
      return static_cast<std::int64_t>(feature.GetFieldAsInteger(column.index));
    case OFTInteger64:
      return static_cast<std::int64_t>(feature.GetFieldAsInteger64(column.index));
    case OFTReal:
      return feature.GetFieldAsDouble(column.index);
    case OFTIntegerList:
    case OFTInteger64List:
    case OFTRealList:
    case OFTStringList: {
      char* json = feature.GetFieldAsSerializedJSon(column.index);
      JsonText text{json ? json : ""};
      CPLFree(json);
      return text;
    }
    default:
      break;
  }
  std::string text = feature.GetFieldAsString(column.index);
  if (column.subType == OFSTJSON) return JsonText{std::move(text)};
  return text;
}

Attributes attributesOf(const OGRFeature& feature, const std::vector<Column>& columns) {
  Attributes attributes;
  for (const Column& column : columns) {
    if (feature.IsFieldSetAndNotNull(column.index)) attributes.set(column.name, valueOf(feature, column));
  }
  return attributes;
}

/// Gathers polygons of any nesting, in plan and in space.
class PolygonCollector {
 public:
  void add(const OGRGeometry& geometry) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (type == wkbPolygon || type == wkbTriangle) {
      addPolygon(*geometry.toPolygon());
    } else if (OGR_GT_IsSubClassOf(type, wkbPolyhedralSurface)) {
      for (const OGRPolygon* polygon : *geometry.toPolyhedralSurface()) addPolygon(*polygon);
    } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part);
    } else if (OGR_GT_IsNonLinear(type)) {
      const std::unique_ptr<OGRGeometry> linear(geometry.getLinearGeometry());
      if (linear && !OGR_GT_IsNonLinear(linear->getGeometryType())) add(*linear);
    }
  }

  /// A surface of the model stands upright: this is a body, not an outline.
  [[nodiscard]] bool isBody() const { return walls_; }
  [[nodiscard]] bool empty() const { return plan_.empty(); }
  [[nodiscard]] Vec2 zRange() const { return range_; }
  [[nodiscard]] MultiPolygon takePlan() { return std::move(plan_); }
  [[nodiscard]] Geometry takeBody() { return std::move(body_); }

 private:
  void addPolygon(const OGRPolygon& polygon) {
    if (polygon.IsEmpty()) return;
    Polygon plan;
    const bool is3d = polygon.Is3D() != 0;
    for (const OGRLinearRing* ring : polygon) addRing(*ring, is3d, plan);
    if (is3d) {
      body_.finishSurface();
      // A wall has no area in plan but is more than a line.
      const Box2 box = bounds(plan.outer);
      const bool upright = std::abs(signedArea(plan.outer)) <= 1e-9 * box.size().squaredNorm();
      walls_ = walls_ || (upright && plan.outer.size() > 3);
    }
    plan_.push_back(std::move(plan));
  }

  void addRing(const OGRLinearRing& ring, bool is3d, Polygon& plan) {
    Ring flat;
    std::vector<Vec3> space;
    const int count = ring.getNumPoints();
    flat.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      flat.emplace_back(ring.getX(i), ring.getY(i));
      if (!is3d) continue;
      const double z = ring.getZ(i);
      space.emplace_back(ring.getX(i), ring.getY(i), z);
      range_ = {std::fmin(range_.x(), z), std::fmax(range_.y(), z)};
    }
    if (is3d) {
      if (space.size() > 1 && space.front() == space.back()) space.pop_back();
      body_.addRing(space);
    }
    if (plan.outer.empty()) {
      plan.outer = std::move(flat);
    } else {
      plan.holes.push_back(std::move(flat));
    }
  }

  MultiPolygon plan_;
  Geometry body_;
  Vec2 range_{kNone, kNone};
  bool walls_ = false;
};

struct Naming {
  LayerKind kind;
  bool ownId;  ///< the layer's feature numbers are ids of the source, not made up by GDAL
  std::string prefix;
};

// Empty when the feature has none.
std::string idOf(const OGRFeature& feature, const Attributes& attributes, const Naming& naming,
                 std::size_t index) {
  if (naming.kind == LayerKind::Osm) {
    for (const char* name : {"osm_way_id", "osm_id"}) {
      const int field = feature.GetFieldIndex(name);
      if (field >= 0 && feature.IsFieldSetAndNotNull(field)) {
        return std::string(name == std::string_view("osm_id") ? "relation/" : "way/") +
               feature.GetFieldAsString(field);
      }
    }
    return {};
  }
  // GDAL numbers GeoJSON features without an id from 0.
  const bool numbered = naming.kind == LayerKind::GeoJson && feature.GetFID() != static_cast<GIntBig>(index);
  if (naming.ownId || numbered) return fmt::format("{}", feature.GetFID());
  for (const std::string_view name : kIdFields) {
    if (auto text = attributes.text(name); text && !text->empty()) return *text;
  }
  return {};
}

// The tags of an OSM feature; none when it is no building.
bool osmAttributes(const OGRFeature& feature, Attributes& attributes, LayerFeatures& result) {
  const int tags = feature.GetFieldIndex("all_tags");
  if (tags < 0 || !feature.IsFieldSetAndNotNull(tags)) return false;
  attributes = parseTags(feature.GetFieldAsString(tags));
  const auto building = attributes.text("building");
  if (building && *building != "no") return true;
  if (attributes.find("building:part")) ++result.parts;
  return false;
}

void addFeature(const OGRFeature& feature, const std::vector<Column>& columns, const Naming& naming,
                std::size_t index, LayerFeatures& result) {
  Building building;
  if (naming.kind == LayerKind::Osm) {
    if (!osmAttributes(feature, building.object.attributes, result)) return;
  } else {
    building.object.attributes = attributesOf(feature, columns);
  }
  const OGRGeometry* geometry = feature.GetGeometryRef();
  if (!geometry || geometry->IsEmpty()) {
    ++result.withoutGeometry;
    return;
  }
  PolygonCollector polygons;
  polygons.add(*geometry);
  if (polygons.empty()) {
    ++result.otherGeometry;
    return;
  }
  building.object.type = ObjectType::Building;
  building.object.id = idOf(feature, building.object.attributes, naming, index);
  if (building.object.id.empty()) {
    building.object.id = naming.prefix + fmt::format("{}", index);
    ++result.withoutId;
  }
  result.zRange.push_back(polygons.zRange());
  if (polygons.isBody()) {
    building.object.geometries.push_back(polygons.takeBody());
  } else {
    building.footprint = polygons.takePlan();
  }
  result.buildings.push_back(std::move(building));
}

}  // namespace

Attributes parseTags(std::string_view hstore) {
  Attributes attributes;
  std::size_t at = 0;
  const auto quoted = [&]() {
    std::string text;
    at = std::min(hstore.find('"', at), hstore.size());
    for (++at; at < hstore.size() && hstore[at] != '"'; ++at) {
      if (hstore[at] == '\\' && at + 1 < hstore.size()) ++at;
      text += hstore[at];
    }
    ++at;
    return text;
  };
  while (at < hstore.size()) {
    const std::string key = quoted();
    const bool complete = at < hstore.size();
    const std::string value = quoted();
    if (complete && !key.empty()) attributes.set(key, value);
  }
  return attributes;
}

LayerFeatures readFeatures(OGRLayer& layer, LayerKind kind, const std::string& idPrefix,
                           const Progress& progress) {
  constexpr std::size_t kBetweenReports = 1024;
  LayerFeatures result;
  const bool osm = kind == LayerKind::Osm;
  const std::vector<Column> columns = osm ? std::vector<Column>() : columnsOf(layer);
  const Naming naming{kind, !osm && *layer.GetFIDColumn() != '\0', idPrefix};
  const GIntBig expected = osm ? -1 : layer.GetFeatureCount(FALSE);
  // Headers may lie about their counts.
  constexpr GIntBig kReserveAtMost = 1 << 20;
  if (expected > 0) result.buildings.reserve(static_cast<std::size_t>(std::min(expected, kReserveAtMost)));
  std::size_t index = 0;
  for (const auto& feature : layer) {
    addFeature(*feature, columns, naming, index, result);
    if (++index % kBetweenReports != 0) continue;
    progress.checkpoint();
    if (expected > 0)
      progress.report(std::min(1.0, static_cast<double>(index) / static_cast<double>(expected)));
  }
  return result;
}

}  // namespace lodestone
