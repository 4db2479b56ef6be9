#include "gui/view3d/pane_model.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

#include "algorithms/geometry/mesh_edges.h"
#include "algorithms/simplification/vertex_account.h"
#include "gui/view3d/component_colours.h"

namespace lodestone {
namespace {

/// Faces that bend more than this have a line between them where they are ghosts.
constexpr double kCreaseCosine = 0.94;  // 20°
/// The city's shader darkens walls up to 14 m above the ground: here up to a third of the building.
constexpr double kDarkFoot = 14;
constexpr double kDarkShare = 0.33;

MeshBox boxOf(const NodeMesh& nodes, std::size_t firstVertex) {
  MeshBox box;
  if (firstVertex == nodes.vertices.size()) return box;
  box.min =
      box.max = {nodes.vertices[firstVertex].x, nodes.vertices[firstVertex].y, nodes.vertices[firstVertex].z};
  for (std::size_t v = firstVertex; v < nodes.vertices.size(); ++v) {
    const std::array<float, 3> p{nodes.vertices[v].x, nodes.vertices[v].y, nodes.vertices[v].z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::min(box.min[axis], p[axis]);
      box.max[axis] = std::max(box.max[axis], p[axis]);
    }
  }
  return box;
}

NodeMesh nodesOf(const ComponentMesh& mesh, const std::vector<std::uint32_t>& component, std::size_t count,
                 const Vec3& anchor, double base, double height) {
  NodeMesh nodes;
  nodes.anchor = anchor;
  nodes.ranges.resize(count);
  nodes.boxes.resize(count);
  const double rise = height > 0 ? kDarkFoot / (kDarkShare * height) : 0;
  for (std::size_t c = 0; c < mesh.components.size(); ++c) {
    const Component& own = mesh.components[c];
    const std::uint32_t node = component[c];
    const std::size_t firstVertex = nodes.vertices.size();
    const auto firstIndex = static_cast<std::uint32_t>(nodes.indices.size());
    for (std::uint32_t v = own.firstVertex; v < own.endVertex(); ++v) {
      const Vec3f p = (mesh.vertices[v] - anchor).cast<float>();
      const double above = std::clamp((mesh.vertices[v].z() - base) * rise, 0.0, 255.0);
      nodes.vertices.push_back({p.x(), p.y(), p.z(), node << 8U | static_cast<std::uint32_t>(above)});
    }
    for (std::uint32_t t = own.firstTriangle; t < own.endTriangle(); ++t) {
      for (const std::uint32_t corner : mesh.triangles[t])
        nodes.indices.push_back(static_cast<std::uint32_t>(firstVertex) + corner - own.firstVertex);
    }
    nodes.ranges[node] = {firstIndex, static_cast<std::uint32_t>(nodes.indices.size()) - firstIndex};
    nodes.boxes[node] = boxOf(nodes, firstVertex);
  }
  return nodes;
}

bool isCrease(const ComponentMesh& mesh, std::span<const std::uint32_t> triangles) {
  if (triangles.size() != 2) return true;
  const Vec3 a = areaNormal(mesh, triangles[0]).normalized();
  const Vec3 b = areaNormal(mesh, triangles[1]).normalized();
  return std::abs(a.dot(b)) < kCreaseCosine;  // neighbours may be wound differently
}

void addCreases(PaneModel& model, std::size_t count) {
  const ComponentMesh& mesh = *model.mesh;
  const MeshEdges edges = makeEdges(mesh);
  model.creaseStart.assign(1, 0);
  std::size_t next = 0;  // components of a simplified mesh ascend in the original's numbers
  for (std::uint32_t c = 0; c < count; ++c) {
    if (next < model.component.size() && model.component[next] == c) {
      for (std::uint32_t e = edges.firstEdge[next]; e < edges.firstEdge[next + 1]; ++e) {
        if (isCrease(mesh, edges.trianglesOf(e)))
          model.creases.push_back({mesh.vertices[edges.ends[e][0]], mesh.vertices[edges.ends[e][1]]});
      }
      ++next;
    }
    model.creaseStart.push_back(static_cast<std::uint32_t>(model.creases.size()));
  }
}

void addAngles(PaneModel& model, const Classification& classes) {
  for (const BoundaryEdge& edge : classes.edges) {
    const ComponentMesh& mesh = *model.mesh;
    model.angles.add(mesh.vertices[edge.from], mesh.vertices[edge.to],
                     angleColour(boundaryAngle(mesh, edge)));
    model.angleComponent.push_back(componentOfVertex(mesh, edge.from));
  }
}

}  // namespace

std::shared_ptr<const PaneModel> makePaneModel(std::shared_ptr<const ComponentMesh> mesh,
                                               const Classification* classes) {
  auto model = std::make_shared<PaneModel>();
  model->mesh = std::move(mesh);
  const std::size_t count = model->mesh->components.size();
  model->component.resize(count);
  std::iota(model->component.begin(), model->component.end(), 0U);
  model->vertex.resize(model->mesh->vertices.size());
  std::iota(model->vertex.begin(), model->vertex.end(), 0U);
  const Box3 box = bounds(*model->mesh);
  model->nodes = std::make_shared<const NodeMesh>(nodesOf(*model->mesh, model->component, count,
                                                          box.empty() ? Vec3::Zero().eval() : box.center(),
                                                          box.empty() ? 0 : box.min.z(), box.size().z()));
  addCreases(*model, count);
  if (classes) {
    model->classes = classes->vertices;
    addAngles(*model, *classes);
  }
  return model;
}

std::shared_ptr<const PaneModel> makePaneModel(std::shared_ptr<const ComponentMesh> mesh,
                                               std::vector<std::uint32_t> component,
                                               std::vector<std::uint32_t> vertex, const PaneModel& original) {
  auto model = std::make_shared<PaneModel>();
  model->mesh = std::move(mesh);
  model->component = std::move(component);
  model->vertex = std::move(vertex);
  const Box3 box = bounds(*original.mesh);
  const std::size_t count = original.mesh->components.size();
  model->nodes =
      std::make_shared<const NodeMesh>(nodesOf(*model->mesh, model->component, count, original.nodes->anchor,
                                               box.empty() ? 0 : box.min.z(), box.size().z()));
  addCreases(*model, count);
  for (const std::uint32_t v : model->vertex) {
    if (v < original.classes.size()) model->classes.push_back(original.classes[v]);
  }
  return model;
}

}  // namespace lodestone
