#include "model/io/citygml/citygml_pool.h"

namespace lodestone::citygml {

void GeometryPool::clear() {
  points.clear();
  rings.clear();
  surfaces.clear();
  textureCoordinates.clear();
  items.clear();
  targets.clear();
  placements.clear();
  drafts.clear();
  objects.clear();
}

void GeometryPool::flip(std::uint32_t item, std::uint32_t target) {
  for (std::size_t i = item; i < items.size(); ++i) items[i].flip = !items[i].flip;
  for (std::size_t i = target; i < targets.size(); ++i) targets[i].flip = !targets[i].flip;
}

}  // namespace lodestone::citygml
