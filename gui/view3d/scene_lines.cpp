#include "gui/view3d/scene_lines.h"

#include <string_view>

#include "algorithms/merging/cutting.h"

namespace lodestone {
namespace {

bool mentions(std::string_view text, std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words) {
    if (text.find(word) != std::string_view::npos) return true;
  }
  return false;
}

const Rgb& lineColour(const std::string& layer, const std::string& kind, const Palette& palette) {
  const std::string& said = kind.empty() ? layer : kind;
  if (mentions(said, {"rail", "tram", "subway", "funicular"})) return palette.rail;
  if (mentions(said, {"river", "stream", "canal", "water", "drain", "ditch"})) return palette.water;
  return palette.street;
}

void addOutline(LineSegments& lines, std::span<const Vec2> ring, double z, const Rgb& colour) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    lines.add(Vec3(a.x(), a.y(), z), Vec3(b.x(), b.y(), z), colour);
  }
}

void addPosts(LineSegments& lines, std::span<const Vec2> ring, double bottom, double top, const Rgb& colour) {
  for (const Vec2& p : ring) lines.add(Vec3(p.x(), p.y(), bottom), Vec3(p.x(), p.y(), top), colour);
}

}  // namespace

LineSegments streetLines(std::span<const LineLayer> layers, double ground, const Palette& palette,
                         const std::optional<Rgb>& given) {
  LineSegments lines;
  for (const LineLayer& layer : layers) {
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      const std::vector<Vec2>& line = layer.lines[i];
      const Rgb colour = given.value_or(
          lineColour(layer.name, i < layer.kinds.size() ? layer.kinds[i] : std::string(), palette));
      for (std::size_t k = 1; k < line.size(); ++k) {
        lines.add(Vec3(line[k - 1].x(), line[k - 1].y(), ground), Vec3(line[k].x(), line[k].y(), ground),
                  colour);
      }
    }
  }
  return lines;
}

LineSegments hullLines(const ClusterTree& tree, std::span<const DrawnNode> drawn, const Palette& palette) {
  LineSegments lines;
  for (const DrawnNode& item : drawn) {
    if (item.role != DrawRole::Cluster || item.node >= tree.nodes.size()) continue;
    const ClusterNode& node = tree.nodes[item.node];
    const auto hull = tree.hull(item.node);
    addOutline(lines, hull, node.base, palette.hullLine);
    addOutline(lines, hull, node.base + node.height, palette.hullLine);
    addPosts(lines, hull, node.base, node.base + node.height, palette.hullLine);
  }
  return lines;
}

LineSegments negativeSpaceLines(const ClusterTree& tree, std::span<const DrawnNode> drawn, const Vec3& eye,
                                const Palette& palette) {
  LineSegments lines;
  for (const DrawnNode& item : drawn) {
    if (item.role != DrawRole::Cluster || item.node >= tree.nodes.size()) continue;
    const Box3 box = negativeSpaceBox(tree, item.node, eye);
    if (box.empty()) continue;
    const std::array<Vec2, 4> plan{Vec2(box.min.x(), box.min.y()), Vec2(box.max.x(), box.min.y()),
                                   Vec2(box.max.x(), box.max.y()), Vec2(box.min.x(), box.max.y())};
    addOutline(lines, plan, box.min.z(), palette.boxLine);
    addOutline(lines, plan, box.max.z(), palette.boxLine);
    addPosts(lines, plan, box.min.z(), box.max.z(), palette.boxLine);
  }
  return lines;
}

}  // namespace lodestone
