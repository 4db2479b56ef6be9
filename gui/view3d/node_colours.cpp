#include "gui/view3d/node_colours.h"

#include <algorithm>
#include <iterator>

#include "gui/view3d/city_prop.h"
#include "gui/view3d/marks.h"

namespace lodestone {
namespace {

std::array<std::uint8_t, 4> bytes(const Rgb& colour, std::uint8_t outline) {
  std::array<std::uint8_t, 4> result{0, 0, 0, outline};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<std::uint8_t>(std::clamp(colour[i], 0.0F, 1.0F) * 255 + 0.5F);
  return result;
}

Rgb mix(const Rgb& a, const Rgb& b, float share) {
  return {a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share};
}

/// How drawn nodes are marked by a set of nodes.
class NodeMarks {
 public:
  NodeMarks(const SceneGeometry* geometry, std::span<const DrawnNode> drawn, std::span<const NodeId> nodes) {
    if (!geometry || nodes.empty()) return;
    // What is drawn itself does not tint the cluster around it: a landmark that is picked is marked alone.
    std::vector<bool> isDrawn(geometry->nodeCount(), false);
    for (const DrawnNode& item : drawn) {
      if (item.node < isDrawn.size()) isDrawn[item.node] = true;
    }
    std::vector<NodeId> hidden;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(hidden),
                 [&](NodeId node) { return node < isDrawn.size() && !isDrawn[node]; });
    whole_ = Marks(geometry->leaves, nodes);
    hidden_ = Marks(geometry->leaves, hidden);
  }
  [[nodiscard]] Mark of(NodeId node) const {
    return whole_.of(node) == Mark::Whole ? Mark::Whole : hidden_.of(node);
  }

 private:
  Marks whole_;   ///< of all nodes of the set
  Marks hidden_;  ///< of those that are not drawn themselves
};

Rgb baseColour(const DrawnNode& node, const NodeColouring& colouring) {
  const Palette& palette = colouring.palette;
  if (node.role == DrawRole::Landmark && colouring.showLandmarks) return palette.landmark;
  if (node.role != DrawRole::Cluster) return colouring.building.value_or(palette.building);
  if (!colouring.byCluster) return palette.cluster;
  const Rgb colour = clusterColour(node.node);
  return colouring.dark ? mix(colour, Rgb{0, 0, 0}, 0.25F) : colour;
}

}  // namespace

std::vector<std::array<std::uint8_t, 4>> nodeColours(const SceneGeometry* geometry,
                                                     std::span<const DrawnNode> drawn,
                                                     const NodeColouring& colouring) {
  const Palette& palette = colouring.palette;
  // The context node has the highest number that a tag can hold; the table ends before it and the shader
  // clamps to the last entry.
  std::vector<std::array<std::uint8_t, 4>> table(
      (geometry ? geometry->nodeCount() : 0) + 1,
      bytes(colouring.context.value_or(palette.context), CityProp::kPlain));
  const NodeMarks selected(geometry, drawn, colouring.selection);
  const NodeMarks hovered(geometry, drawn, std::span(&colouring.hover, colouring.hover == kNoNode ? 0 : 1));
  for (const DrawnNode& item : drawn) {
    if (item.node + 1 >= table.size()) continue;
    Rgb colour = baseColour(item, colouring);
    std::uint8_t outline = CityProp::kPlain;
    const Mark mark = selected.of(item.node);
    if (mark != Mark::None) {
      colour = mix(colour, palette.selection, mark == Mark::Whole ? 0.80F : 0.35F);
      outline = CityProp::kSelected;
    }
    if (hovered.of(item.node) != Mark::None) {
      colour = mix(colour, palette.hover, mark == Mark::None ? 0.75F : 0.40F);
      if (mark == Mark::None) outline = CityProp::kHovered;
    }
    table[item.node] = bytes(colour, outline);
  }
  return table;
}

}  // namespace lodestone
