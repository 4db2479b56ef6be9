// Options of the legible-LOD stages (Chang et al. 2008; resources/docs/methods.md, section 1).
#pragma once

#include <string>

#include "model/options.h"

namespace lodestone {

enum class Linkage { Legible, Single, Complete, KMeans };
enum class FootprintDistance { Vertex, Outline };

struct ClusterOptions {
  Linkage linkage = Linkage::Legible;
  FootprintDistance distance = FootprintDistance::Vertex;
  int neighbours = 50;  ///< k of the neighbour graph, buildings
  double barrierFactor =
      0;  ///< a pair across a barrier costs this many times more; 0: forbidden until nothing else is left
  std::string barrierLayer;  ///< layer of barrier files that have several; empty: all layers of lines
  std::string attribute;     ///< attribute term: "FIELD=WEIGHT" (metres per unit of difference), empty: none
  bool operator==(const ClusterOptions&) const = default;
};

struct MergeOptions {
  double edgeRatio = 0.75;  ///< edges of a parent's hull / edges of its children's hulls
  bool operator==(const MergeOptions&) const = default;
};

struct CutOptions {
  double epsilon = 100;  ///< greatest projected negative space, pixels
  double alpha = 2;      ///< greatest height error on screen before a building becomes a landmark, pixels
  bool operator==(const CutOptions&) const = default;
};

template <>
const std::vector<Field<ClusterOptions>>& fields<ClusterOptions>();
template <>
const std::vector<Field<MergeOptions>>& fields<MergeOptions>();
template <>
const std::vector<Field<CutOptions>>& fields<CutOptions>();

}  // namespace lodestone
