#include "algorithms/simplification/city_classification.h"

#include "algorithms/geometry/components.h"
#include "algorithms/geometry/parallel.h"
#include "algorithms/simplification/city_simplification.h"
#include "algorithms/simplification/classification.h"

namespace lodestone {
namespace {

struct Group {
  ComponentMesh mesh;
  Classification classes;
  Diagnostics diagnostics;
};

template <class Item>
void append(std::vector<Item>& all, const std::vector<Item>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// How much a group's own numbers grow by where they stand.
struct Offsets {
  explicit Offsets(const ComponentMesh& all)
      : object(static_cast<std::uint32_t>(all.objects.size())),
        component(static_cast<std::uint32_t>(all.components.size())),
        vertex(all.vertexCount()),
        triangle(all.triangleCount()) {}
  [[nodiscard]] ComponentMesh::Triangle moved(ComponentMesh::Triangle corners) const {
    for (std::uint32_t& corner : corners) corner += vertex;
    return corners;
  }
  std::uint32_t object, component, vertex, triangle;
};

void append(ComponentMesh& all, ComponentMesh group, const std::vector<std::uint32_t>& buildings,
            const Offsets& by) {
  for (ComponentMesh::SourceObject& object : group.objects) object.building = buildings[object.building];
  for (Component& component : group.components) {
    component.object += by.object;
    component.firstVertex += by.vertex;
    component.firstTriangle += by.triangle;
  }
  append(all.objects, group.objects);
  append(all.components, group.components);
  append(all.vertices, group.vertices);
  for (const ComponentMesh::Triangle& triangle : group.triangles) all.triangles.push_back(by.moved(triangle));
  append(all.surfaces, group.surfaces);
}

void append(Classification& all, const Classification& group, const Offsets& by) {
  append(all.vertices, group.vertices);
  const std::uint32_t planes = all.planeStart.back();
  for (std::size_t v = 1; v < group.planeStart.size(); ++v)
    all.planeStart.push_back(planes + group.planeStart[v]);
  for (const std::uint32_t plane : group.planes) all.planes.push_back(by.triangle + plane);
  for (BoundaryEdge edge : group.edges) {
    edge.from += by.vertex;
    edge.to += by.vertex;
    edge.other += by.component;
    for (std::uint32_t& triangle : edge.triangles) triangle += by.triangle;
    all.edges.push_back(std::move(edge));
  }
  for (const ComponentMesh::Triangle& fill : group.fill) all.fill.push_back(by.moved(fill));
  for (const auto& [a, b] : group.contacts) all.contacts.emplace_back(by.component + a, by.component + b);
}

}  // namespace

Result<ClassifiedCity> classifyCity(const CityModel& city, double gap, const Progress& progress) {
  const auto buildings = touchingBuildings(city, 0.01, progress.part(0, 0.3, "touching buildings"));
  std::vector<Group> groups(buildings.size());
  const Progress silent({}, progress.stopToken());
  forPiecesReported(groups.size(), 1, progress.part(0.3, 1, "classify"),
                    [&](std::size_t first, std::size_t last) {
                      for (std::size_t g = first; g < last; ++g) {
                        try {
                          groups[g].mesh = makeComponentMesh(city, buildings[g], &groups[g].diagnostics);
                          groups[g].classes = classify(groups[g].mesh, gap, silent);
                        } catch (const Cancelled&) {  // stays in this thread: said at the checkpoint below
                        }
                      }
                    });
  progress.checkpoint();
  Result<ClassifiedCity> result{ClassifiedCity{}};
  result->classes.gap = gap;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Offsets by(result->mesh);
    append(result->classes, groups[g].classes, by);
    append(result->mesh, std::move(groups[g].mesh), buildings[g], by);
    append(result.diagnostics, groups[g].diagnostics);
  }
  return result;
}

}  // namespace lodestone
