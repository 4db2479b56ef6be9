// How often what is drawn changes from picture to picture: the "pops" that a viewer sees.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "model/cluster_tree.h"

namespace lodestone {

/// Counts switches between cuts of one tree. A switch is a cluster that takes over from what was drawn of it
/// before, or gives way to that, be it two buildings or a hundred; a landmark that comes or goes where its
/// cluster stays; and a building that changes its level. What comes into the picture or leaves it is none.
class SwitchCounter {
 public:
  /// `tree` must outlive this.
  explicit SwitchCounter(const ClusterTree& tree);

  /// Switches from the cut given last; 0 for the first. Cost: about linear in what is drawn.
  std::uint64_t next(const Cut& cut);

 private:
  /// What was drawn once.
  struct Drawn {
    std::vector<NodeId> nodes;                         ///< clusters and buildings, landmarks apart
    std::vector<std::pair<NodeId, NodeId>> landmarks;  ///< and their clusters, ascending
    std::vector<std::uint8_t> level;                   ///< by node that is drawn
    std::vector<bool> isDrawn;                         ///< by node
    std::vector<bool> isAbove;                         ///< by node: something below it is drawn
    std::vector<NodeId> above;                         ///< the nodes that are so
  };
  void clear(Drawn& drawn) const;
  void fill(Drawn& drawn, const Cut& cut) const;
  [[nodiscard]] static std::uint64_t takenOver(const Drawn& by, const Drawn& from);
  [[nodiscard]] static std::uint64_t changedLevels(const Drawn& one, const Drawn& other);
  [[nodiscard]] static std::uint64_t landmarksOf(const Drawn& one, const Drawn& other);

  const ClusterTree& tree_;
  Drawn before_, now_;
  bool first_ = true;
};

}  // namespace lodestone
