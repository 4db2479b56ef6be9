#include "algorithms/rendering/model_rendering.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include "algorithms/geometry/parallel.h"
#include "algorithms/rendering/camera_rays.h"
#include "algorithms/rendering/fixed_lights.h"
#include "algorithms/rendering/ray_scene.h"
#include "algorithms/rendering/srgb_curve.h"
#include "algorithms/rendering/texture_sampling.h"

namespace lodestone {
namespace {

// sRGB. Middle grey: a brighter or darker one would make outlines, which people see best, the greatest
// differences of all.
constexpr float kBackground = 0.5F;
constexpr std::array<float, 3> kPlain{0.8F, 0.8F, 0.8F};  // sRGB, of surfaces without a material
/// Share of the model's diagonal by which rays start off a surface.
constexpr double kSkip = 2e-5;

/// How a triangle looks: Lambert's light does not depend on the camera, but for the side that is seen.
struct Surface {
  Vec3f normal;               ///< unit
  float front = 1;            ///< brightness of the side that the normal points away from
  float back = 1;             ///< of the other side
  Vec3f colour;               ///< linear
  std::int32_t texture = -1;  ///< index into the mapped textures
};

/// Whose pixel it is: the triangle that most samples show; of equally many the one of the earlier sample.
std::uint32_t majority(const std::array<std::uint32_t, CameraRays::kSamples>& triangles) {
  std::uint32_t best = triangles[0];
  std::ptrdiff_t most = 0;
  for (const std::uint32_t triangle : triangles) {
    const auto count = std::count(triangles.begin(), triangles.end(), triangle);
    if (count > most) {
      most = count;
      best = triangle;
    }
  }
  return best;
}

}  // namespace

struct ModelRenderer::Impl {
  Vec3 origin = Vec3::Zero();
  float skip = 0;  ///< metres by which rays start off a surface
  std::shared_ptr<const ModelLook> look;
  std::vector<Surface> surfaces;
  std::vector<TextureMap> maps;  ///< of the textured triangles
  std::unique_ptr<RayScene> scene;

  void addSurface(const ComponentMesh& mesh, std::uint32_t t);
  void addMap(const ComponentMesh& mesh, std::uint32_t t, Surface& surface);
  [[nodiscard]] Vec3f colourAt(const RayHit& hit, const Ray& ray, float spread) const;
  [[nodiscard]] bool isVisible(std::uint32_t triangle, const std::vector<Vec3f>& eyes) const;
  void renderPixel(const CameraRays& rays, int x, int y, ModelPicture& result) const;
};

void ModelRenderer::Impl::addMap(const ComponentMesh& mesh, std::uint32_t t, Surface& surface) {
  const std::int32_t texture = mesh.surfaces[t].texture;
  if (!look || texture < 0 || static_cast<std::size_t>(texture) >= look->textures.size()) return;
  const TexturePyramid* image = look->textures[static_cast<std::size_t>(texture)].get();
  if (!image || mesh.textureCoordinates.empty()) return;
  const auto& coordinates = mesh.textureCoordinates[t];
  if (!std::all_of(coordinates.begin(), coordinates.end(), [](const Vec2f& st) { return st.allFinite(); }))
    return;
  std::array<Vec3f, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = (mesh.vertices[mesh.triangles[t][i]] - origin).cast<float>();
  const TextureMap map(*image, corners, coordinates);
  if (!map.isFinite()) return;
  surface.texture = static_cast<std::int32_t>(maps.size());
  maps.push_back(map);
}

void ModelRenderer::Impl::addSurface(const ComponentMesh& mesh, std::uint32_t t) {
  static const FixedLights lights;
  Surface surface;
  const Vec3 area = areaNormal(mesh, t);
  const Vec3 normal = area.norm() > 0 ? area.normalized() : Vec3::Zero();
  surface.normal = normal.cast<float>();
  surface.front = static_cast<float>(lights.brightness(normal));
  surface.back = static_cast<float>(lights.brightness(-normal));
  const std::int32_t material = mesh.surfaces[t].material;
  const bool known = look && material >= 0 && static_cast<std::size_t>(material) < look->materials.size();
  const std::array<float, 3>& colour = known ? look->materials[static_cast<std::size_t>(material)] : kPlain;
  surface.colour = Vec3f(toLinear(colour[0]), toLinear(colour[1]), toLinear(colour[2]));
  addMap(mesh, t, surface);
  surfaces.push_back(surface);
}

Vec3f ModelRenderer::Impl::colourAt(const RayHit& hit, const Ray& ray, float spread) const {
  const Surface& surface = surfaces[hit.triangle];
  const float facing = surface.normal.dot(ray.direction);
  const float light = facing <= 0 ? surface.front : surface.back;
  if (surface.texture < 0) return surface.colour * light;
  const TextureMap& map = maps[static_cast<std::size_t>(surface.texture)];
  // Seen at a grazing angle a pixel covers a long strip: between its width and its length.
  const float size = spread * hit.distance / std::sqrt(std::max(std::abs(facing), 0.05F));
  return map.sample(ray.origin + ray.direction * hit.distance, size) * light;
}

ModelRenderer::ModelRenderer(const ComponentMesh& mesh, std::shared_ptr<const ModelLook> look)
    : impl_(std::make_unique<Impl>()) {
  const Box3 box = bounds(mesh);
  if (!box.empty()) impl_->origin = box.center();
  impl_->skip = static_cast<float>(kSkip * box.size().norm());
  impl_->look = std::move(look);
  TriangleSoup soup;
  for (const Vec3& p : mesh.vertices) soup.vertices.push_back((p - impl_->origin).cast<float>());
  soup.triangles = mesh.triangles;
  impl_->surfaces.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) impl_->addSurface(mesh, t);
  impl_->scene = std::make_unique<RayScene>(std::move(soup));
}

ModelRenderer::~ModelRenderer() = default;
ModelRenderer::ModelRenderer(ModelRenderer&&) noexcept = default;
ModelRenderer& ModelRenderer::operator=(ModelRenderer&&) noexcept = default;

std::uint32_t ModelRenderer::triangleCount() const {
  return static_cast<std::uint32_t>(impl_->surfaces.size());
}

void ModelRenderer::Impl::renderPixel(const CameraRays& rays, int x, int y, ModelPicture& result) const {
  static const Vec3f background = Vec3f::Constant(toLinear(kBackground));
  Vec3f sum = Vec3f::Zero();
  std::array<std::uint32_t, CameraRays::kSamples> triangles{};
  const RayBundle bundle = rays.through(x, y);
  const auto hits = scene->closestOfEach(bundle);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    triangles[i] = hits[i] ? hits[i]->triangle : kNoTriangle;
    sum += hits[i] ? colourAt(*hits[i], bundle[i], rays.spread()) : background;
  }
  sum /= CameraRays::kSamples;
  const std::size_t place = static_cast<std::size_t>(y) * static_cast<std::size_t>(result.picture.width) +
                            static_cast<std::size_t>(x);
  std::uint8_t* rgba = &result.picture.rgba[4 * place];
  for (int c = 0; c < 3; ++c) rgba[c] = static_cast<std::uint8_t>(255 * encodeSrgb(sum[c]) + 0.5F);
  rgba[3] = 255;
  result.grey.pixels[place] = 255 * encodeSrgb(luminance(sum));
  result.triangle[place] = majority(triangles);
}

ModelPicture ModelRenderer::render(const Camera& camera, const Progress& progress) const {
  const std::size_t pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  ModelPicture result;
  result.picture = {camera.width, camera.height, std::vector<std::uint8_t>(pixels * 4)};
  result.grey = {camera.width, camera.height, std::vector<float>(pixels)};
  result.triangle.resize(pixels);
  const CameraRays rays(camera, impl_->origin);
  std::atomic<int> done{0};
  tbb::parallel_for(0, camera.height, [&](int y) {
    if (progress.stopRequested()) return;
    for (int x = 0; x < camera.width; ++x) impl_->renderPixel(rays, x, y, result);
    progress.report(static_cast<double>(++done) / camera.height);
  });
  progress.checkpoint();
  return result;
}

bool ModelRenderer::Impl::isVisible(std::uint32_t triangle, const std::vector<Vec3f>& eyes) const {
  const TriangleSoup& soup = scene->soup();
  const auto& [a, b, c] = soup.triangles[triangle];
  const std::array<Vec3f, 3> corners{soup.vertices[a], soup.vertices[b], soup.vertices[c]};
  const Vec3f middle = (corners[0] + corners[1] + corners[2]) / 3;
  std::array<Vec3f, 4> points{middle, middle, middle, middle};
  for (std::size_t i = 0; i < 3; ++i) points[i] = middle + 0.85F * (corners[i] - middle);
  const Vec3f& normal = surfaces[triangle].normal;
  return std::any_of(eyes.begin(), eyes.end(), [&](const Vec3f& eye) {
    const float side = normal.dot(eye - middle) < 0 ? -1.F : 1.F;
    RayBundle rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Vec3f from = points[i] + side * skip * normal;
      rays[i] = {from, eye - from, 0, 1};
    }
    const std::array<bool, 4> occluded = scene->occludedEach(rays);
    return std::find(occluded.begin(), occluded.end(), false) != occluded.end();
  });
}

std::vector<bool> ModelRenderer::visibleFrom(const std::vector<Vec3>& eyes, const std::vector<bool>& asked,
                                             const Progress& progress) const {
  std::vector<Vec3f> places;
  for (const Vec3& eye : eyes) places.push_back((eye - impl_->origin).cast<float>());
  std::vector<std::uint8_t> visible(asked.size(), 0);  // bits of one byte would be of several threads
  forPiecesReported(asked.size(), 64, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t)
      visible[t] = asked[t] && impl_->isVisible(static_cast<std::uint32_t>(t), places) ? 1 : 0;
  });
  progress.checkpoint();
  return {visible.begin(), visible.end()};
}

}  // namespace lodestone
