// A mesh as lists of triangles while its edges collapse, the slow way: nothing is kept but what is left.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include "model/component_mesh.h"

namespace lodestone::test {

/// Of manifolds without textures.
class SlowMesh {
 public:
  explicit SlowMesh(const ComponentMesh& mesh)
      : mesh_(mesh),
        positions_(mesh.vertices),
        triangles_(mesh.triangles),
        left_(mesh.triangles.size(), true) {}

  /// Positions of the corners of what is left.
  [[nodiscard]] std::vector<std::array<Vec3, 3>> result() const {
    std::vector<std::array<Vec3, 3>> corners;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      if (left_[t]) corners.push_back({positions_[a], positions_[b], positions_[c]});
    }
    return corners;
  }

 protected:
  [[nodiscard]] std::size_t removed() const {
    return static_cast<std::size_t>(std::count(left_.begin(), left_.end(), false));
  }
  [[nodiscard]] std::vector<std::size_t> around(std::uint32_t v) const {
    std::vector<std::size_t> result;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (left_[t] && std::count(triangles_[t].begin(), triangles_[t].end(), v) > 0) result.push_back(t);
    }
    return result;
  }
  [[nodiscard]] std::set<std::uint32_t> neighbours(std::uint32_t v) const {
    std::set<std::uint32_t> result;
    for (const std::size_t t : around(v)) result.insert(triangles_[t].begin(), triangles_[t].end());
    result.erase(v);
    return result;
  }
  [[nodiscard]] std::size_t sides(std::uint32_t a, std::uint32_t b) const {
    std::size_t count = 0;
    for (const std::size_t t : around(a))
      count += std::count(triangles_[t].begin(), triangles_[t].end(), b) > 0;
    return count;
  }
  [[nodiscard]] bool onRim(std::uint32_t v) const {
    const auto all = neighbours(v);
    return std::any_of(all.begin(), all.end(), [&](std::uint32_t n) { return sides(v, n) == 1; });
  }
  [[nodiscard]] Vec3 normal(const ComponentMesh::Triangle& t, std::uint32_t moved, const Vec3& to) const {
    const auto at = [&](std::uint32_t v) { return v == moved ? to : positions_[v]; };
    return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
  }

  /// Whether v1 may go into v2, which then stands at `at`.
  [[nodiscard]] bool legal(std::uint32_t v1, std::uint32_t v2, const Vec3& at) const {
    std::set<std::uint32_t> opposite;
    for (const std::uint32_t moved : {v1, v2}) {
      for (const std::size_t t : around(moved)) {
        const auto& corners = triangles_[t];
        if (std::count(corners.begin(), corners.end(), moved == v1 ? v2 : v1) > 0) {
          opposite.insert(corners.begin(), corners.end());
          continue;
        }
        if (at == positions_[moved]) continue;
        const Vec3 before = normal(corners, moved, positions_[moved]);
        const Vec3 after = normal(corners, moved, at);
        if (before == Vec3::Zero()) continue;
        if (before.dot(after) <= 1e-3 * before.norm() * after.norm() || after.norm() <= 1e-9 * before.norm())
          return false;
      }
    }
    opposite.erase(v1);
    opposite.erase(v2);
    for (const std::uint32_t v : opposite) {
      if (sides(v1, v) == 1 && sides(v2, v) == 1) return false;  // an ear
    }
    for (const std::uint32_t v : neighbours(v1)) {
      if (v != v2 && opposite.count(v) == 0 && neighbours(v2).count(v) > 0) return false;
    }
    // the last triangles of a closed component fold onto each other
    if (opposite.size() < 2 && sides(v1, v2) == 2) return false;
    return sides(v1, v2) == 1 || !(onRim(v1) && onRim(v2));
  }

  void join(std::uint32_t v1, std::uint32_t v2, const Vec3& at) {
    positions_[v2] = at;
    for (const std::size_t t : around(v1)) {
      auto& corners = triangles_[t];
      left_[t] = std::count(corners.begin(), corners.end(), v2) == 0;
      std::replace(corners.begin(), corners.end(), v1, v2);
    }
  }

  /// Area · diagonal² of what is left of a component.
  [[nodiscard]] double extent(const Component& component) const {
    double area = 0;
    Box3 box;
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      if (!left_[t]) continue;
      area += normal(triangles_[t], triangles_[t][0], positions_[triangles_[t][0]]).norm() / 2;
      for (const std::uint32_t v : triangles_[t]) box.add(positions_[v]);
    }
    return area * box.size().squaredNorm();
  }

  const ComponentMesh& mesh_;
  std::vector<Vec3> positions_;
  std::vector<ComponentMesh::Triangle> triangles_;
  std::vector<bool> left_;
};

}  // namespace lodestone::test
