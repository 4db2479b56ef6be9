#include "gui/view3d/city_mesh.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "gui/view3d/mesh_writer.h"
#include "model/exterior.h"

namespace lodestone {
namespace {

// Nodes a piece: large enough to keep threads from meeting, small enough to share the work evenly.
constexpr std::size_t kPiece = 512;

/// Joins the pieces in order, in parallel: the same arrays for any number of threads.
NodeMesh join(std::vector<MeshWriter>& pieces, NodeId firstNode, const Vec3& anchor) {
  struct Offset {
    std::size_t vertex = 0, index = 0, node = 0;
  };
  std::vector<Offset> offsets(pieces.size() + 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    offsets[i + 1] = {offsets[i].vertex + pieces[i].vertices.size(),
                      offsets[i].index + pieces[i].indices.size(), offsets[i].node + pieces[i].ranges.size()};
  }
  NodeMesh mesh;
  mesh.firstNode = firstNode;
  mesh.anchor = anchor;
  mesh.vertices.resize(offsets.back().vertex);
  mesh.indices.resize(offsets.back().index);
  mesh.ranges.resize(offsets.back().node);
  mesh.boxes.resize(offsets.back().node);
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    const Offset& to = offsets[i];
    MeshWriter& piece = pieces[i];
    std::copy(piece.vertices.begin(), piece.vertices.end(),
              mesh.vertices.begin() + static_cast<std::ptrdiff_t>(to.vertex));
    std::copy(piece.boxes.begin(), piece.boxes.end(),
              mesh.boxes.begin() + static_cast<std::ptrdiff_t>(to.node));
    const auto vertex = static_cast<std::uint32_t>(to.vertex);
    const auto index = static_cast<std::uint32_t>(to.index);
    for (std::size_t k = 0; k < piece.indices.size(); ++k)
      mesh.indices[to.index + k] = piece.indices[k] + vertex;
    for (std::size_t k = 0; k < piece.ranges.size(); ++k) {
      mesh.ranges[to.node + k] = {piece.ranges[k].first + index, piece.ranges[k].count};
    }
    piece = MeshWriter(anchor);  // gives the memory back
  });
  return mesh;
}

/// Calls `meshOne(node − firstNode, writer)` for all nodes, in parallel.
template <class MeshOne>
NodeMesh meshNodes(std::size_t count, NodeId firstNode, const Vec3& anchor, const MeshOne& meshOne) {
  std::vector<MeshWriter> pieces((count + kPiece - 1) / kPiece, MeshWriter(anchor));
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t piece) {
    const std::size_t last = std::min(count, (piece + 1) * kPiece);
    for (std::size_t i = piece * kPiece; i < last; ++i) meshOne(i, pieces[piece]);
  });
  return join(pieces, firstNode, anchor);
}

/// The finest surfaces of an object that is no building.
std::vector<const Geometry*> finestSurfaces(const CityObject& object) {
  std::vector<const Geometry*> found;
  for (const Geometry& geometry : object.geometries) {
    if (geometry.kind == GeometryKind::MultiCurve || geometry.kind == GeometryKind::MultiPoint) continue;
    // LoD strings compare as text: "1" < "1.2" < "2".
    if (!found.empty() && geometry.lod > found.front()->lod) found.clear();
    if (found.empty() || geometry.lod == found.front()->lod) found.push_back(&geometry);
  }
  return found;
}

void meshBuilding(const Building& building, NodeId node, MeshWriter& writer) {
  const std::vector<Geometry> geometries = exteriorGeometry(building.object);
  writer.begin(node, building.base);
  for (const Geometry& geometry : geometries) writer.addGeometry(geometry);
  if (geometries.empty()) {
    for (const Polygon& polygon : building.footprint)
      writer.addBlock(polygon, building.base, building.height);
  }
  writer.end();
}

}  // namespace

NodeMesh meshBuildings(const CityModel& city, const Vec3& anchor) {
  return meshNodes(city.buildings.size(), 0, anchor, [&](std::size_t i, MeshWriter& writer) {
    meshBuilding(city.buildings[i], static_cast<NodeId>(i), writer);
  });
}

NodeMesh meshBuildings(const CityModel& city, std::span<const std::uint32_t> buildings, NodeId firstNode,
                       const Vec3& anchor) {
  return meshNodes(buildings.size(), firstNode, anchor, [&](std::size_t i, MeshWriter& writer) {
    meshBuilding(city.buildings[buildings[i]], firstNode + static_cast<NodeId>(i), writer);
  });
}

NodeMesh meshClusters(const ClusterTree& tree, const Vec3& anchor) {
  std::size_t leaves = 0;
  while (leaves < tree.nodes.size() && tree.isLeaf(static_cast<NodeId>(leaves))) ++leaves;
  return meshNodes(tree.nodes.size() - leaves, static_cast<NodeId>(leaves), anchor,
                   [&tree, leaves](std::size_t i, MeshWriter& writer) {
                     const auto id = static_cast<NodeId>(leaves + i);
                     const ClusterNode& node = tree.nodes[id];
                     writer.begin(id, node.base);
                     const auto hull = tree.hull(id);
                     writer.addBlock({Ring(hull.begin(), hull.end()), {}}, node.base, node.height);
                     writer.end();
                   });
}

NodeMesh meshContext(const CityModel& city, const Vec3& anchor, NodeId node) {
  MeshWriter writer(anchor);
  writer.begin(node, 0);
  for (const CityObject& other : city.others) {
    forEachObject(other, [&](const CityObject& object) {
      for (const Geometry* geometry : finestSurfaces(object)) writer.addGeometry(*geometry);
    });
  }
  writer.end();
  std::vector<MeshWriter> pieces;
  pieces.push_back(std::move(writer));
  return join(pieces, node, anchor);
}

}  // namespace lodestone
