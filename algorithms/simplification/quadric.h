// Area-weighted sums of squared distances to planes (Garland and Heckbert 1997).
#pragma once

#include <algorithm>
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
    xx_ = area * normal.x() * normal.x();
    xy_ = area * normal.x() * normal.y();
    xz_ = area * normal.x() * normal.z();
    yy_ = area * normal.y() * normal.y();
    yz_ = area * normal.y() * normal.z();
    zz_ = area * normal.z() * normal.z();
    linear_ = area * offset * normal;
    constant_ = area * offset * offset;
  }
  Quadric& operator+=(const Quadric& other) {
    xx_ += other.xx_;
    xy_ += other.xy_;
    xz_ += other.xz_;
    yy_ += other.yy_;
    yz_ += other.yz_;
    zz_ += other.zz_;
    linear_ += other.linear_;
    constant_ += other.constant_;
    return *this;
  }
  /// Never below 0.
  [[nodiscard]] double operator()(const Vec3& p) const {
    const double x = p.x();
    const double y = p.y();
    const double z = p.z();
    return std::max(0.0, x * (xx_ * x + 2 * (xy_ * y + xz_ * z + linear_.x())) +
                             y * (yy_ * y + 2 * (yz_ * z + linear_.y())) + z * (zz_ * z + 2 * linear_.z()) +
                             constant_);
  }
  /// Of all planes together, m².
  [[nodiscard]] double weight() const { return xx_ + yy_ + zz_; }
  /// The point where the sum is least, where there is one and it is well determined.
  [[nodiscard]] std::optional<Vec3> minimum() const {
    Eigen::Matrix3d matrix;
    matrix << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
    const double trace = matrix.trace();
    if (matrix.determinant() <= 1e-9 * trace * trace * trace) return std::nullopt;
    return Vec3(matrix.ldlt().solve(-linear_));
  }

 private:
  double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;  ///< of the symmetric matrix
  Vec3 linear_ = Vec3::Zero();
  double constant_ = 0;
};

}  // namespace lodestone
