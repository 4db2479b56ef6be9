#include "model/city_summary.h"

#include <algorithm>
#include <numeric>

namespace lodestone {
namespace {

/// For each vertex the first one (in index order of equal positions) that stands at the same place.
std::vector<std::uint32_t> weldedVertices(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    return std::tuple(vertices[i].x(), vertices[i].y(), vertices[i].z());
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

std::uint32_t findRoot(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void count(const Geometry& geometry, CitySummary& summary) {
  ++summary.lods[geometry.lod];
  summary.surfaces += geometry.surfaceCount();
  for (std::size_t s = 0; s < geometry.surfaceCount(); ++s) {
    const std::uint32_t begin = geometry.surfaceStart[s];
    const std::uint32_t end = geometry.surfaceStart[s + 1];
    const std::size_t corners = geometry.ringStart[end] - geometry.ringStart[begin];
    if (end > begin && corners >= 3) summary.triangles += corners - 2 + 2 * (end - begin - 1);
    if (geometry.surfaces[s].texture >= 0) ++summary.texturedSurfaces;
  }
  summary.components += componentCount(geometry);
}

void count(const CityObject& top, CitySummary& summary) {
  forEachObject(top, [&](const CityObject& object) {
    ++summary.objects[toString(object.type)];
    if (object.type == ObjectType::BuildingPart) ++summary.parts;
    for (const Geometry& geometry : object.geometries) count(geometry, summary);
  });
}

}  // namespace

std::size_t componentCount(const Geometry& geometry) {
  std::vector<std::uint32_t> parent = weldedVertices(geometry.vertices);
  std::vector<bool> used(parent.size(), false);
  for (std::size_t s = 0; s < geometry.surfaceCount(); ++s) {
    const std::uint32_t begin = geometry.ringStart[geometry.surfaceStart[s]];
    const std::uint32_t end = geometry.ringStart[geometry.surfaceStart[s + 1]];
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t a = findRoot(parent, geometry.ringVertices[begin]);
      const std::uint32_t b = findRoot(parent, geometry.ringVertices[i]);
      used[a] = used[b] = true;
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::size_t roots = 0;
  for (std::uint32_t i = 0; i < parent.size(); ++i) roots += parent[i] == i && used[i] ? 1 : 0;
  return roots;
}

CitySummary summarise(const CityModel& model) {
  CitySummary summary;
  summary.buildings = model.buildings.size();
  for (const Building& building : model.buildings) {
    count(building.object, summary);
    ++summary.heights[toString(building.heightSource)];
    if (!building.footprint.empty()) ++summary.withFootprint;
    for (const Polygon& polygon : building.footprint) {
      summary.groundVertices += polygon.outer.size();
      for (const Ring& hole : polygon.holes) summary.groundVertices += hole.size();
    }
    for (const auto& [name, value] : building.object.attributes) ++summary.attributes[name];
  }
  for (const CityObject& object : model.others) count(object, summary);
  summary.textures = model.textures.size();
  summary.texturesMissing = static_cast<std::size_t>(std::count_if(
      model.textures.begin(), model.textures.end(), [](const Texture& t) { return t.missing; }));
  summary.materials = model.materials.size();
  summary.extent = bounds(model);
  return summary;
}

}  // namespace lodestone
