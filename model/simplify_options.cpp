#include "model/simplify_options.h"

namespace lodestone {

template <>
const std::vector<Field<SimplifyOptions>>& fields<SimplifyOptions>() {
  using O = SimplifyOptions;
  static const std::vector<Field<O>> table{
      choice(
          &O::method, "method", "Method",
          {"topology", "qem", "qem-optimal", "vertex-clustering", "perception", "combined"},
          "topology keeps components together (Wang et al. 2021). To compare: qem collapses half-edges by "
          "quadrics alone, qem-optimal contracts edges to where the quadrics are least (Garland and Heckbert "
          "1997), vertex-clustering joins what falls into one cell of a grid (Rossignac and Borrel 1993). "
          "perception touches only what pictures show nobody would miss (Du, Zhu and Zhao); combined does so "
          "with topology's collapses."),
      real(&O::rate, "rate", "Rate", "", 0, 1, "Share of the triangles that is removed."),
      real(&O::a, "a", "Boundary cost a", "×", 1, 100,
           "How much more it costs to move a vertex that touches another component; 1–3 suits simple models, "
           "2–8 complex ones (Wang et al. 2021, section 4.2)."),
      flag(&O::aAuto, "a-auto", "Find a",
           "Try values of a from 1 to 8 on each group of touching buildings and keep the best: the smallest "
           "widest gap plus Hausdorff distance, within a twentieth of which the fewest broken contacts "
           "decide."),
      flag(&O::rimPlanes, "rim-planes", "Rim planes",
           "Hold open edges by planes across them (Garland and Heckbert 1997, section 6): with topology "
           "instead "
           "of by length, with qem and qem-optimal instead of not at all. perception always has them."),
      integer(&O::stage, "stage", "Stage", "", 1, 3,
              "What perception and combined may touch: 1 details that change dramatically when the eye "
              "filters them, 2 moderately too, 3 slightly too (Du, Zhu and Zhao, section 5.2). Seen from "
              "near by, 1 and 2 admit few triangles, and a vertex moves only where all around it are admitted."),
      flag(
          &O::unseen, "unseen", "Unseen too",
          "Triangles that no picture shows may be simplified as well, and parts of such triangles alone go."),
      real(&O::error, "error", "Error", "m", 0, 1e4,
           "What perception and combined leave out: a step that leads farther than this, root mean square, "
           "from the planes that the surface came from (single points may go farther: no limit for the "
           "Hausdorff distance), or with perception a texture so far from what it lies on; 0: as far as the "
           "rate asks, and textures not at all. With --rate 1 a stage goes on as far as this allows."),
      real(&O::gap, "gap", "Gap", "", 0, 0.2,
           "Share of its length by which an edge is lengthened to find what it nearly touches (Wang et al. "
           "2021, "
           "section 3.2.3)."),
  };
  return table;
}

}  // namespace lodestone
