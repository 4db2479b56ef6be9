// Perception analysis of a made-up building of 400 components and about 100,000 triangles, from pictures to
// the classes of triangles, beside its bare primary rays (Embree alone, four a pixel, from the same cameras,
// on as many threads), with the share of each step. Arguments: --views N, --size PIXELS, --threads N,
// --textured.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "algorithms/geometry/components.h"
#include "algorithms/perception/difference_classes.h"
#include "algorithms/perception/hvs_filter.h"
#include "algorithms/perception/perceiving.h"
#include "algorithms/perception/viewpoints.h"
#include "algorithms/rendering/camera_rays.h"
#include "algorithms/rendering/texture_sampling.h"

#include "measuring.h"
#include "simplification_models.h"

namespace lodestone {
namespace {

struct Arguments {
  PerceiveOptions options;
  int threads = 0;
  bool textured = false;
};

Arguments parse(int argc, char** argv) {
  Arguments args;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--textured") {
      args.textured = true;
      continue;
    }
    const int value = i + 1 < argc ? std::atoi(argv[++i]) : 0;
    if (value <= 0) throw std::invalid_argument(name);
    if (name == "--views")
      args.options.views = value;
    else if (name == "--size")
      args.options.size = value;
    else if (name == "--threads")
      args.threads = value;
    else
      throw std::invalid_argument(name);
  }
  return args;
}

/// Embree as it comes: the same scene, and nothing but the closest hit.
class BareScene {
 public:
  explicit BareScene(const ComponentMesh& mesh) {
    origin_ = bounds(mesh).center();
    for (const Vec3& p : mesh.vertices) vertices_.push_back((p - origin_).cast<float>());
    vertices_.emplace_back(Vec3f::Zero());  // Embree may read 16 bytes at the last
    device_ = rtcNewDevice("isa=sse4.2");
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices_.data(), 0,
                               sizeof(Vec3f), vertices_.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(mesh.triangles[0]), mesh.triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~BareScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  BareScene(const BareScene&) = delete;
  BareScene& operator=(const BareScene&) = delete;

  /// Hits of all rays of a camera, so that none is left out by the compiler.
  [[nodiscard]] std::size_t cast(const Camera& camera) const {
    const CameraRays rays(camera, origin_);
    std::atomic<std::size_t> hits{0};
    tbb::parallel_for(0, camera.height, [&](int y) {
      std::size_t own = 0;
      for (int x = 0; x < camera.width; ++x) {
        for (std::size_t i = 0; i < CameraRays::kSamples; ++i) own += hit(rays.through(x, y, i)) ? 1 : 0;
      }
      hits += own;
    });
    return hits;
  }

 private:
  [[nodiscard]] bool hit(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x();
    query.ray.org_y = ray.origin.y();
    query.ray.org_z = ray.origin.z();
    query.ray.dir_x = ray.direction.x();
    query.ray.dir_y = ray.direction.y();
    query.ray.dir_z = ray.direction.z();
    query.ray.tfar = ray.farthest;
    query.ray.mask = 0xFFFFFFFFU;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &query);
    return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

  Vec3 origin_;
  std::vector<Vec3f> vertices_;
  RTCDevice device_;
  RTCScene scene_;
};

/// A brick-like pattern of 1024² texels.
std::shared_ptr<const ModelLook> patterned() {
  constexpr int kSize = 1024;
  TexturePyramid::Level level{kSize, kSize, {}};
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const bool joint = row % 64 < 6 || (column + (row / 64) % 2 * 64) % 128 < 6;
      const int grain = (row * 73 + column * 151) % 23;
      for (const int part :
           {joint ? 190 : 140 + grain, joint ? 185 : 80 + grain, joint ? 180 : 60 + grain, 255})
        level.rgba.push_back(static_cast<std::uint8_t>(part));
    }
  }
  auto look = std::make_shared<ModelLook>();
  look->textures.push_back(std::make_shared<const TexturePyramid>(makePyramid(std::move(level), TextureWrap::Repeat)));
  return look;
}

void print(const std::string& step, double time, double unit) {
  fmt::print("{:<28} {:>8.2f} s {:>7.2f}\n", step, time, time / unit);
}

/// Each step by itself over all views, views side by side as perceive() has them.
void printSteps(const ModelRenderer& renderer, const std::vector<Camera>& cameras,
                const PerceiveOptions& options, double unit) {
  std::vector<ModelPicture> rendered(cameras.size());
  const auto all = [&](const auto& work) {
    return seconds(
        [&] { tbb::parallel_for(std::size_t{0}, cameras.size(), work, tbb::simple_partitioner()); });
  };
  print("  rays and shading", all([&](std::size_t i) { rendered[i] = renderer.render(cameras[i]); }), unit);
  print("  filter", all([&](std::size_t i) { (void)filterAsSeen(rendered[i].grey, options); }), unit);
}

void run(const Arguments& args) {
  CityModel city = test::manyPartedBuilding();
  const std::uint32_t only = 0;
  ComponentMesh mesh = makeComponentMesh(city, {&only, 1});
  std::shared_ptr<const ModelLook> look;
  if (args.textured) {
    mesh = test::boxMapped(std::move(mesh));
    for (SurfaceInfo& surface : mesh.surfaces) surface.texture = 0;
    look = patterned();
  }
  const std::vector<Camera> cameras = viewpointsAround(bounds(mesh), args.options);
  fmt::print("{} triangles, {} views of {}²{}\n", mesh.triangleCount(), args.options.views, args.options.size,
             args.textured ? ", textured" : "");
  fmt::print("{:<28} {:>10} {:>7}\n", "", "", "× rays");
  const std::vector<Vec3> closer = closerViewpoints(bounds(mesh), args.options);
  const BareScene bare(mesh);
  const ModelRenderer renderer(mesh, look);
  double rays = std::numeric_limits<double>::infinity();
  double whole = rays;
  std::size_t hits = 0;
  Perception perception;
  // In turn, so that what else the machine does meets both alike.
  for (int round = 0; round < 3; ++round) {
    rays = std::min(rays, seconds([&] {
                      for (const Camera& camera : cameras) hits += bare.cast(camera);
                    }));
    whole = std::min(
        whole, seconds([&] { perception = perceive(renderer, cameras, args.options, {}, {}, closer); }));
  }
  print("bare primary rays", rays, rays);
  print("pictures to classes", whole, rays);
  printSteps(renderer, cameras, args.options, rays);
  std::vector<bool> unseen(perception.pixels.size());
  for (std::size_t t = 0; t < unseen.size(); ++t) unseen[t] = perception.pixels[t] == 0;
  print("  unseen once more", seconds([&] { (void)renderer.visibleFrom(closer, unseen); }), rays);
  double classes = seconds([&] { perception = judgedAgain(std::move(perception), args.options); });
  print("  classes of triangles", classes, rays);
  const double all = 3.0 * args.options.views * std::pow(args.options.size, 2) * CameraRays::kSamples;
  fmt::print("{:.2f} million rays a second, {:.0f}% of them meet the model\n", all / 3 / rays / 1e6,
             100 * static_cast<double>(hits) / all);
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  try {
    const lodestone::Arguments args = lodestone::parse(argc, argv);
    const auto threads =
        args.threads > 0 ? static_cast<std::size_t>(args.threads)
                         : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    lodestone::run(args);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
