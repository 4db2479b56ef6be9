#include "algorithms/rendering/visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "algorithms/geometry/components.h"
#include "algorithms/geometry/parallel.h"
#include "algorithms/rendering/ray_scene.h"

namespace lodestone {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kGrey{150, 150, 150};
constexpr Colour kRed{214, 39, 40};

/// Coordinates from the eye: floats are finest there.
TriangleSoup soupOf(const OwnedTriangles& scene, const Vec3& eye) {
  TriangleSoup soup;
  soup.vertices.reserve(scene.vertices.size());
  for (const Vec3& vertex : scene.vertices) soup.vertices.push_back((vertex - eye).cast<float>());
  soup.triangles = scene.triangles;
  return soup;
}

CameraFrame frameOf(const Viewpoint& viewpoint) {
  Camera camera;
  camera.eye = Vec3::Zero();
  camera.target = viewpoint.direction;
  return frameOf(camera);
}

/// Blues and greens that differ from one index to the next.
Colour colourOf(std::uint32_t target) {
  const double turn = target * 0.61803398875;
  const double hue = 80 + 180 * (turn - std::floor(turn));  // degrees: from green to violet
  const double light = 0.55 + 0.25 * ((target * 7) % 4) / 3;
  Colour colour{};
  for (int i = 0; i < 3; ++i) {
    const double k = std::fmod(5 - 2 * i + hue / 60, 6);
    const double value = light * (1 - 0.7 * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
    colour[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255 * value));
  }
  return colour;
}

void addTriangles(const std::vector<Vec3>& vertices,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles, OwnedTriangles& scene) {
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), vertices.begin(), vertices.end());
  for (const auto& [a, b, c] : triangles) scene.triangles.push_back({first + a, first + b, first + c});
}

}  // namespace

void addBuildings(const CityModel& city, const std::function<std::uint32_t(std::uint32_t)>& ownerOf,
                  OwnedTriangles& scene) {
  std::vector<std::uint32_t> all(city.buildings.size());
  std::iota(all.begin(), all.end(), 0U);
  addBuildings(city, all, ownerOf, scene);
}

void addBuildings(const CityModel& city, std::span<const std::uint32_t> buildings,
                  const std::function<std::uint32_t(std::uint32_t)>& ownerOf, OwnedTriangles& scene) {
  const ComponentMesh mesh = makeComponentMesh(city, buildings);
  addTriangles(mesh.vertices, mesh.triangles, scene);
  for (const Component& component : mesh.components) {
    const std::uint32_t building = buildings[mesh.objects[component.object].building];
    scene.owner.insert(scene.owner.end(), component.triangleCount, ownerOf(building));
  }
}

void addMesh(const ComponentMesh& mesh, std::uint32_t owner, OwnedTriangles& scene) {
  addTriangles(mesh.vertices, mesh.triangles, scene);
  scene.owner.resize(scene.triangles.size(), owner);
}

Sighting lookFrom(const Viewpoint& viewpoint, const OwnedTriangles& scene, std::uint32_t targets,
                  const Progress& progress) {
  const RayScene rays(soupOf(scene, viewpoint.eye));
  const CameraFrame frame = frameOf(viewpoint);
  const double half = std::tan(viewpoint.angle * std::numbers::pi / 360);
  Sighting result{viewpoint.width, viewpoint.height, {}, std::vector<std::uint32_t>(targets, 0)};
  const auto width = static_cast<std::size_t>(viewpoint.width);
  result.who.assign(width * static_cast<std::size_t>(viewpoint.height), kNobody);
  forPiecesReported(
      static_cast<std::size_t>(viewpoint.height), 4, progress, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) {
          for (std::size_t x = 0; x < width; ++x) {
            const double right = (2 * (static_cast<double>(x) + 0.5) / viewpoint.width - 1) * half;
            const double up =
                (viewpoint.height - 2 * (static_cast<double>(y) + 0.5)) / viewpoint.width * half;
            const Vec3 along = (frame.forward + frame.right * right + frame.up * up).normalized();
            const auto hit =
                rays.closest({Vec3f::Zero(), along.cast<float>(), 0, static_cast<float>(viewpoint.distance)});
            if (hit) result.who[y * width + x] = scene.owner[hit->triangle];
          }
        }
      });
  progress.checkpoint();
  for (const std::uint32_t owner : result.who) {
    if (owner < targets) ++result.pixels[owner];
  }
  return result;
}

std::vector<std::uint32_t> seenOnlyIn(const Sighting& one, const Sighting& other) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t t = 0; t < one.pixels.size(); ++t) {
    if (one.sees(t) && !other.sees(t)) result.push_back(t);
  }
  return result;
}

Picture identityPicture(const Sighting& sighting, const Sighting& original) {
  Picture picture{sighting.width, sighting.height, {}};
  picture.rgba.reserve(4 * sighting.who.size());
  for (const std::uint32_t owner : sighting.who) {
    const Colour colour = owner == kNobody       ? kWhite
                          : owner == kBlocked    ? kGrey
                          : original.sees(owner) ? colourOf(owner)
                                                 : kRed;
    picture.rgba.insert(picture.rgba.end(), colour.begin(), colour.end());
    picture.rgba.push_back(255);
  }
  return picture;
}

double streetRate(double share) {
  constexpr std::array<double, 4> kRates{0, 0.3, 0.7, 0.95};
  const double at = 3 * std::clamp(share, 0.0, 1.0);
  const auto third = std::min<std::size_t>(2, static_cast<std::size_t>(at));
  return kRates[third] + (kRates[third + 1] - kRates[third]) * (at - static_cast<double>(third));
}

}  // namespace lodestone
