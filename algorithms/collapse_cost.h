// What a half-edge collapse costs (Wang et al. 2021, Eq. (1) and (2); resources/docs/methods.md, 2.3).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/quadric.h"
#include "model/component_mesh.h"
#include "model/simplify_options.h"

namespace lodestone {

/// Costs of moving vertices of a mesh onto each other, and the quadrics that add up as they do.
class CollapseCost {
 public:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// `classes` is null for plain QEM.
  CollapseCost(const ComponentMesh& mesh, const Classification* classes, double a);

  /// Of v1 → v2. `planarSheet`: the triangles around v1 lie in one plane and do not close around it.
  [[nodiscard]] double operator()(std::uint32_t v1, std::uint32_t v2, bool planarSheet) const;
  /// Whether the cost of moving the vertex depends on planarSheet.
  [[nodiscard]] bool asksForSheet(std::uint32_t v1) const {
    return classes_ && classes_->vertices[v1] == VertexClass::Boundary;
  }
  /// v1 went into v2.
  void collapsed(std::uint32_t v1, std::uint32_t v2);

 private:
  void add(const ComponentMesh::Triangle& triangle);
  [[nodiscard]] double leastCosine(std::uint32_t v1, std::uint32_t v2) const;

  const ComponentMesh& mesh_;
  const Classification* classes_;
  double a_;
  Vec3 origin_;
  std::vector<Quadric> quadrics_;
  std::vector<double> areas_;       ///< of the triangles that went into a vertex, m²
  std::vector<Vec3> planeNormals_;  ///< unit, of each of the classes' planes
  std::vector<std::uint32_t> planeComponents_;
};

}  // namespace lodestone
