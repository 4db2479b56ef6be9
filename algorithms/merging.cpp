#include "algorithms/merging.h"

#include <algorithm>

#include "algorithms/merged_hull.h"
#include "algorithms/predicates.h"

namespace lodestone {

Ring mergedHull(const std::vector<Ring>& children, std::size_t targetEdges) {
  std::vector<std::span<const Vec2>> rings;
  for (const Ring& child : children) {
    if (!child.empty()) rings.emplace_back(child);
  }
  const bool simple = std::all_of(children.begin(), children.end(),
                                  [](const Ring& ring) { return signedArea(ring) > 0 && isSimple(ring); });
  MergedHull merger;
  const std::span<const Vec2> hull = merger.make(rings, targetEdges, simple);
  return {hull.begin(), hull.end()};
}

}  // namespace lodestone
