#include "algorithms/rendering/texture_sampling.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/rendering/srgb_curve.h"

namespace lodestone {
namespace {

using Level = TexturePyramid::Level;

Vec3f texel(const Level& level, int column, int row) {
  const auto* rgba = &level.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width) +
                                      static_cast<std::size_t>(column))];
  return {decodeSrgb(rgba[0]), decodeSrgb(rgba[1]), decodeSrgb(rgba[2])};
}

/// Where an index beyond the border is. Beyond that of a mirrored image it is itself once more.
int wrapped(int index, int count, TextureWrap wrap) {
  if (wrap != TextureWrap::Repeat) return std::clamp(index, 0, count - 1);
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

/// Between the four texels around a coordinate.
Vec3f bilinear(const Level& level, const Vec2f& st, TextureWrap wrap) {
  const float x = st.x() * static_cast<float>(level.width) - 0.5F;
  const float y = st.y() * static_cast<float>(level.height) - 0.5F;
  const float left = std::floor(x);
  const float below = std::floor(y);
  const int column = static_cast<int>(left);
  const int row = static_cast<int>(below);
  const std::array<int, 2> columns{wrapped(column, level.width, wrap),
                                   wrapped(column + 1, level.width, wrap)};
  const std::array<int, 2> rows{wrapped(row, level.height, wrap), wrapped(row + 1, level.height, wrap)};
  const auto along = [&](int r) {
    const Vec3f a = texel(level, columns[0], r);
    return Vec3f(a + (x - left) * (texel(level, columns[1], r) - a));
  };
  const Vec3f low = along(rows[0]);
  return low + (y - below) * (along(rows[1]) - low);
}

Level halved(const Level& from) {
  Level half{std::max(1, from.width / 2), std::max(1, from.height / 2), {}};
  half.rgba.reserve(4 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  for (int row = 0; row < half.height; ++row) {
    for (int column = 0; column < half.width; ++column) {
      // Two texels each way; three where an odd number has to be shared out, one where there is but one.
      const int c0 = column * from.width / half.width;
      const int c1 = (column + 1) * from.width / half.width;
      const int r0 = row * from.height / half.height;
      const int r1 = (row + 1) * from.height / half.height;
      Vec3f sum = Vec3f::Zero();
      for (int r = r0; r < r1; ++r) {
        for (int c = c0; c < c1; ++c) sum += texel(from, c, r);
      }
      sum /= static_cast<float>((c1 - c0) * (r1 - r0));
      for (const float part : {sum.x(), sum.y(), sum.z()})
        half.rgba.push_back(static_cast<std::uint8_t>(255 * encodeSrgb(part) + 0.5F));
      half.rgba.push_back(255);
    }
  }
  return half;
}

/// Texture coordinates far away would not fit the numbers of texels.
Vec2f within(const Vec2f& st, TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::Repeat:
      return st - Vec2f(std::floor(st.x()), std::floor(st.y()));
    case TextureWrap::Mirror: {
      const Vec2f twice(st.x() - 2 * std::floor(st.x() / 2), st.y() - 2 * std::floor(st.y() / 2));
      return twice.cwiseMin(Vec2f(2, 2) - twice);
    }
    case TextureWrap::Clamp:
      break;
  }
  return st.cwiseMax(-1).cwiseMin(2);
}

}  // namespace

TexturePyramid makePyramid(TexturePyramid::Level image, TextureWrap wrap) {
  TexturePyramid pyramid;
  pyramid.wrap = wrap;
  pyramid.levels.push_back(std::move(image));
  while (pyramid.levels.back().width > 1 || pyramid.levels.back().height > 1)
    pyramid.levels.push_back(halved(pyramid.levels.back()));
  return pyramid;
}

TextureMap::TextureMap(const TexturePyramid& image, const std::array<Vec3f, 3>& corners,
                       const std::array<Vec2f, 3>& coordinates)
    : image_(&image),
      corner_(corners[0]),
      coordinate_(coordinates[0]),
      alongS_(Vec3f::Zero()),
      alongT_(Vec3f::Zero()) {
  const Vec3f ab = corners[1] - corners[0];
  const Vec3f ac = corners[2] - corners[0];
  const Vec3f normal = ab.cross(ac);
  const float squared = normal.squaredNorm();
  if (squared > 0) {
    // The gradients of the barycentric coordinates of the second and third corner.
    const Vec3f second = ac.cross(normal) / squared;
    const Vec3f third = normal.cross(ab) / squared;
    const Vec2f toSecond = coordinates[1] - coordinates[0];
    const Vec2f toThird = coordinates[2] - coordinates[0];
    alongS_ = toSecond.x() * second + toThird.x() * third;
    alongT_ = toSecond.y() * second + toThird.y() * third;
  }
  const Level& full = image.levels.front();
  texels_ = std::max(alongS_.norm() * static_cast<float>(full.width),
                     alongT_.norm() * static_cast<float>(full.height));
}

bool TextureMap::isFinite() const {
  constexpr float kFarthest = 1e6F;  // beyond that floats tell no texels apart
  return coordinate_.allFinite() && coordinate_.cwiseAbs().maxCoeff() < kFarthest && std::isfinite(texels_) &&
         alongS_.allFinite() && alongT_.allFinite();
}

Vec3f TextureMap::sample(const Vec3f& point, float size) const {
  const Vec3f to = point - corner_;
  const Vec2f st = within(coordinate_ + Vec2f(alongS_.dot(to), alongT_.dot(to)), image_->wrap);
  const auto last = static_cast<float>(image_->levels.size() - 1);
  const float wanted = std::clamp(std::log2(std::max(texels_ * size, 1.F)), 0.F, last);
  const auto finer = static_cast<std::size_t>(wanted);
  const Vec3f fine = bilinear(image_->levels[finer], st, image_->wrap);
  const float share = wanted - static_cast<float>(finer);
  if (share == 0) return fine;
  return fine + share * (bilinear(image_->levels[finer + 1], st, image_->wrap) - fine);
}

}  // namespace lodestone
