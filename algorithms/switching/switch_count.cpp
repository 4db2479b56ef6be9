#include "algorithms/switching/switch_count.h"

#include <algorithm>
#include <utility>

namespace lodestone {

SwitchCounter::SwitchCounter(const ClusterTree& tree) : tree_(tree) {
  for (Drawn* drawn : {&before_, &now_}) {
    drawn->isDrawn.resize(tree.nodes.size());
    drawn->level.resize(tree.nodes.size());
    drawn->isAbove.resize(tree.nodes.size());
  }
}

std::uint64_t SwitchCounter::next(const Cut& cut) {
  std::swap(before_, now_);
  clear(now_);
  fill(now_, cut);
  const bool first = std::exchange(first_, false);
  if (first) return 0;
  return takenOver(now_, before_) + takenOver(before_, now_) + changedLevels(now_, before_) +
         landmarksOf(now_, before_) + landmarksOf(before_, now_);
}

void SwitchCounter::clear(Drawn& drawn) const {
  for (const NodeId node : drawn.nodes) drawn.isDrawn[node] = false;
  for (const NodeId node : drawn.above) drawn.isAbove[node] = false;
  drawn.nodes.clear();
  drawn.above.clear();
  drawn.landmarks.clear();
}

void SwitchCounter::fill(Drawn& drawn, const Cut& cut) const {
  for (const DrawnNode& item : cut.drawn) {
    if (item.role == DrawRole::Landmark) {
      drawn.landmarks.emplace_back(item.node, item.of);
      continue;
    }
    drawn.nodes.push_back(item.node);
    drawn.isDrawn[item.node] = true;
    drawn.level[item.node] = item.level;
    for (NodeId up = tree_.nodes[item.node].parent; up != kNoNode && !drawn.isAbove[up];
         up = tree_.nodes[up].parent) {
      drawn.isAbove[up] = true;
      drawn.above.push_back(up);
    }
  }
  std::sort(drawn.landmarks.begin(), drawn.landmarks.end());
}

/// Nodes of one that stand where parts of them stand in the other.
std::uint64_t SwitchCounter::takenOver(const Drawn& by, const Drawn& from) {
  return static_cast<std::uint64_t>(
      std::count_if(by.nodes.begin(), by.nodes.end(), [&](NodeId node) { return from.isAbove[node]; }));
}

std::uint64_t SwitchCounter::changedLevels(const Drawn& one, const Drawn& other) {
  return static_cast<std::uint64_t>(std::count_if(one.nodes.begin(), one.nodes.end(), [&](NodeId node) {
    return other.isDrawn[node] && one.level[node] != other.level[node];
  }));
}

/// Landmarks of one that the other has not, though their cluster is drawn in it.
std::uint64_t SwitchCounter::landmarksOf(const Drawn& one, const Drawn& other) {
  return static_cast<std::uint64_t>(
      std::count_if(one.landmarks.begin(), one.landmarks.end(), [&](const auto& landmark) {
        return other.isDrawn[landmark.second] &&
               !std::binary_search(other.landmarks.begin(), other.landmarks.end(), landmark);
      }));
}

}  // namespace lodestone
