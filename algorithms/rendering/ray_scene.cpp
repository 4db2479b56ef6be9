#include "algorithms/rendering/ray_scene.h"

#include <algorithm>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace lodestone {
namespace {

/// Of all triangles in a short stretch of a ray, the one of highest index.
struct TieContext {
  RTCIntersectContext embree;
  RayHit best;
  bool found = false;
};

/// Takes note of a hit and refuses it, so that the search goes on.
void collectHit(const RTCFilterFunctionNArguments* arguments) {
  auto* context = reinterpret_cast<TieContext*>(arguments->context);
  const RayHit hit{RTCHitN_primID(arguments->hit, arguments->N, 0),
                   RTCRayN_tfar(arguments->ray, arguments->N, 0)};
  if (!context->found || hit.triangle > context->best.triangle) {
    context->best = hit;
    context->found = true;
  }
  arguments->valid[0] = 0;
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
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query = toQuery(ray);
  rtcIntersect1(impl_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  // Which of several equally close triangles Embree names depends on how its tree was built, and that on the
  // number of threads: look at the short stretch around the hit again and decide by index.
  const RayHit first{query.hit.primID, query.ray.tfar};
  const float slack = 1e-5F * first.distance;
  TieContext ties;
  rtcInitIntersectContext(&ties.embree);
  ties.embree.filter = collectHit;
  Ray stretch = ray;
  stretch.nearest = std::max(ray.nearest, first.distance - slack);
  stretch.farthest = std::min(ray.farthest, first.distance + slack);
  query = toQuery(stretch);
  rtcIntersect1(impl_->scene, &ties.embree, &query);
  return ties.found ? ties.best : first;
}

bool RayScene::occluded(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = toEmbree(ray);
  rtcOccluded1(impl_->scene, &context, &query);
  return query.tfar < 0;
}

}  // namespace lodestone
