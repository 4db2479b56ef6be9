#include "algorithms/rendering/ray_scene.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace lodestone {
namespace {

/// Surfaces that lie apart by less than this share of their distance are in one place.
constexpr float kTie = 1e-5F;

/// The hits of a ray that are as close as the closest one, as far as it is known.
///
/// Which of several equally close triangles Embree names depends on how its tree was built, and that on the
/// number of threads. So the filter lets the ray reach a hair beyond the closest hit that it has seen:
/// whatever the order, all hits within that hair come by, and the index decides.
class TiedHits {
 public:
  explicit TiedHits(float farthest) : farthest_(farthest) {}

  /// Takes note of a hit and says how far the ray has to go on.
  float add(const RayHit& hit) {
    if (hit.distance < nearest_) {
      nearest_ = hit.distance;
      reach_ = std::min(farthest_, nearest_ * (1 + kTie));
      const auto beyond = [&](const RayHit& other) { return other.distance > reach_; };
      count_ = static_cast<std::size_t>(std::remove_if(hits_.begin(), end(), beyond) - hits_.begin());
    }
    if (hit.distance <= reach_) keep(hit);
    return reach_;
  }

  [[nodiscard]] std::optional<RayHit> best() const {
    if (count_ == 0) return std::nullopt;
    return *std::max_element(hits_.begin(), hits_.begin() + static_cast<std::ptrdiff_t>(count_), lower);
  }

 private:
  static bool lower(const RayHit& a, const RayHit& b) { return a.triangle < b.triangle; }
  std::array<RayHit, 16>::iterator end() { return hits_.begin() + static_cast<std::ptrdiff_t>(count_); }

  /// In the place of the lowest where there is no other.
  void keep(const RayHit& hit) {
    if (count_ < hits_.size()) {
      hits_[count_++] = hit;
      return;
    }
    RayHit& lowest = *std::min_element(hits_.begin(), hits_.end(), lower);
    if (lower(lowest, hit)) lowest = hit;
  }

  float farthest_;
  float nearest_ = std::numeric_limits<float>::infinity();
  float reach_ = std::numeric_limits<float>::infinity();
  std::size_t count_ = 0;
  std::array<RayHit, 16> hits_;  ///< not set beyond `count_`
};

/// Of a bundle as of a single ray.
struct TieContext {
  RTCIntersectContext embree;
  std::array<TiedHits, 4> hits;  ///< by the number of the ray
};

/// Embree may ask for some rays of a bundle only.
void collectHits(const RTCFilterFunctionNArguments* arguments) {
  auto* context = reinterpret_cast<TieContext*>(arguments->context);
  const unsigned count = arguments->N;
  for (unsigned i = 0; i < count; ++i) {
    if (arguments->valid[i] == 0) continue;
    TiedHits& hits = context->hits[RTCRayN_id(arguments->ray, count, i)];
    float& farthest = RTCRayN_tfar(arguments->ray, count, i);
    farthest = hits.add({RTCHitN_primID(arguments->hit, count, i), farthest});
  }
}

RTCRay toEmbree(const Ray& ray) {
  RTCRay result{};
  result.org_x = ray.origin.x();
  result.org_y = ray.origin.y();
  result.org_z = ray.origin.z();
  result.dir_x = ray.direction.x();
  result.dir_y = ray.direction.y();
  result.dir_z = ray.direction.z();
  result.tnear = ray.nearest;
  result.tfar = ray.farthest;
  result.mask = 0xFFFFFFFFU;
  return result;
}

RTCRayHit toQuery(const Ray& ray) {
  RTCRayHit query{};
  query.ray = toEmbree(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

void fill(RTCRay4& bundle, const RayBundle& rays) {
  for (unsigned i = 0; i < rays.size(); ++i) {
    const RTCRay ray = toEmbree(rays[i]);
    bundle.org_x[i] = ray.org_x;
    bundle.org_y[i] = ray.org_y;
    bundle.org_z[i] = ray.org_z;
    bundle.dir_x[i] = ray.dir_x;
    bundle.dir_y[i] = ray.dir_y;
    bundle.dir_z[i] = ray.dir_z;
    bundle.tnear[i] = ray.tnear;
    bundle.tfar[i] = ray.tfar;
    bundle.mask[i] = ray.mask;
    bundle.id[i] = i;
  }
}

alignas(16) constexpr std::array<int, 4> kAllFour{-1, -1, -1, -1};

RTCIntersectContext besideEachOther() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

}  // namespace

struct RayScene::Impl {
  TriangleSoup soup;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(TriangleSoup soup) : impl_(std::make_unique<Impl>()) {
  impl_->soup = std::move(soup);
  // Embree may read 16 bytes at the last vertex.
  impl_->soup.vertices.emplace_back(Vec3f::Zero());
  // One instruction set, without fused multiply-add: the same digits on every machine.
  impl_->device = rtcNewDevice("isa=sse4.2");
  if (!impl_->device) throw std::runtime_error("Embree cannot start");
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                            RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  rtcSetSceneBuildQuality(impl_->scene, RTC_BUILD_QUALITY_MEDIUM);

  const TriangleSoup& shared = impl_->soup;
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, shared.vertices.data(),
                             0, sizeof(Vec3f), shared.vertices.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, shared.triangles.data(), 0,
                             sizeof(shared.triangles[0]), shared.triangles.size());
  rtcCommitGeometry(geometry);
  if (!shared.triangles.empty()) rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
  if (rtcGetDeviceError(impl_->device) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot build the scene");
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

const TriangleSoup& RayScene::soup() const {
  return impl_->soup;
}

std::optional<RayHit> RayScene::closest(const Ray& ray) const {
  TieContext context{{}, {TiedHits(ray.farthest), TiedHits(0), TiedHits(0), TiedHits(0)}};
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = collectHits;
  RTCRayHit query = toQuery(ray);
  rtcIntersect1(impl_->scene, &context.embree, &query);
  return context.hits[0].best();
}

std::array<std::optional<RayHit>, 4> RayScene::closestOfEach(const RayBundle& rays) const {
  TieContext context{besideEachOther(),
                     {TiedHits(rays[0].farthest), TiedHits(rays[1].farthest), TiedHits(rays[2].farthest),
                      TiedHits(rays[3].farthest)}};
  context.embree.filter = collectHits;
  RTCRayHit4 query{};
  fill(query.ray, rays);
  std::fill(std::begin(query.hit.geomID), std::end(query.hit.geomID), RTC_INVALID_GEOMETRY_ID);
  std::fill(std::begin(query.hit.instID[0]), std::end(query.hit.instID[0]), RTC_INVALID_GEOMETRY_ID);
  rtcIntersect4(kAllFour.data(), impl_->scene, &context.embree, &query);
  return {context.hits[0].best(), context.hits[1].best(), context.hits[2].best(), context.hits[3].best()};
}

bool RayScene::occluded(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = toEmbree(ray);
  rtcOccluded1(impl_->scene, &context, &query);
  return query.tfar < 0;
}

std::array<bool, 4> RayScene::occludedEach(const RayBundle& rays) const {
  RTCIntersectContext context = besideEachOther();
  RTCRay4 query{};
  fill(query, rays);
  rtcOccluded4(kAllFour.data(), impl_->scene, &context, &query);
  return {query.tfar[0] < 0, query.tfar[1] < 0, query.tfar[2] < 0, query.tfar[3] < 0};
}

}  // namespace lodestone
