#include "algorithms/perception/flip_colours.h"

#include <array>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>

#include "algorithms/geometry/vector_clones.h"
#include "algorithms/perception/vector_math.h"
#include "algorithms/rendering/srgb_curve.h"

namespace lodestone {
namespace {

/// Linear light of sRGB's primaries to XYZ over the XYZ of their white, and back.
struct Primaries {
  std::array<float, 9> toXyz;  ///< by rows
  std::array<float, 9> fromXyz;
};

/// From the chromaticities that IEC 61966-2-1 names: red, green, blue, and D65.
Primaries primaries() {
  Eigen::Matrix3d columns;
  columns << 0.64, 0.30, 0.15, 0.33, 0.60, 0.06, 0.03, 0.10, 0.79;
  const Eigen::Vector3d white = Eigen::Vector3d(0.3127, 0.3290, 0.3583) / 0.3290;
  const Eigen::Vector3d shares = columns.inverse() * white;
  const Eigen::Matrix3d toXyz =
      white.cwiseInverse().asDiagonal() * columns * Eigen::Matrix3d(shares.asDiagonal());
  const Eigen::Matrix3d fromXyz = toXyz.inverse();
  Primaries result{};
  for (int i = 0; i < 9; ++i) {
    result.toXyz[static_cast<std::size_t>(i)] = static_cast<float>(toXyz(i / 3, i % 3));
    result.fromXyz[static_cast<std::size_t>(i)] = static_cast<float>(fromXyz(i / 3, i % 3));
  }
  return result;
}

const Primaries& srgbPrimaries() {
  static const Primaries result = primaries();
  return result;
}

struct Lab {
  float l;
  float a;
  float b;
};

inline float clamped(float x) {
  return std::min(std::max(x, 0.0F), 1.0F);
}

/// The curve of L*a*b*, straight below (6/29)³.
inline float labCurve(float x) {
  constexpr float kEdge = 216.0F / 24389;
  constexpr float kSlope = 841.0F / 108;
  const float root = cubeRoot(std::max(x, kEdge));
  return x > kEdge ? root : kSlope * x + 4.0F / 29;
}

/// Hunt-adjusted L*a*b* (equation 3): in dim places colours look less colourful.
inline Lab huntLab(float x, float y, float z) {
  const float fy = labCurve(y);
  const float l = 116 * fy - 16;
  return {l, 0.01F * l * 500 * (labCurve(x) - fy), 0.01F * l * 200 * (fy - labCurve(z))};
}

/// Of a filtered pixel, whose colour may lie outside what a display can show.
inline Lab filteredLab(const Primaries& p, float y, float cx, float cz) {
  const float x = y + cx;
  const float z = y - cz;
  const auto& f = p.fromXyz;
  const float red = clamped(f[0] * x + f[1] * y + f[2] * z);
  const float green = clamped(f[3] * x + f[4] * y + f[5] * z);
  const float blue = clamped(f[6] * x + f[7] * y + f[8] * z);
  const auto& t = p.toXyz;
  return huntLab(t[0] * red + t[1] * green + t[2] * blue, t[3] * red + t[4] * green + t[5] * blue,
                 t[6] * red + t[7] * green + t[8] * blue);
}

/// HyAB (equation 4): large differences of colours are judged so.
inline float hyab(const Lab& a, const Lab& b) {
  const float da = a.a - b.a;
  const float db = a.b - b.b;
  return std::abs(a.l - b.l) + std::sqrt(da * da + db * db);
}

constexpr float kExponent = 0.7F;    // q_c
constexpr float kKnee = 0.4F;        // p_c: share of the largest difference
constexpr float kKneeError = 0.95F;  // p_t: the error there

/// q_c-th power of the difference between green and blue: the largest that a display can show.
float largestDifference(const Primaries& p) {
  const auto& t = p.toXyz;
  return raised(hyab(huntLab(t[1], t[4], t[7]), huntLab(t[2], t[5], t[8])), kExponent);
}

}  // namespace

LODESTONE_VECTOR_CLONES
static void opponents(const float* light, std::size_t count, const std::array<float, 9>& m, float* yOut,
                      float* cxOut, float* czOut) {
  for (std::size_t i = 0; i < count; ++i) {
    const float red = light[i];
    const float green = light[count + i];
    const float blue = light[2 * count + i];
    const float x = m[0] * red + m[1] * green + m[2] * blue;
    const float y = m[3] * red + m[4] * green + m[5] * blue;
    const float z = m[6] * red + m[7] * green + m[8] * blue;
    yOut[i] = y;
    cxOut[i] = x - y;
    czOut[i] = y - z;
  }
}

void toOpponent(const std::uint8_t* rgba, std::size_t count, const OpponentRow& out) {
  constexpr std::size_t kBlock = 256;
  std::array<float, 3 * kBlock> light;
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t size = std::min(kBlock, count - first);
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint8_t* pixel = rgba + 4 * (first + i);
      light[i] = decodeSrgb(pixel[0]);
      light[size + i] = decodeSrgb(pixel[1]);
      light[2 * size + i] = decodeSrgb(pixel[2]);
    }
    opponents(light.data(), size, srgbPrimaries().toXyz, out.y + first, out.cx + first, out.cz + first);
  }
}

LODESTONE_VECTOR_CLONES
static void differences(const Primaries& p, const OpponentRow& r, const OpponentRow& t, std::size_t count,
                        float largest, float* out) {
  const float knee = kKnee * largest;
  const float below = kKneeError / knee;
  const float above = (1 - kKneeError) / (largest - knee);
  for (std::size_t i = 0; i < count; ++i) {
    const float distance =
        hyab(filteredLab(p, r.y[i], r.cx[i], r.cz[i]), filteredLab(p, t.y[i], t.cx[i], t.cz[i]));
    const float d = raised(distance, kExponent);
    out[i] = clamped(d < knee ? below * d : kKneeError + above * (d - knee));
  }
}

void colourDifferences(const OpponentRow& reference, const OpponentRow& test, std::size_t count, float* out) {
  static const float largest = largestDifference(srgbPrimaries());
  differences(srgbPrimaries(), reference, test, count, largest, out);
}

}  // namespace lodestone
