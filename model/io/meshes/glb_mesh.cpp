#include "model/io/meshes/glb_mesh.h"

#include <cmath>
#include <map>

#include <Eigen/Geometry>

namespace lodestone {
namespace {

/// Cosine of the angle between a triangle and its surface from which on it gets a normal of its own.
constexpr double kPlanar = 0.999;

Vec3f yUp(const Vec3& p) {
  return Vec3(p.x(), p.z(), -p.y()).cast<float>();
}

/// The kinds of surface that are coloured differently.
SurfaceType shownType(SurfaceType type) {
  switch (type) {
    case SurfaceType::Roof:
    case SurfaceType::Ground:
    case SurfaceType::OuterCeiling:
    case SurfaceType::Window:
    case SurfaceType::Door:
      return type;
    default:
      return SurfaceType::Wall;
  }
}

class MeshMaker {
 public:
  MeshMaker(const Vec3& origin, const std::vector<bool>& usableTextures)
      : origin_(origin), usable_(usableTextures) {}

  void add(const LevelObject& object, std::size_t feature) {
    feature_ = static_cast<float>(feature);
    role_ = object.role;
    for (std::size_t g = 0; g < object.geometries.size(); ++g) {
      const auto& triangles = object.triangles[g];
      for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
        while (end < triangles.size() && triangles[end].surface == triangles[begin].surface) ++end;
        addSurface(object.geometries[g], {triangles.data() + begin, end - begin});
      }
    }
  }

  std::vector<GlbPrimitive> take() {
    std::vector<GlbPrimitive> primitives;
    for (auto& [key, primitive] : primitives_) {
      primitive.material = key;
      primitives.push_back(std::move(primitive));
    }
    return primitives;
  }

 private:
  using Triangles = std::span<const LevelObject::Triangle>;

  void addSurface(const Geometry& geometry, Triangles triangles) {
    const std::uint32_t surface = triangles.front().surface;
    findCorners(geometry, surface);
    GlbPrimitive& primitive = primitives_[keyOf(geometry, surface)];
    textured_ = !geometry.textureCoordinates.empty() && keyOf(geometry, surface).texture >= 0;
    if (primitive.features.empty() || primitive.features.back() != feature_) ++primitive.featureCount;

    Vec3 sum = Vec3::Zero();
    for (const auto& t : triangles) sum += twiceArea(geometry, t);
    const Vec3 normal = sum.norm() > 0 ? sum.normalized() : Vec3::UnitZ().eval();
    vertexOf_.clear();
    for (const auto& t : triangles) {
      const Vec3 own = twiceArea(geometry, t);
      const bool flat = own.norm() <= 0 || own.normalized().dot(normal) >= kPlanar;
      for (std::uint32_t v : t.vertices) {
        primitive.indices.push_back(flat ? sharedVertex(primitive, geometry, v, normal)
                                         : addVertex(primitive, geometry, v, own.normalized()));
      }
    }
  }

  static Vec3 twiceArea(const Geometry& geometry, const LevelObject::Triangle& t) {
    const Vec3& a = geometry.vertices[t.vertices[0]];
    return (geometry.vertices[t.vertices[1]] - a).cross(geometry.vertices[t.vertices[2]] - a);
  }

  /// Where each vertex of the surface stands among the ring vertices, which texture coordinates go by.
  void findCorners(const Geometry& geometry, std::uint32_t surface) {
    cornerOf_.clear();
    if (geometry.textureCoordinates.empty()) return;
    const std::uint32_t begin = geometry.ringStart[geometry.surfaceStart[surface]];
    const std::uint32_t end = geometry.ringStart[geometry.surfaceStart[surface + 1]];
    for (std::uint32_t i = begin; i < end; ++i) cornerOf_.emplace(geometry.ringVertices[i], i);
  }

  [[nodiscard]] bool hasCoordinates(const Geometry& geometry) const {
    if (cornerOf_.empty()) return false;
    for (const auto& [vertex, corner] : cornerOf_) {
      if (!geometry.textureCoordinates[corner].allFinite()) return false;
    }
    return true;
  }

  [[nodiscard]] GlbMaterialKey keyOf(const Geometry& geometry, std::uint32_t surface) const {
    const SurfaceInfo& info = geometry.surfaces[surface];
    const bool textured = info.texture >= 0 && static_cast<std::size_t>(info.texture) < usable_.size() &&
                          usable_[static_cast<std::size_t>(info.texture)] && hasCoordinates(geometry);
    if (textured) return {DrawRole::Building, SurfaceType::Unknown, -1, info.texture};
    if (info.material >= 0) return {DrawRole::Building, SurfaceType::Unknown, info.material, -1};
    return {role_, shownType(info.type), -1, -1};
  }

  std::uint32_t sharedVertex(GlbPrimitive& primitive, const Geometry& geometry, std::uint32_t v,
                             const Vec3& normal) {
    const auto [found, isNew] = vertexOf_.emplace(v, static_cast<std::uint32_t>(primitive.positions.size()));
    if (isNew) addVertex(primitive, geometry, v, normal);
    return found->second;
  }

  std::uint32_t addVertex(GlbPrimitive& primitive, const Geometry& geometry, std::uint32_t v,
                          const Vec3& normal) {
    primitive.positions.push_back(yUp(geometry.vertices[v] - origin_));
    primitive.normals.push_back(yUp(normal));
    primitive.features.push_back(feature_);
    if (textured_) {
      const Vec2f& st = geometry.textureCoordinates[cornerOf_.at(v)];
      primitive.textureCoordinates.emplace_back(st.x(), 1 - st.y());  // glTF counts rows from the top
    }
    return static_cast<std::uint32_t>(primitive.positions.size() - 1);
  }

  Vec3 origin_;
  const std::vector<bool>& usable_;
  std::map<GlbMaterialKey, GlbPrimitive> primitives_;
  std::map<std::uint32_t, std::uint32_t> cornerOf_;  // ring vertex by vertex, of the surface at hand
  std::map<std::uint32_t, std::uint32_t> vertexOf_;  // primitive's vertex by vertex, likewise
  float feature_ = 0;
  DrawRole role_ = DrawRole::Building;
  bool textured_ = false;
};

}  // namespace

GlbMesh makeGlbMesh(std::span<const LevelObject> objects, std::size_t firstFeature,
                    const std::vector<bool>& usableTextures) {
  GlbMesh mesh;
  Box3 box;
  for (const LevelObject& object : objects) {
    for (const Geometry& geometry : object.geometries) {
      for (const Vec3& p : geometry.vertices) box.add(p);
    }
  }
  if (!box.empty()) mesh.origin = box.center().array().round();
  MeshMaker maker(mesh.origin, usableTextures);
  for (std::size_t i = 0; i < objects.size(); ++i) maker.add(objects[i], firstFeature + i);
  mesh.primitives = maker.take();
  return mesh;
}

}  // namespace lodestone
