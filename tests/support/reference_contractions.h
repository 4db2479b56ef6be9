// Perceptual contractions the slow way (Du, Zhu and Zhao, section 4.2): every step looks at every edge anew.
#pragma once

#include <cmath>
#include <optional>

#include "algorithms/rendering/fixed_lights.h"
#include "algorithms/simplification/admission.h"
#include "algorithms/simplification/collapse_cost.h"
#include "tests/support/slow_mesh.h"

namespace lodestone::test {

/// The triangles that algorithms/simplification/component_contractions.h leaves of an untextured mesh of
/// manifolds, neighbours wound alike.
class ReferenceContractions : public SlowMesh {
 public:
  ReferenceContractions(const ComponentMesh& mesh, const SimplifyOptions& options, const Admission& admission)
      : SlowMesh(mesh), options_(options), admission_(admission), cost_(mesh, nullptr, options) {
    const double target = std::ceil(options.rate * mesh.triangleCount() - 1e-9);
    while (static_cast<double>(removed()) < target && step()) {
    }
  }

 protected:
  explicit ReferenceContractions(const ComponentMesh& mesh)
      : SlowMesh(mesh), cost_(mesh, nullptr, {.method = SimplifyMethod::Perception}) {}

  /// Eq. (4), by the triangles around any of the vertices that do not hold two of them.
  [[nodiscard]] double brightness(const std::vector<std::uint32_t>& vertices, const Vec3& at) const {
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (const std::uint32_t v : vertices) {
      for (const std::size_t t : around(v)) {
        int held = 0;
        for (const std::uint32_t other : vertices)
          held += static_cast<int>(std::count(triangles_[t].begin(), triangles_[t].end(), other));
        if (held != 1) continue;
        sum += normal(triangles_[t], v, at);
        area += normal(triangles_[t], v, at).norm();
      }
    }
    const bool backToBack = sum.norm() < 1e-9 * area;
    return FixedLights().brightness(backToBack ? Vec3(Vec3::Zero()) : Vec3(sum.normalized()));
  }

  /// Eq. (5) and (3) multiplied as Eq. (6) says.
  [[nodiscard]] double costOf(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
    const double i1 = brightness({v1}, positions_[v1]);
    const double i2 = brightness({v2}, positions_[v2]);
    const double phi = std::abs((i1 + i2) / (i1 * i2) * brightness({v1, v2}, at) - 2);
    Box3 box;
    for (const std::uint32_t v : {v1, v2}) {
      for (const std::size_t t : around(v)) {
        for (const std::uint32_t corner : triangles_[t]) box.add(positions_[corner]);
      }
    }
    return std::max(phi, 0.05) * cost_.qem(v1, v2, at) / box.size().norm();
  }

 private:
  /// Whether every triangle around it was one that may change.
  [[nodiscard]] bool isFree(std::uint32_t v) const {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& corners = mesh_.triangles[t];
      if (std::count(corners.begin(), corners.end(), v) > 0 && !admission_.admits(t)) return false;
    }
    return true;
  }

  struct Step {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    Vec3 at = Vec3::Zero();
    double cost = 0;
  };

  [[nodiscard]] std::optional<Step> stepOf(std::uint32_t v1, std::uint32_t v2) const {
    const bool free1 = isFree(v1);
    const bool free2 = isFree(v2);
    if (!free1 && !free2) return std::nullopt;
    Step step{free1 ? v1 : v2, free1 ? v2 : v1, Vec3::Zero(), 0};
    std::vector<Vec3> places;
    if (free1 && free2) {
      const auto all = cost_.contractions(v1, v2);
      for (std::size_t i = 0; i < all.count; ++i) places.push_back(all.places[i].at);
    } else {
      places.push_back(positions_[step.to]);
    }
    for (const Vec3& at : places) {
      if (options_.error > 0 && cost_.meanDistance(v1, v2, at) > options_.error) return std::nullopt;
      step.at = at;
      step.cost = std::max(step.cost, costOf(v1, v2, at));
      if (legal(step.from, step.to, at)) return step;
    }
    return std::nullopt;
  }

  bool step() {
    std::optional<Step> best;
    for (std::uint32_t v1 = 0; v1 < mesh_.vertexCount(); ++v1) {
      for (const std::uint32_t v2 : neighbours(v1)) {
        if (v2 < v1) continue;
        const std::optional<Step> step = stepOf(v1, v2);
        if (step && (!best || step->cost < best->cost)) best = step;
      }
    }
    if (!best) return false;
    join(best->from, best->to, best->at);
    cost_.collapsed(best->from, best->to, best->at);
    return true;
  }

  SimplifyOptions options_;
  Admission admission_;

 protected:
  CollapseCost cost_;
};

}  // namespace lodestone::test
