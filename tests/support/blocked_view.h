// A scene like the paper's figure 17: a building of many parts that blocks the view, and twenty targets
// behind.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "tests/support/part_models.h"

namespace lodestone {

/// A panel 4 m wide and 3 m high with a rough front; its sides are toothed, and fit its neighbours'.
inline Faces toothedPanel(const Vec3& at, unsigned seed) {
  constexpr int kAcross = 12;
  constexpr int kUp = 12;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> bump(-0.3, 0.3);
  std::array<std::array<Vec3, kUp + 1>, kAcross + 1> front;
  std::array<std::array<Vec3, kUp + 1>, kAcross + 1> back;
  for (std::size_t i = 0; i <= kAcross; ++i) {
    for (std::size_t k = 0; k <= kUp; ++k) {
      const bool side = i == 0 || i == kAcross;
      const Vec3 place = at + Vec3(i / 3.0 + (side ? 0.2 * (k % 2) : 0), 0, 0.25 * k);
      front[i][k] = place + Vec3(0, side ? 0 : bump(random), 0);
      back[i][k] = place + Vec3(0, 0.4, 0);
    }
  }
  Faces faces;
  const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    faces.push_back({a, b, c});
    faces.push_back({a, c, d});
  };
  for (std::size_t i = 0; i < kAcross; ++i) {
    for (std::size_t k = 0; k < kUp; ++k) {
      quad(front[i][k], front[i + 1][k], front[i + 1][k + 1], front[i][k + 1]);
      quad(back[i + 1][k], back[i][k], back[i][k + 1], back[i + 1][k + 1]);
    }
    quad(front[i][0], back[i][0], back[i + 1][0], front[i + 1][0]);
    quad(front[i][kUp], front[i + 1][kUp], back[i + 1][kUp], back[i][kUp]);
  }
  for (std::size_t k = 0; k < kUp; ++k) {
    quad(front[0][k], front[0][k + 1], back[0][k + 1], back[0][k]);
    quad(front[kAcross][k], back[kAcross][k], back[kAcross][k + 1], front[kAcross][k + 1]);
  }
  return faces;
}

/// A block of flats of panels between floors, in the way as in figure 17; openings let targets show.
inline std::vector<Faces> panelledBlock() {
  std::vector<Faces> parts;
  unsigned seed = 1;
  for (int storey = 0; storey < 4; ++storey) {
    for (int bay = 0; bay < 8; ++bay) {
      if ((bay * 5 + storey * 3) % 11 == 0) continue;
      parts.push_back(toothedPanel(Vec3(4 * bay, 0, 3 * storey), seed++));
    }
  }
  for (int storey = 0; storey <= 4; ++storey)
    parts.push_back(boxFaces(Vec3(-0.5, -0.4, 3 * storey - 0.15), Vec3(32.8, 1, 3 * storey + 0.15)));
  return parts;
}

inline constexpr std::uint32_t kTargets = 20;

/// A target behind the block, in one of three rows.
inline Faces targetFaces(std::uint32_t i) {
  const double x = -8 + 7.0 * (i % 7);
  const double y = 12 + 10.0 * (i / 7);
  return boxFaces(Vec3(x, y, 0), Vec3(x + 4, y + 4, 5 + 2.0 * (i % 3)));
}

}  // namespace lodestone
