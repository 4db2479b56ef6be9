#include "model/detail_colours.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "model/geometry.h"
#include "model/level_colours.h"

namespace lodestone {
namespace {

/// CIE 1976 L*a*b*, of D65.
Vec3 labOf(const Vec3& linear) {
  Eigen::Matrix3d toXyz;
  toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Vec3 xyz = toXyz * linear;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz.x() / 0.9505);
  const double y = f(xyz.y());
  const double z = f(xyz.z() / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// As people see it who lack one kind of cone, wholly (Machado, Oliveira, Fernandes 2009, table 1).
std::vector<Eigen::Matrix3d> visions() {
  std::vector<Eigen::Matrix3d> all(4);
  all[0].setIdentity();
  all[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  all[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  all[3] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  return all;
}

Vec3 linearOf(const std::array<float, 3>& colour) {
  return {toLinear(colour[0]), toLinear(colour[1]), toLinear(colour[2])};
}

TEST(DetailColours, AreToldApartWithAnyColourVision) {
  std::vector<Vec3> colours{linearOf(unseenColour())};
  for (std::size_t c = 0; c < kDetailClasses; ++c)
    colours.push_back(linearOf(detailColour(static_cast<DetailClass>(c))));
  for (const Eigen::Matrix3d& vision : visions()) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Vec3 a = labOf((vision * colours[i]).cwiseMax(0).cwiseMin(1));
        const Vec3 b = labOf((vision * colours[j]).cwiseMax(0).cwiseMin(1));
        EXPECT_GT((a - b).norm(), 20) << i << " and " << j << " with\n" << vision;
      }
    }
  }
}

}  // namespace
}  // namespace lodestone
