// What a half-edge collapse costs (Wang et al. 2021, Eq. (1) and (2); resources/docs/methods.md, 2.3).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/simplification/boundary_planes.h"
#include "algorithms/simplification/quadric.h"
#include "model/component_mesh.h"
#include "model/simplify_options.h"

namespace lodestone {

/// Costs of moving vertices of a mesh onto each other, and the quadrics that add up as they do.
class CollapseCost {
 public:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// Of the options a, rimPlanes and method count: Perception always has rim planes, and holds borders of
  /// charts likewise. `classes` is null where they do not; else they must outlive this.
  CollapseCost(const ComponentMesh& mesh, const Classification* classes, const SimplifyOptions& options);
  /// Points are taken relative to `origin`: those of a component cost the same alone and among others.
  CollapseCost(const ComponentMesh& mesh, BoundaryPlanes planes, const SimplifyOptions& options,
               const Vec3& origin);

  /// Where a vertex stands now.
  [[nodiscard]] const Vec3& position(std::uint32_t v) const { return vertices_[v].position; }

  /// Twice the area vector of a triangle of vertices as they stand now.
  [[nodiscard]] Vec3 areaNormalOf(const ComponentMesh::Triangle& triangle) const;

  /// Where the edge contracts to with the least QEM, and that QEM: the best of the quadrics' minimum (where
  /// it is well determined, and no farther from the edge's middle than twice the edge's length), v2, v1 and
  /// the middle.
  struct Placement {
    Vec3 at = Vec3::Zero();
    double cost = kNever;
  };
  [[nodiscard]] Placement contraction(std::uint32_t v1, std::uint32_t v2) const;
  /// The same four places (three where no minimum is to be had), the best first; v2 and v1 to the last bit.
  struct Placements {
    std::array<Placement, 4> places;
    std::size_t count = 0;
  };
  [[nodiscard]] Placements contractions(std::uint32_t v1, std::uint32_t v2) const;
  /// Q of both ends at a point.
  [[nodiscard]] double qem(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const;
  /// Root mean square distance of a point to the planes that went into both ends, metres.
  [[nodiscard]] double meanDistance(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const;

  /// Of v1 → v2. `open`: the triangles around v1 do not close around it. Then a move along the planes that
  /// went into a boundary vertex has next to no QEM, however much of the surface goes with it, and `a` would
  /// multiply nothing: such a move costs by QEM*. With rimPlanes the planes across open edges say what it
  /// does. A cost above `most` may be given as kNever: angles are not looked at where they cannot matter.
  [[nodiscard]] double operator()(std::uint32_t v1, std::uint32_t v2, bool open, double most = kNever) const;
  /// Of v1 → v2 where that changes the look of the surface, of which its planes know nothing: by QEM*.
  [[nodiscard]] double byLength(std::uint32_t v1, std::uint32_t v2, double most = kNever) const;
  [[nodiscard]] bool isBoundary(std::uint32_t v) const {
    return !planes_.classes.empty() && planes_.classes[v] == VertexClass::Boundary;
  }
  [[nodiscard]] double a() const { return a_; }
  /// v1 went into v2, which stands at `at` now.
  void collapsed(std::uint32_t v1, std::uint32_t v2, const Vec3& at);

 private:
  /// All that is asked of a vertex together: in a large mesh each place in memory is a miss.
  struct alignas(64) Vertex {
    Vec3 position;
    Quadric quadric;
    double area = 0;  ///< of the triangles that went into it, m²
  };

  void add(const ComponentMesh& mesh, const ComponentMesh::Triangle& triangle);
  void addRims(const ComponentMesh& mesh, bool borders);
  [[nodiscard]] Placements placesFor(std::uint32_t v1, std::uint32_t v2) const;
  [[nodiscard]] double qemStar(std::uint32_t v1, std::uint32_t v2) const;
  [[nodiscard]] double held(std::uint32_t v1, std::uint32_t v2, double base, double most) const;
  [[nodiscard]] double leastCosine(std::uint32_t v1, std::uint32_t v2) const;

  BoundaryPlanes planes_;
  double a_;
  bool rimPlanes_;
  Vec3 origin_;
  std::vector<Vertex> vertices_;
};

}  // namespace lodestone
