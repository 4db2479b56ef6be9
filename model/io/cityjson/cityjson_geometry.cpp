#include "model/io/cityjson/cityjson_geometry.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace lodestone {
namespace {

constexpr std::uint32_t kUnseen = 0xFFFFFFFFU;
const Vec2f kNoTexture = Vec2f::Constant(std::numeric_limits<float>::quiet_NaN());

struct NamedKind {
  std::string_view name;
  GeometryKind kind;
};
constexpr NamedKind kKinds[] = {
    {"MultiSurface", GeometryKind::MultiSurface},
    {"CompositeSurface", GeometryKind::CompositeSurface},
    {"Solid", GeometryKind::Solid},
    {"MultiSolid", GeometryKind::MultiSolid},
    {"CompositeSolid", GeometryKind::CompositeSolid},
    {"MultiLineString", GeometryKind::MultiCurve},
    {"MultiPoint", GeometryKind::MultiPoint},
};

std::string lodOf(const JsonObject& json) {
  const auto lod = member(json, "lod");
  if (const auto text = as<std::string_view>(lod)) return std::string(*text);
  if (const auto number = numberOf(lod)) return fmt::format("{}", *number);  // CityJSON 1.0 and before
  return {};
}

std::size_t fewestVertices(GeometryKind kind) {
  if (kind == GeometryKind::MultiPoint) return 1;
  return kind == GeometryKind::MultiCurve ? 2 : 3;
}

// A mirrored template would show its inside: its rings are turned.
void reverseRings(Geometry& geometry) {
  for (std::size_t r = 0; r < geometry.ringCount(); ++r) {
    const auto turn = [&](auto& values) {
      if (!values.empty()) {
        std::reverse(values.begin() + geometry.ringStart[r], values.begin() + geometry.ringStart[r + 1]);
      }
    };
    turn(geometry.ringVertices);
    turn(geometry.textureCoordinates);
  }
}

}  // namespace

void ObjectDiagnostics::flush(const std::string& object, Diagnostics& diagnostics) {
  for (const auto& [what, count] : found_) {
    std::string detail = what.second;
    if (count > 1) detail += fmt::format("{}{} times", detail.empty() ? "" : ", ", count);
    diagnostics.push_back(diagnose(what.first, std::move(detail), object));
  }
  found_.clear();
}

/// What stands beside the boundaries, at the same depth of nesting.
struct CityJsonGeometryReader::SurfaceSides {
  std::optional<JsonElement> semantics, materials, textures;
  std::optional<JsonElement> oneMaterial;  ///< for all surfaces
};

CityJsonGeometryReader::CityJsonGeometryReader(const CityJsonContext& context)
    : context_(context), localOf_(context.vertices.size(), kUnseen) {}

Geometry CityJsonGeometryReader::read(const JsonObject& json, ObjectDiagnostics& said) {
  said_ = &said;
  geometry_ = {};
  textured_ = false;
  const auto type = memberAs<std::string_view>(json, "type").value_or("");
  if (type == "GeometryInstance") return readInstance(json);
  const auto* named =
      std::find_if(std::begin(kKinds), std::end(kKinds), [&](const NamedKind& k) { return k.name == type; });
  if (named == std::end(kKinds)) {
    said.add(Code::GeometryUnsupported, fmt::format("type \"{}\"", type));
    return {};
  }
  geometry_.kind = named->kind;
  geometry_.lod = lodOf(json);
  const auto semantics = memberAs<JsonObject>(json, "semantics");
  readSemantics(semantics);
  const auto material = themeOf(member(json, "material"), context_.appearance.materialTheme);
  const auto texture = themeOf(member(json, "texture"), context_.appearance.textureTheme);
  const SurfaceSides sides{semantics ? member(*semantics, "values") : std::nullopt,
                           material ? member(*material, "values") : std::nullopt,
                           texture ? member(*texture, "values") : std::nullopt,
                           material ? member(*material, "value") : std::nullopt};
  const auto boundaries = member(json, "boundaries");
  if (geometry_.kind == GeometryKind::Solid) {
    readSolid(boundaries, sides);
  } else if (geometry_.isSolid()) {
    readSolids(boundaries, sides);
  } else {
    readShell(boundaries, sides);
  }
  for (const std::uint32_t index : used_) localOf_[index] = kUnseen;
  used_.clear();
  if (!textured_) geometry_.textureCoordinates.clear();
  if (geometry_.surfaces.empty()) said.add(Code::GeometryEmpty, std::string(type));
  return std::move(geometry_);
}

void CityJsonGeometryReader::readSemantics(const std::optional<JsonObject>& semantics) {
  types_.clear();
  if (!semantics) return;
  JsonBeside surfaces(member(*semantics, "surfaces"));
  while (const auto surface = surfaces.next()) {
    const auto object = as<JsonObject>(*surface);
    const auto type = object ? memberAs<std::string_view>(*object, "type") : std::nullopt;
    std::string_view name = type.value_or("");
    if (name == "+GenericSurface") name.remove_prefix(1);
    types_.push_back(surfaceTypeFrom(name));
  }
}

void CityJsonGeometryReader::readSolids(const std::optional<JsonElement>& boundaries,
                                        const SurfaceSides& sides) {
  JsonBeside solids(boundaries), semantics(sides.semantics), materials(sides.materials),
      textures(sides.textures);
  while (const auto solid = solids.next()) {
    readSolid(solid, {semantics.next(), materials.next(), textures.next(), sides.oneMaterial});
  }
}

void CityJsonGeometryReader::readSolid(const std::optional<JsonElement>& boundaries,
                                       const SurfaceSides& sides) {
  JsonBeside shells(boundaries), semantics(sides.semantics), materials(sides.materials),
      textures(sides.textures);
  if (geometry_.shellStart.empty()) geometry_.shellStart.push_back(0);
  if (geometry_.solidStart.empty()) geometry_.solidStart.push_back(0);
  while (const auto shell = shells.next()) {
    readShell(shell, {semantics.next(), materials.next(), textures.next(), sides.oneMaterial});
    const auto end = static_cast<std::uint32_t>(geometry_.surfaceCount());
    if (end > geometry_.shellStart.back()) geometry_.shellStart.push_back(end);
  }
  const auto end = static_cast<std::uint32_t>(geometry_.shellStart.size() - 1);
  if (end > geometry_.solidStart.back()) geometry_.solidStart.push_back(end);
}

void CityJsonGeometryReader::readShell(const std::optional<JsonElement>& boundaries,
                                       const SurfaceSides& sides) {
  if (!as<JsonArray>(boundaries))
    said_->add(Code::GeometryUnsupported, "boundaries are not nested as its type asks");
  JsonBeside surfaces(boundaries), semantics(sides.semantics), materials(sides.materials),
      textures(sides.textures);
  while (const auto surface = surfaces.next()) {
    readSurface(*surface, {semantics.next(), materials.next(), textures.next(), sides.oneMaterial});
  }
}

void CityJsonGeometryReader::readSurface(const JsonElement& element, const SurfaceSides& sides) {
  indices_.clear();
  uvs_.clear();
  ringEnds_.clear();
  surfaceTexture_ = -1;
  if (geometry_.kind == GeometryKind::MultiPoint || geometry_.kind == GeometryKind::MultiCurve) {
    if (!collectRing(element, std::nullopt, true)) return;
  } else {
    const auto rings = as<JsonArray>(element);
    if (!rings || rings->size() == 0) {
      said_->add(Code::GeometryUnsupported, "boundaries are not nested as its type asks");
      return;
    }
    JsonBeside textures(sides.textures);
    for (const JsonElement ring : *rings) {
      if (!collectRing(ring, textures.next(), ringEnds_.empty())) return;
    }
  }
  appendCollected(infoOf(sides));
}

/// False: the whole surface must be left out.
bool CityJsonGeometryReader::collectRing(const std::optional<JsonElement>& ring,
                                         const std::optional<JsonElement>& texture, bool first) {
  const std::size_t begin = indices_.size();
  std::vector<std::size_t> places;  // in the source's ring, for the texture coordinates
  std::size_t place = 0;
  const auto take = [&](const std::optional<JsonElement>& element) {
    const auto index = indexOf(element);
    if (!index || *index >= context_.vertices.size()) {
      said_->add(Code::IndexOutOfRange, "vertex of a ring");
      return false;
    }
    if (!context_.vertices[*index].allFinite()) {
      said_->add(Code::CoordinateBad, "vertex of a ring");
      return false;
    }
    if (indices_.size() == begin || indices_.back() != *index) {
      indices_.push_back(*index);
      places.push_back(place);
    }
    ++place;
    return true;
  };
  if (const auto list = as<JsonArray>(ring)) {
    for (const JsonElement element : *list) {
      if (!take(element)) return false;
    }
  } else if (geometry_.kind != GeometryKind::MultiPoint) {
    said_->add(Code::GeometryUnsupported, "boundaries are not nested as its type asks");
    return false;
  } else if (!take(ring)) {
    return false;
  }
  const bool closes =
      geometry_.kind != GeometryKind::MultiPoint && geometry_.kind != GeometryKind::MultiCurve;
  while (closes && indices_.size() > begin + 1 && indices_.back() == indices_[begin]) {
    indices_.pop_back();
    places.pop_back();
  }
  if (indices_.size() - begin < fewestVertices(geometry_.kind)) {
    indices_.resize(begin);
    said_->add(first ? Code::RingTooShort : Code::HoleDropped, {});
    return !first;
  }
  uvs_.resize(indices_.size(), kNoTexture);
  if (texture) collectTexture(*texture, begin, place, places);
  ringEnds_.push_back(indices_.size());
  return true;
}

/// `texture`: the texture's index and one texture vertex for each of the ring's `count` vertices as the
/// source has them.
void CityJsonGeometryReader::collectTexture(const JsonElement& texture, std::size_t begin, std::size_t count,
                                            const std::vector<std::size_t>& places) {
  JsonBeside values{texture};
  const auto index = values.next();
  if (!index || index->is_null()) return;
  const auto entry = indexOf(index);
  if (!entry || *entry >= context_.appearance.textures.size()) {
    said_->add(Code::TextureBad, "no such texture");
    return;
  }
  std::vector<Vec2f> coordinates;
  while (const auto value = values.next()) {
    const auto vertex = indexOf(value);
    if (!vertex || *vertex >= context_.appearance.textureVertices.size()) {
      said_->add(Code::TextureBad, "no such texture vertex");
      return;
    }
    coordinates.push_back(context_.appearance.textureVertices[*vertex]);
  }
  if (coordinates.size() != count) {
    said_->add(Code::TextureBad, "not as many as vertices");
    return;
  }
  for (std::size_t i = 0; i < places.size(); ++i) uvs_[begin + i] = coordinates[places[i]];
  surfaceTexture_ = context_.appearance.textures[*entry];
  textured_ = true;
}

void CityJsonGeometryReader::appendCollected(SurfaceInfo info) {
  std::size_t next = 0;
  for (const std::uint32_t index : indices_) {
    if (localOf_[index] == kUnseen) {
      localOf_[index] = static_cast<std::uint32_t>(geometry_.vertices.size());
      geometry_.vertices.push_back(context_.vertices[index]);
      used_.push_back(index);
    }
    geometry_.ringVertices.push_back(localOf_[index]);
    geometry_.textureCoordinates.push_back(uvs_[next++]);
  }
  const auto base = geometry_.ringStart.back();
  for (const std::size_t end : ringEnds_)
    geometry_.ringStart.push_back(base + static_cast<std::uint32_t>(end));
  info.texture = surfaceTexture_;
  geometry_.finishSurface(info);
}

SurfaceInfo CityJsonGeometryReader::infoOf(const SurfaceSides& sides) {
  SurfaceInfo info;
  if (sides.semantics && !sides.semantics->is_null()) {
    const auto index = indexOf(sides.semantics);
    if (index && *index < types_.size()) {
      info.type = types_[*index];
    } else {
      said_->add(Code::SemanticsBad, {});
    }
  }
  const auto& material = sides.oneMaterial ? sides.oneMaterial : sides.materials;
  if (material && !material->is_null()) {
    const auto index = indexOf(material);
    if (index && *index < context_.appearance.materials.size()) {
      info.material = context_.appearance.materials[*index];
    } else {
      said_->add(Code::AppearanceBad, "no such material");
    }
  }
  return info;
}

Geometry CityJsonGeometryReader::readInstance(const JsonObject& json) {
  const auto number = indexOf(member(json, "template"));
  const auto* templates = context_.templates;
  if (!number || !templates || *number >= templates->size() || (*templates)[*number].surfaces.empty()) {
    said_->add(Code::TemplateMissing, {});
    return {};
  }
  if (context_.placed && context_.placed->full()) {
    said_->add(Code::CountImplausible, PlacedTemplates::kTooOften);
    return {};
  }
  JsonBeside boundaries(member(json, "boundaries"));
  const auto point = indexOf(boundaries.next());
  if (!point || *point >= context_.vertices.size()) {
    said_->add(Code::IndexOutOfRange, "reference point of a template");
    return {};
  }
  std::array<double, 16> m{};
  JsonBeside values(member(json, "transformationMatrix"));
  for (double& value : m) value = numberOf(values.next()).value_or(std::numeric_limits<double>::quiet_NaN());
  Geometry geometry = (*templates)[*number];
  if (context_.placed) context_.placed->add(geometry.vertices.size());
  const Vec3& at = context_.vertices[*point];
  for (Vec3& v : geometry.vertices) {
    v = at + Vec3(m[0] * v.x() + m[1] * v.y() + m[2] * v.z() + m[3],
                  m[4] * v.x() + m[5] * v.y() + m[6] * v.z() + m[7],
                  m[8] * v.x() + m[9] * v.y() + m[10] * v.z() + m[11]);
    if (!v.allFinite()) {
      said_->add(Code::CoordinateBad, "matrix or reference point of a template");
      return {};
    }
  }
  const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
                             m[2] * (m[4] * m[9] - m[5] * m[8]);
  if (determinant < 0) reverseRings(geometry);
  return geometry;
}

}  // namespace lodestone
