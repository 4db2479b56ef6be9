// The landmark of a made-up town: a church with a tower, as a closed LoD2 solid.
#pragma once

#include "model/city_model.h"

namespace lodestone {

/// Size of the church over its ground, metres: tower at −x, nave along x, symmetric about y = 0.
struct ChurchSize {
  double naveLength = 32, naveWidth = 16, eaves = 10, ridge = 18;
  double towerSide = 8, towerTop = 30, spireTop = 48;  ///< towerSide < naveWidth, ridge < towerTop
};

/// Closed, oriented outward, with semantic surfaces, LoD "2.2". The middle of the joint of tower and nave
/// stands at `at`.
[[nodiscard]] Geometry makeChurch(const ChurchSize& size, const Vec3& at);

}  // namespace lodestone
