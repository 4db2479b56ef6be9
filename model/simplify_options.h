// Options of building-scale simplification (Wang et al. 2021, Du, Zhu and Zhao; resources/docs/methods.md,
// sections 2 and 5).
#pragma once

#include "model/options.h"

namespace lodestone {

enum class SimplifyMethod { Topology, Qem, QemOptimal, VertexClustering, Perception, Combined };

struct SimplifyOptions {
  SimplifyMethod method = SimplifyMethod::Topology;
  double rate = 0.5;   ///< triangles removed / triangles of the original
  double a = 2;        ///< basic cost ratio of boundary vertices
  bool aAuto = false;  ///< a is searched for instead
  /// Open edges are held by planes across them (Garland and Heckbert 1997, section 6), not by length
  /// (Topology, Combined) or not at all (Qem, QemOptimal). Perception always has such planes.
  bool rimPlanes = false;
  int stage = 2;        ///< 1 to 3: which classes of detail Perception and Combined may touch
  bool unseen = false;  ///< and whether what no picture shows
  /// Metres that Perception and Combined move the surface by at most, and Perception textures along it; 0: no
  /// bound for the surface, and textures not at all.
  double error = 0;
  double gap = 0.01;  ///< share of its length by which each end of an edge is lengthened to find contacts
  bool operator==(const SimplifyOptions&) const = default;
};

/// Whether pictures say where a method may touch the model.
[[nodiscard]] inline bool needsPerception(SimplifyMethod method) {
  return method == SimplifyMethod::Perception || method == SimplifyMethod::Combined;
}
/// Whether a method looks at what components do to each other.
[[nodiscard]] inline bool needsTopology(SimplifyMethod method) {
  return method == SimplifyMethod::Topology || method == SimplifyMethod::Combined;
}

template <>
const std::vector<Field<SimplifyOptions>>& fields<SimplifyOptions>();

}  // namespace lodestone
