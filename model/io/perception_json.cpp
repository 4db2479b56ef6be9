#include "model/io/perception_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/io/atomic_file.h"
#include "model/io/json_options.h"
#include "model/io/json_writing.h"

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

Json toJson(const Camera& camera) {
  return {{"eye", toJson(camera.eye)},
          {"target", toJson(camera.target)},
          {"fov", camera.fov},
          {"size", {camera.width, camera.height}}};
}

Json classNames() {
  Json names = Json::array();
  for (std::size_t c = 0; c < kDetailClasses; ++c) names.push_back(toString(static_cast<DetailClass>(c)));
  return names;
}

/// Least difference of each class but the first; null where no difference is so great. A class that begins
/// where the next one does is empty.
Json thresholds(const DifferenceClasses& classes) {
  Json list = Json::array();
  for (const int cut : classes.cuts) list.push_back(cut < kDifferenceBins ? Json(binBegin(cut)) : Json());
  return list;
}

Json gaussians(const DifferenceClasses& classes) {
  Json list = Json::array();
  for (const Gaussian& gaussian : classes.gaussians)
    list.push_back({{"prior", gaussian.prior}, {"mean", gaussian.mean}, {"sigma", gaussian.sigma}});
  return list;
}

}  // namespace

void writePerceivedTriangles(const ComponentMesh& mesh, const Perception& perception,
                             const std::filesystem::path& path) {
  AtomicFile file(path);
  std::ostream& out = file.stream();
  out << "{\"type\": \"perception\", \"version\": 1, \"classes\": " << classNames().dump()
      << ",\n \"components\": [";
  for (std::size_t c = 0; c < mesh.components.size(); ++c)
    out << (c ? ",\n  " : "\n  ")
        << fmt::format("{{\"id\": {}, \"source\": {}, \"first_triangle\": {}, \"triangles\": {}}}", c,
                       jsonQuoted(mesh.objects[mesh.components[c].object].id),
                       mesh.components[c].firstTriangle, mesh.components[c].triangleCount);
  out << "],\n \"triangles\": [";
  const char* before = "\n  ";
  for (std::size_t t = 0; t < perception.classes.size(); ++t) {
    if (!perception.isSeen(t)) continue;
    out << before
        << fmt::format("{{\"triangle\": {}, \"class\": {}, \"pixels\": {}}}", t,
                       static_cast<int>(perception.classes[t]), perception.pixels[t]);
    before = ",\n  ";
  }
  out << "],\n \"unseen\": [";
  before = "";
  for (std::size_t t = 0; t < perception.classes.size(); ++t) {
    if (perception.isSeen(t)) continue;
    out << before << t;
    before = ", ";
  }
  out << "]}\n";
  file.commit();
}

void writePerceivedViews(const Perception& perception, std::span<const Camera> cameras,
                         const std::filesystem::path& path) {
  Json views = Json::array();
  for (const Camera& camera : cameras) views.push_back(toJson(camera));
  const Json document{{"type", "views"},
                      {"version", 1},
                      {"options", toJson(values(perception.options))},
                      {"pixels_per_degree", perception.options.pixelsPerDegree()},
                      {"classes", classNames()},
                      {"thresholds", thresholds(perception.differences)},
                      {"gaussians", gaussians(perception.differences)},
                      {"views", std::move(views)}};
  AtomicFile file(path);
  file.stream() << document.dump(1) << "\n";
  file.commit();
}

}  // namespace lodestone
