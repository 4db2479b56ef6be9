// What a contraction costs to the eye (Du, Zhu and Zhao, Eq. (3) to (6); resources/docs/methods.md, 5.4).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "algorithms/rendering/fixed_lights.h"
#include "algorithms/simplification/collapsing_mesh.h"

namespace lodestone {

/// φ is 0 wherever the new brightness is the harmonic mean of the two, whatever the shape becomes: it never
/// weighs less than this (ours).
inline constexpr double kLeastPhi = 0.05;

/// The factors of Eq. (6).
struct PerceptualTerms {
  double phi = 0;       ///< Eq. (5)
  double geometry = 0;  ///< Cost_G, Eq. (3), m³
  [[nodiscard]] double cost() const { return std::max(phi, kLeastPhi) * geometry; }
};

/// Brightness by the area-weighted normal of the triangles around a vertex, and their box, as the mesh
/// stands. The sum of area vectors around a point p whose neighbours p₁, p₂, … go round it is Σ pᵢ × pᵢ₊₁ − p
/// × Σ (pᵢ₊₁ − pᵢ): with the two sums known of every vertex, the normal after a contraction takes the
/// triangles at its edge alone.
class PerceptualCost {
 public:
  /// `mesh` must outlive this. Points are taken relative to `origin`. Cost: linear.
  PerceptualCost(const CollapsingMesh& mesh, std::uint32_t vertices, const Vec3& origin);

  /// Of contracting an edge to `at`, where the quadrics of its ends add up to `qem`. Cost: constant, but
  /// where edges of more than two triangles end.
  [[nodiscard]] PerceptualTerms operator()(std::uint32_t edge, const Vec3& at, double qem) const;
  /// To be called when triangles around v have changed.
  void renew(std::uint32_t v);

 private:
  struct alignas(64) Vertex {
    Vec3 round = Vec3::Zero();    ///< Σ pᵢ × pᵢ₊₁
    Vec3 opening = Vec3::Zero();  ///< Σ (pᵢ₊₁ − pᵢ): 0 where the triangles close around the vertex
    double brightness = 0;        ///< Eq. (4)
    Box3 box;                     ///< of the triangles around it

    void add(const Vec3& from, const Vec3& to) {
      round += from.cross(to);
      opening += to - from;
    }
    /// None where the area vectors add up to nothing but noise.
    [[nodiscard]] Vec3 normal(const Vec3& at) const;
  };

  [[nodiscard]] Vec3 relative(std::uint32_t v) const { return mesh_.position(v) - origin_; }

  const CollapsingMesh& mesh_;
  Vec3 origin_;
  FixedLights lights_;
  std::vector<Vertex> vertices_;
};

}  // namespace lodestone
