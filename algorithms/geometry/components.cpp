#include "algorithms/geometry/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include "algorithms/geometry/disjoint_sets.h"
#include "algorithms/geometry/meshing.h"
#include "model/tuple_hash.h"

namespace lodestone {
namespace {

/// The smallest vertex first, the winding kept: copies of a triangle are equal.
ComponentMesh::Triangle turnedToSmallest(ComponentMesh::Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Collects triangles object by object, welds, and sorts what it has into components.
class Builder {
 public:
  void beginObject(ComponentMesh::SourceObject object) {
    mesh_.objects.push_back(std::move(object));
    welded_.clear();
    known_.clear();
    dropped_ = 0;
  }
  /// Triangles of the object that were left out.
  [[nodiscard]] std::size_t dropped() const { return dropped_; }

  void add(const Geometry& geometry) {
    std::vector<std::uint32_t> vertexOf(geometry.vertices.size(), kNone);
    std::unordered_map<std::uint32_t, std::uint32_t>
        cornerOf;  // place in ringVertices, of the surface at hand
    std::uint32_t surface = kNone;
    std::size_t without = geometry.surfaceCount();  // surfaces of which nothing comes: no area, or not finite
    for (const LevelObject::Triangle& source : triangulate(geometry)) {
      if (source.surface != surface) {
        --without;
        surface = source.surface;
        cornersOf(geometry, surface, cornerOf);
      }
      ComponentMesh::Triangle triangle{};
      std::array<Vec2f, 3> st;
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint32_t& vertex = vertexOf[source.vertices[i]];
        if (vertex == kNone) vertex = weld(geometry.vertices[source.vertices[i]]);
        triangle[i] = vertex;
        st[i] = geometry.textureCoordinates.empty()
                    ? kNoCoordinate
                    : geometry.textureCoordinates[cornerOf.at(source.vertices[i])];
      }
      addTriangle(triangle, geometry.surfaces[surface], st);
    }
    dropped_ += without;
  }

  ComponentMesh finish() {
    const bool textured = std::any_of(mesh_.textureCoordinates.begin(), mesh_.textureCoordinates.end(),
                                      [](const auto& st) { return st[0].allFinite(); });
    if (!textured) mesh_.textureCoordinates.clear();
    DisjointSets sets(mesh_.vertexCount());
    for (const auto& [a, b, c] : mesh_.triangles) {
      (void)sets.join(a, b);
      (void)sets.join(b, c);
    }
    std::unordered_map<std::uint32_t, std::uint32_t> componentOf;
    std::vector<std::uint32_t> components;  // by triangle
    for (const auto& triangle : mesh_.triangles) {
      const auto next = static_cast<std::uint32_t>(componentOf.size());
      components.push_back(componentOf.try_emplace(sets.find(triangle[0]), next).first->second);
    }
    return sorted(components, componentOf.size());
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  inline static const Vec2f kNoCoordinate = Vec2f::Constant(std::numeric_limits<float>::quiet_NaN());

  static void cornersOf(const Geometry& geometry, std::uint32_t surface,
                        std::unordered_map<std::uint32_t, std::uint32_t>& cornerOf) {
    cornerOf.clear();
    if (geometry.textureCoordinates.empty()) return;
    const std::uint32_t begin = geometry.ringStart[geometry.surfaceStart[surface]];
    const std::uint32_t end = geometry.ringStart[geometry.surfaceStart[surface + 1]];
    for (std::uint32_t i = begin; i < end; ++i) cornerOf.emplace(geometry.ringVertices[i], i);
  }

  std::uint32_t weld(const Vec3& position) {
    const auto [found, added] = welded_.try_emplace(position, mesh_.vertexCount());
    if (added) mesh_.vertices.push_back(position);
    return found->second;
  }

  void addTriangle(const ComponentMesh::Triangle& t, const SurfaceInfo& surface,
                   const std::array<Vec2f, 3>& st) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || !known_.insert(turnedToSmallest(t)).second) {
      ++dropped_;
      return;
    }
    mesh_.triangles.push_back(t);
    mesh_.surfaces.push_back(surface);
    mesh_.textureCoordinates.push_back(st);
    objectOf_.push_back(static_cast<std::uint32_t>(mesh_.objects.size()) - 1);
  }

  /// The mesh with triangles and vertices component by component, in the order in which they came.
  ComponentMesh sorted(const std::vector<std::uint32_t>& componentOf, std::size_t count) {
    ComponentMesh result;
    result.objects = std::move(mesh_.objects);
    result.components.resize(count);
    std::vector<std::uint32_t> order(mesh_.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return componentOf[a] < componentOf[b]; });
    std::vector<std::uint32_t> vertexOf(mesh_.vertices.size(), kNone);
    for (const std::uint32_t t : order) {
      Component& component = result.components[componentOf[t]];
      if (component.triangleCount == 0) {
        component.object = objectOf_[t];
        component.firstTriangle = result.triangleCount();
        component.firstVertex = result.vertexCount();
      }
      ComponentMesh::Triangle triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint32_t& vertex = vertexOf[mesh_.triangles[t][i]];
        if (vertex == kNone) {
          vertex = result.vertexCount();
          result.vertices.push_back(mesh_.vertices[mesh_.triangles[t][i]]);
        }
        triangle[i] = vertex;
      }
      result.triangles.push_back(triangle);
      result.surfaces.push_back(mesh_.surfaces[t]);
      if (!mesh_.textureCoordinates.empty()) result.textureCoordinates.push_back(mesh_.textureCoordinates[t]);
      ++component.triangleCount;
      component.vertexCount = result.vertexCount() - component.firstVertex;
    }
    return result;
  }

  ComponentMesh mesh_;
  std::vector<std::uint32_t> objectOf_;  ///< by triangle
  std::unordered_map<Vec3, std::uint32_t, TupleHash> welded_;
  std::unordered_set<ComponentMesh::Triangle, TupleHash> known_;
  std::size_t dropped_ = 0;
};

}  // namespace

std::vector<ExteriorObject> drawnObjects(const Building& building) {
  std::vector<ExteriorObject> objects = exteriorObjects(building.object);
  if (objects.empty() && !building.footprint.empty() && building.height > 0)
    objects.push_back({&building.object, {makeBlock(building.footprint, building.base, building.height)}});
  return objects;
}

ComponentMesh makeComponentMesh(const CityModel& city, std::span<const std::uint32_t> buildings,
                                Diagnostics* diagnostics) {
  Builder builder;
  for (std::uint32_t b = 0; b < buildings.size(); ++b) {
    for (const ExteriorObject& exterior : drawnObjects(city.buildings[buildings[b]])) {
      builder.beginObject({exterior.object->id, b, exterior.geometries.front().lod});
      for (const Geometry& geometry : exterior.geometries) builder.add(geometry);
      if (diagnostics && builder.dropped() > 0)
        diagnostics->push_back(diagnose(Code::TrianglesDropped,
                                        fmt::format("{} triangles", builder.dropped()), exterior.object->id));
    }
  }
  return builder.finish();
}

}  // namespace lodestone
