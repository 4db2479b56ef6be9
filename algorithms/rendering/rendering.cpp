#include "algorithms/rendering/rendering.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include "algorithms/rendering/camera_rays.h"
#include "algorithms/rendering/ground.h"
#include "algorithms/rendering/level_mesh.h"
#include "algorithms/rendering/ray_scene.h"
#include "model/level_colours.h"

namespace lodestone {
namespace {

constexpr std::array<float, 3> kGroundColour{0.79F, 0.81F, 0.80F};  // sRGB, as the ones below
constexpr std::array<float, 3> kHorizonColour{0.93F, 0.94F, 0.94F};
constexpr std::array<float, 3> kZenithColour{0.50F, 0.66F, 0.84F};
constexpr std::array<float, 3> kSunColour{1.00F, 0.965F, 0.90F};
constexpr float kSunStrength = 1.0F;
constexpr float kSkyStrength = 0.52F;
constexpr double kSunAzimuth = 225;   // degrees from north, clockwise: south-west, a planner's afternoon
constexpr double kSunElevation = 40;  // degrees
constexpr int kAmbientRays = 3;       // a sample

Vec3f linearColour(const std::array<float, 3>& srgb) {
  return {toLinear(srgb[0]), toLinear(srgb[1]), toLinear(srgb[2])};
}
Vec3f mix(const Vec3f& a, const Vec3f& b, float share) {
  return a + (b - a) * share;
}

/// A well-mixed number of two others (the output function of PCG over a linear step), for sampling without
/// state.
std::uint32_t hashOf(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = x * 0x9E3779B1U + y * 0x85EBCA77U + 0x27D4EB2FU;
  h = ((h >> ((h >> 28U) + 4U)) ^ h) * 277803737U;
  return (h >> 22U) ^ h;
}
float unitFloat(std::uint32_t h) {
  return static_cast<float>(h >> 8U) * 0x1p-24F;
}
float wrapUnit(float x) {
  return x - std::floor(x);
}

/// Any two axes across a unit vector (Duff et al. 2017, Building an Orthonormal Basis, Revisited).
std::pair<Vec3f, Vec3f> axesAcross(const Vec3f& n) {
  const float sign = std::copysign(1.F, n.z());
  const float a = -1 / (sign + n.z());
  const float b = n.x() * n.y() * a;
  return {Vec3f(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()),
          Vec3f(b, sign + n.y() * n.y() * a, -n.y())};
}

/// What a ray meets, ready to be lit.
struct SurfacePoint {
  Vec3f position;
  Vec3f normal;  // unit, towards the eye
  Vec3f albedo;  // linear
};

class Renderer {
 public:
  Renderer(LevelMesh mesh, const Camera& camera) : width_(camera.width), rays_(camera, mesh.origin) {
    Ground ground = makeGround(mesh.stands, mesh.box);
    groundPaint_ = static_cast<std::uint8_t>(mesh.colours.size());
    mesh.colours.push_back(kGroundColour);
    mesh.colours.push_back(surfaceColour(DrawRole::Building, SurfaceType::Ground));
    addGround(mesh, ground, groundPaint_, static_cast<std::uint8_t>(groundPaint_ + 1));
    for (const auto& colour : mesh.colours) colours_.push_back(linearColour(colour));
    paint_ = std::move(mesh.paint);
    groundLevel_ = static_cast<float>(ground.level - mesh.origin.z());

    const double size = mesh.box.size().norm();
    const double reach = mesh.box.empty() ? 100 : (camera.eye - mesh.origin).norm() + size / 2;
    haze_ = static_cast<float>(3 * std::max(reach, 50.0));
    skip_ = static_cast<float>(std::max(2e-3, size * 4e-7));
    ambientReach_ = static_cast<float>(std::clamp(size * 0.2, 3.0, 40.0));
    const double azimuth = kSunAzimuth * std::numbers::pi / 180;
    const double elevation = kSunElevation * std::numbers::pi / 180;
    toSun_ = Vec3(std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
                  std::sin(elevation))
                 .cast<float>();
    scene_ = std::make_unique<RayScene>(std::move(mesh.soup));
  }

  void renderRow(int y, std::uint8_t* rgba) const {
    for (int x = 0; x < width_; ++x) {
      Vec3f sum = Vec3f::Zero();
      for (std::size_t s = 0; s < CameraRays::kSamples; ++s) {
        sum += colourAlong(x, y, s).cwiseMax(0).cwiseMin(1);
      }
      sum /= CameraRays::kSamples;
      for (int c = 0; c < 3; ++c) *rgba++ = static_cast<std::uint8_t>(std::lround(toSrgb(sum[c]) * 255));
      *rgba++ = 255;
    }
  }

 private:
  [[nodiscard]] Vec3f colourAlong(int x, int y, std::size_t sample) const {
    const Ray ray = rays_.through(x, y, sample);
    const Vec3f& eye = ray.origin;
    const Vec3f& along = ray.direction;
    SurfacePoint point;
    float distance = 0;
    if (const auto hit = scene_->closest(ray)) {
      distance = hit->distance;
      point = pointOf(*hit, eye, along);
    } else if (along.z() < 0 && eye.z() > groundLevel_) {
      distance = (groundLevel_ - eye.z()) / along.z();
      point = {eye + along * distance, Vec3f::UnitZ(), colours_[groundPaint_]};
    } else {
      return skyColour(along);
    }
    const Vec3f lit =
        shade(point, hashOf(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)), sample);
    const float share = std::min(distance / haze_, 50.F);
    return mix(lit, linearColour(kHorizonColour), 1 - std::exp(-share * share));
  }

  [[nodiscard]] SurfacePoint pointOf(const RayHit& hit, const Vec3f& eye, const Vec3f& along) const {
    const TriangleSoup& soup = scene_->soup();
    const auto& corners = soup.triangles[hit.triangle];
    const Vec3f& a = soup.vertices[corners[0]];
    Vec3f normal = (soup.vertices[corners[1]] - a).cross(soup.vertices[corners[2]] - a).normalized();
    const bool isGround = paint_[hit.triangle] == groundPaint_;
    // The ground's triangles are an artefact of the grid: let their slopes be felt, not seen.
    if (isGround) normal = (normal + 2 * Vec3f::UnitZ()).normalized();
    if (normal.dot(along) > 0) normal = -normal;
    return {eye + along * hit.distance, normal, colours_[paint_[hit.triangle]]};
  }

  [[nodiscard]] Vec3f shade(const SurfacePoint& point, std::uint32_t seed, std::size_t sample) const {
    const Vec3f origin = point.position + point.normal * skip_;
    const float facing = point.normal.dot(toSun_);
    const float sun = facing > 0 && !scene_->occluded({origin, toSun_}) ? facing : 0;
    const float open = openness(origin, point.normal, seed, sample);
    const Vec3f sky = mix(linearColour(kGroundColour) * 0.55F,
                          linearColour(kHorizonColour).cwiseProduct(Vec3f(0.94F, 0.98F, 1.05F)),
                          0.5F + 0.5F * point.normal.z());
    const Vec3f light = linearColour(kSunColour) * (kSunStrength * sun) + sky * (kSkyStrength * open);
    return point.albedo.cwiseProduct(light);
  }

  /// Share of the surroundings within reach that is free, seen with the cosine of the angle to the normal.
  [[nodiscard]] float openness(const Vec3f& origin, const Vec3f& normal, std::uint32_t seed,
                               std::size_t sample) const {
    const auto [u, v] = axesAcross(normal);
    const float turn = unitFloat(seed);
    const float lift = unitFloat(hashOf(seed, 1));
    int open = 0;
    for (int k = 0; k < kAmbientRays; ++k) {
      const auto index = static_cast<float>(sample * kAmbientRays + static_cast<std::size_t>(k));
      constexpr auto kCount = static_cast<float>(CameraRays::kSamples * kAmbientRays);
      const float angle = 2 * std::numbers::pi_v<float> * wrapUnit(index * 0.61803399F + turn);
      const float radius = std::sqrt(wrapUnit(index / kCount + lift));
      const Vec3f along = u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)) +
                          normal * std::sqrt(std::max(0.F, 1 - radius * radius));
      const bool meetsGround = along.z() < 0 && (groundLevel_ - origin.z()) > along.z() * ambientReach_;
      if (!meetsGround && !scene_->occluded({origin, along, 0, ambientReach_})) ++open;
    }
    return static_cast<float>(open) / kAmbientRays;
  }

  [[nodiscard]] static Vec3f skyColour(const Vec3f& along) {
    const float height = std::clamp(along.z(), 0.F, 1.F);
    return mix(linearColour(kHorizonColour), linearColour(kZenithColour), 1 - std::exp(-3.2F * height));
  }

  int width_;
  CameraRays rays_;
  std::unique_ptr<RayScene> scene_;
  std::vector<std::uint8_t> paint_;
  std::vector<Vec3f> colours_;  // linear
  std::uint8_t groundPaint_ = 0;
  Vec3f toSun_ = Vec3f::UnitZ();
  float groundLevel_ = 0;
  float haze_ = 1;          // metres at which surfaces are two thirds hidden
  float skip_ = 0;          // metres by which rays start off a surface
  float ambientReach_ = 1;  // metres within which neighbours shade each other
};

}  // namespace

Picture renderLevel(const LodLevel& level, const Camera& camera, const Progress& progress) {
  const Renderer renderer(levelMesh(level, progress.part(0, 0.3, "mesh")), camera);
  progress.checkpoint();
  Picture picture{camera.width, camera.height, {}};
  const auto width = static_cast<std::size_t>(camera.width);
  picture.rgba.resize(width * static_cast<std::size_t>(camera.height) * 4);
  const Progress rows = progress.part(0.4, 1, "render");
  std::atomic<int> done{0};
  tbb::parallel_for(0, camera.height, [&](int y) {
    if (rows.stopRequested()) return;
    renderer.renderRow(y, picture.rgba.data() + static_cast<std::size_t>(y) * width * 4);
    rows.report(static_cast<double>(++done) / camera.height);
  });
  progress.checkpoint();
  return picture;
}

Box3 bounds(const LodLevel& level) {
  return levelMesh(level).box;
}

}  // namespace lodestone
