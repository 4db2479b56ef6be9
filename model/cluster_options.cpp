#include "model/cluster_options.h"

namespace lodestone {

template <>
const std::vector<Field<ClusterOptions>>& fields<ClusterOptions>() {
  using O = ClusterOptions;
  static const std::vector<Field<O>> table{
      choice(&O::linkage, "linkage", "Linkage", {"legible", "single", "complete", "kmeans"},
             "How clusters are joined: legible weighs distance by cluster size (Chang et al. 2008, Eq. 1); "
             "single, "
             "complete and kmeans are there to compare."),
      choice(
          &O::distance, "distance", "Distance", {"vertex", "outline"},
          "Between two buildings: closest ground vertices (the paper's), or closest points of the outlines."),
      integer(&O::neighbours, "neighbours", "Neighbours", "buildings", 1, 1000,
              "Nearest buildings of each building that are considered (Chang et al. 2008, section 5)."),
      real(&O::barrierFactor, "barrier-factor", "Barrier factor", "×", 0, 1e6,
           "How much more a pair costs whose closest segment crosses a barrier; 0 forbids it until nothing "
           "else is left."),
      text(
          &O::barrierLayer, "barrier-layer", "Barrier layer",
          "Layer of barrier files that have several. Empty: all layers of lines, or where there is none, the "
          "outlines of all polygons; OSM: streets, rails and rivers."),
      text(&O::attribute, "attribute", "Attribute term",
           "FIELD=WEIGHT: adds WEIGHT metres to the distance for each unit by which the attribute differs "
           "(for text: "
           "if it differs)."),
  };
  return table;
}

template <>
const std::vector<Field<MergeOptions>>& fields<MergeOptions>() {
  using O = MergeOptions;
  static const std::vector<Field<O>> table{
      real(&O::edgeRatio, "edge-ratio", "Edge ratio", "", 0.05, 1,
           "Edges of a merged hull as a share of its children's edges (Chang et al. 2008, section 6)."),
  };
  return table;
}

template <>
const std::vector<Field<CutOptions>>& fields<CutOptions>() {
  using O = CutOptions;
  static const std::vector<Field<O>> table{
      real(&O::epsilon, "epsilon", "Tolerance ε", "px", 0, 1e6,
           "Greatest negative space of a cluster on screen; larger merges more (Chang et al. 2008, section "
           "7)."),
      real(&O::alpha, "alpha", "Landmark height α", "px", 0, 1e6,
           "A building that stands out of its cluster by more is drawn itself (Chang et al. 2008, section "
           "7)."),
  };
  return table;
}

}  // namespace lodestone
