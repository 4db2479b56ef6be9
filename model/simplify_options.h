// Options of building-scale simplification (Wang et al. 2021; resources/docs/methods.md, section 2).
#pragma once

#include "model/options.h"

namespace lodestone {

enum class SimplifyMethod { Topology, Qem, QemOptimal, VertexClustering };

struct SimplifyOptions {
  SimplifyMethod method = SimplifyMethod::Topology;
  double rate = 0.5;   ///< triangles removed / triangles of the original
  double a = 2;        ///< basic cost ratio of boundary vertices
  bool aAuto = false;  ///< a is searched for instead
  /// Open edges are held by planes across them (Garland and Heckbert 1997, section 6), not by length
  /// (Topology) or not at all (Qem, QemOptimal).
  bool rimPlanes = false;
  double gap = 0.01;  ///< share of its length by which each end of an edge is lengthened to find contacts
  bool operator==(const SimplifyOptions&) const = default;
};

template <>
const std::vector<Field<SimplifyOptions>>& fields<SimplifyOptions>();

}  // namespace lodestone
