// Area-weighted sums of squared distances to planes (Garland and Heckbert 1997).
#pragma once

#include <optional>

#include <Eigen/Dense>

#include "model/geometry.h"

namespace lodestone {

/// Q(v) = Σ area · (distance of v to the plane)². Points are taken relative to an origin near the model, so
/// that large coordinates cost no digits.
class Quadric {
 public:
  Quadric() = default;
  /// Of the plane through a triangle. `areaNormal` is twice its area vector; a triangle without area adds
  /// nothing.
  Quadric(const Vec3& areaNormal, const Vec3& point) {
    const double length = areaNormal.norm();
    if (length == 0) return;
    const Vec3 normal = areaNormal / length;
    const double area = length / 2;
    const double offset = -normal.dot(point);
    matrix_ = area * normal * normal.transpose();
    linear_ = area * offset * normal;
    constant_ = area * offset * offset;
  }
  Quadric& operator+=(const Quadric& other) {
    matrix_ += other.matrix_;
    linear_ += other.linear_;
    constant_ += other.constant_;
    return *this;
  }
  /// Never below 0.
  [[nodiscard]] double operator()(const Vec3& p) const {
    return std::max(0.0, p.dot(matrix_ * p) + 2 * linear_.dot(p) + constant_);
  }
  /// The point where the sum is least, where there is one and it is well determined.
  [[nodiscard]] std::optional<Vec3> minimum() const {
    const double trace = matrix_.trace();
    if (matrix_.determinant() <= 1e-9 * trace * trace * trace) return std::nullopt;
    return Vec3(matrix_.ldlt().solve(-linear_));
  }

 private:
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Vec3 linear_ = Vec3::Zero();
  double constant_ = 0;
};

}  // namespace lodestone
