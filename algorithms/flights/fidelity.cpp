#include "algorithms/flights/fidelity.h"

#include <utility>

#include "algorithms/chains/chain_building.h"
#include "algorithms/switching/switcher.h"
#include "model/level_colours.h"

namespace lodestone {
namespace {

/// Of each kind of surface, whoever it belongs to.
std::shared_ptr<const ModelLook> plainLook() {
  auto look = std::make_shared<ModelLook>();
  for (int type = 0; type <= static_cast<int>(SurfaceType::Generic); ++type)
    look->materials.push_back(surfaceColour(DrawRole::Building, static_cast<SurfaceType>(type)));
  return look;
}

Box3 boundsOf(const ClusterTree& tree) {
  Box3 box;
  for (const ClusterNode& node : tree.nodes) {
    if (node.edges > 0) box.add(boxOf(node));
  }
  return box;
}

void add(const LevelObject& object, ComponentMesh& mesh) {
  for (std::size_t g = 0; g < object.geometries.size(); ++g) {
    const Geometry& geometry = object.geometries[g];
    const std::uint32_t first = mesh.vertexCount();
    mesh.vertices.insert(mesh.vertices.end(), geometry.vertices.begin(), geometry.vertices.end());
    for (const LevelObject::Triangle& t : object.triangles[g]) {
      mesh.triangles.push_back({first + t.vertices[0], first + t.vertices[1], first + t.vertices[2]});
      SurfaceInfo surface;
      surface.type = geometry.surfaces[t.surface].type;
      surface.material = static_cast<std::int32_t>(surface.type);
      mesh.surfaces.push_back(surface);
    }
  }
}

}  // namespace

Fidelity::Fidelity(std::shared_ptr<const CityModel> city, std::shared_ptr<const ClusterTree> tree)
    : city_(std::move(city)),
      tree_(std::move(tree)),
      look_(plainLook()),
      box_(boundsOf(*tree_)),
      everything_(rendererOf(everythingSwitcher(tree_)->pick({}))) {}

ModelRenderer Fidelity::rendererOf(const Cut& cut) const {
  const LodLevel level = levelOfCut(city_, tree_, cut);
  ComponentMesh mesh;
  // Rays start from the middle of the vertices: with these two it is the same one for any cut, and what is
  // drawn in both is the same to the last bit.
  mesh.vertices = {box_.min, box_.max};
  for (std::size_t i = 0; i < level.objectCount; ++i) add(level.object(i), mesh);
  return {mesh, look_};
}

PictureMeasures Fidelity::measure(const Cut& cut, double pixelsPerDegree, const Progress& progress) const {
  return compareModels(everything_, rendererOf(cut), {cut.camera}, pixelsPerDegree, progress).all;
}

}  // namespace lodestone
