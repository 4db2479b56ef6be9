// Triangles that rays can be shot at (Embree), the same answer on any number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// From `origin` along `direction` (need not be unit; distances are in its lengths).
struct Ray {
  Vec3f origin;
  Vec3f direction;
  float nearest = 0;
  float farthest = std::numeric_limits<float>::infinity();
};

struct RayHit {
  std::uint32_t triangle = 0;
  float distance = 0;
};

/// Rays that run side by side: together they cost little more than half of what each alone would.
using RayBundle = std::array<Ray, 4>;

struct TriangleSoup {
  std::vector<Vec3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

class RayScene {
 public:
  /// Memory: about 100 bytes a triangle. \throw std::runtime_error when Embree cannot build it.
  explicit RayScene(TriangleSoup soup);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// The closest hit; of several that floats can hardly tell apart (1e-5 of the distance), the triangle of
  /// the highest index, so that a landmark shows on the cluster that it stands in. Never slips between
  /// triangles that share an edge. Safe to call from several threads.
  [[nodiscard]] std::optional<RayHit> closest(const Ray& ray) const;
  [[nodiscard]] std::array<std::optional<RayHit>, 4> closestOfEach(const RayBundle& rays) const;
  /// Whether anything is hit at all.
  [[nodiscard]] bool occluded(const Ray& ray) const;
  [[nodiscard]] std::array<bool, 4> occludedEach(const RayBundle& rays) const;
  [[nodiscard]] const TriangleSoup& soup() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lodestone
