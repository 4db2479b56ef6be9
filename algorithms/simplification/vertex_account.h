// Why a vertex is what it is, and what it costs to move it: for people who ask about one vertex.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/simplification/admission.h"
#include "algorithms/simplification/perceptual_cost.h"
#include "model/component_mesh.h"
#include "model/simplify_options.h"

namespace lodestone {

/// A collapse of the asked vertex onto a neighbour, as the first step of a simplification would see it; with
/// QemOptimal and Perception the contraction of the two.
struct MoveCost {
  std::uint32_t to = 0;
  double length = 0;                         ///< metres
  double angle = 0;                          ///< E–C angle, degrees; 0 for a vertex that is not boundary
  double cost = 0;                           ///< infinity: never
  std::optional<PerceptualTerms> perceived;  ///< what the cost of Perception is made of
};

/// One meeting of an edge of the vertex with another component.
struct Meeting {
  std::uint32_t edge = 0;  ///< index into Classification::edges
  bool inside = false;     ///< it makes the vertex boundary
  double angle = 0;        ///< the greatest E–C angle to the triangles that the edge meets, degrees
};

struct VertexAccount {
  VertexClass vertexClass = VertexClass::Ordinary;
  double area = 0;          ///< of the triangles around it, the fill of holes among them, m²
  bool onHoleEdge = false;  ///< it ends an edge with one triangle
  bool held = false;        ///< a triangle around it is not admitted: Perception and Combined let it stand
  std::vector<Meeting> meetings;
  std::vector<std::uint32_t> planes;  ///< reference planes, as triangles of the mesh
  std::vector<MoveCost> moves;        ///< the cheapest first; none where the method clusters vertices
};

/// Cost: linear in its component, whose half-edges are made for it, and in all boundary edges.
/// \pre vertex < mesh.vertexCount()
[[nodiscard]] VertexAccount accountOf(const ComponentMesh& mesh, const Classification& classes,
                                      const SimplifyOptions& options, std::uint32_t vertex,
                                      const Admission& admission = {});

/// The greatest E–C angle of a boundary edge to the triangles that it meets, degrees (Wang et al. 2021,
/// figure 9).
[[nodiscard]] double boundaryAngle(const ComponentMesh& mesh, const BoundaryEdge& edge);

}  // namespace lodestone
