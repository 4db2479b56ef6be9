#include "cli/compare_models.h"

#include <fmt/format.h>

#include "algorithms/geometry/triangle_tree.h"
#include "algorithms/perception/comparison.h"
#include "algorithms/perception/viewpoints.h"
#include "algorithms/simplification/deviation.h"
#include "algorithms/simplification/object_contacts.h"
#include "cli/camera_argument.h"
#include "cli/city_input.h"
#include "cli/perceive_flags.h"
#include "model/io/places/georeference.h"

namespace lodestone::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Model {
  std::string path;
  std::shared_ptr<const CityModel> city;
  ComponentMesh mesh;  ///< in the frame of the first model
};

struct Measures {
  std::vector<Camera> cameras;
  ModelComparison pictures;
  Deviation deviation;
  ObjectContacts contacts;

  [[nodiscard]] std::size_t count(ContactFate fate) const {
    return static_cast<std::size_t>(
        std::count_if(contacts.contacts.begin(), contacts.contacts.end(),
                      [&](const ContactReport& contact) { return contact.fate == fate; }));
  }
  [[nodiscard]] double widestGap() const {
    double widest = 0;
    for (const ContactReport& contact : contacts.contacts) widest = std::max(widest, contact.gap);
    return widest;
  }
};

Model load(const CompareArguments& args, Run& run, const std::string& path) {
  CityInput input;
  input.paths = {path};
  input.options = args.import;
  run.setSubject(path);
  Model model{path, input.load(run), {}};
  model.mesh = meshOf(run, *model.city);
  requireSurfaces(model.mesh, input.paths);
  run.setSubject({});
  return model;
}

Box3 boxOf(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& point : points) box.add(point);
  return box;
}

bool standsOnEarth(const CityModel& city) {
  return city.crs.kind == CrsKind::Projected || city.crs.kind == CrsKind::Geographic;
}

/// Files of models that stand on earth hold millimetres: two ends of a contact that were rounded apart.
constexpr double kRounding = 0.002;

/// Brings the second model into the frame of the first. A file without a coordinate system and near 0 (GLB,
/// OBJ, as we write levels) may hold the first one's local metres: it is taken so where it does not stand
/// beside the first by what it says.
void placeBeside(Run& run, const Model& first, Model& second) {
  const CityModel& a = *first.city;
  const CityModel& b = *second.city;
  if (standsOnEarth(a) && standsOnEarth(b) && (a.crs.kind != b.crs.kind || a.crs.epsg != b.crs.epsg))
    throw Failure(
        diagnose(Code::CrsTransformFailed, fmt::format("{} is in {}, {} in {}; compare models of one system",
                                                       first.path, a.crs.name, second.path, b.crs.name)));
  if (a.crs == b.crs && a.origin == b.origin) return;
  std::vector<Vec3> placed = second.mesh.vertices;
  toWorld(b, placed);
  toLocal(a, placed);
  const Box3 box = boxOf(first.mesh.vertices);
  const auto saysNothing = [](const CityModel& city) {
    return !standsOnEarth(city) && city.origin == Vec3::Zero();
  };
  const bool apart = !meet(box, boxOf(placed));
  if (apart && (saysNothing(a) || saysNothing(b)) && meet(box, boxOf(second.mesh.vertices))) return;
  second.mesh.vertices = std::move(placed);
  if (apart && !box.empty() && !second.mesh.vertices.empty())
    run.add({diagnose(Code::InputsFarApart,
                      fmt::format("{} does not stand where {} does", second.path, first.path))});
}

std::shared_ptr<const ModelLook> lookOf(const CompareArguments& args, Run& run, const Model& model) {
  if (args.plain) return nullptr;
  run.setSubject(model.path);
  Diagnostics diagnostics;
  auto look = run.stage("textures", [&](const Progress& progress) {
    return readModelLook(*model.city, model.mesh, &diagnostics, progress);
  });
  run.add(std::move(diagnostics));
  run.setSubject({});
  return look;
}

ModelComparison lookAt(const CompareArguments& args, Run& run, const Model& first, const Model& second,
                       const std::vector<Camera>& cameras) {
  const ModelRenderer rendererA(first.mesh, lookOf(args, run, first));
  const ModelRenderer rendererB(second.mesh, lookOf(args, run, second));
  const auto write = [&](std::size_t view, const char* what, const Picture& picture) {
    (void)run.take(writePicture(picture, outputOf(args, run, fmt::format("view_{:02}_{}.png", view, what))));
  };
  ComparedViewSink sink;
  if (!args.output.empty()) {
    sink = [&](std::size_t view, ComparedView&& pictures) {
      write(view, "a", pictures.first);
      write(view, "b", pictures.second);
      write(view, "flip", flipPicture(pictures.difference));
    };
  }
  return run.stage("look", [&](const Progress& progress) {
    return compareModels(rendererA, rendererB, cameras, args.degree(), progress, sink);
  });
}

Measures measure(const CompareArguments& args, Run& run, const Model& first, const Model& second) {
  Measures measures;
  Box3 box = boxOf(first.mesh.vertices);
  const Box3 other = boxOf(second.mesh.vertices);
  box.add(other.min);
  box.add(other.max);
  measures.cameras = viewpointsAround(box, args.perceive, args.turn);
  LookingCost cost = lookingCost(measures.cameras, 0, threadsOf(run.options()), false);
  for (double* twice : {&cost.pixels, &cost.bytes, &cost.seconds}) *twice *= 2;
  tellCost(run, cost, fmt::format("{} views of each of two models", measures.cameras.size()));
  measures.pictures = lookAt(args, run, first, second, measures.cameras);
  measures.deviation = run.stage(
      "deviation", [&](const Progress& progress) { return deviation(first.mesh, second.mesh, 0, progress); });
  measures.contacts = run.stage("contacts", [&](const Progress& progress) {
    const std::vector<std::string> names = buildingIds(*first.city);
    const std::vector<std::string> others = buildingIds(*second.city);
    return followObjects({first.mesh, names}, {second.mesh, others},
                         standsOnEarth(*first.city) ? kRounding : 0, progress);
  });
  return measures;
}

Json toJson(const PictureMeasures& measures) {
  return {{"flip", measures.flip},
          {"flip_shown", measures.flipShown},
          {"pixel_error", measures.pixelError},
          {"shown", measures.shown}};
}

Json toJson(const Camera& camera) {
  return {{"eye", {camera.eye.x(), camera.eye.y(), camera.eye.z()}},
          {"target", {camera.target.x(), camera.target.y(), camera.target.z()}},
          {"fov", camera.fov},
          {"size", {camera.width, camera.height}}};
}

Json toJson(const Model& model) {
  return {{"source", model.path},
          {"buildings", model.city->buildings.size()},
          {"components", model.mesh.components.size()},
          {"vertices", model.mesh.vertices.size()},
          {"triangles", model.mesh.triangles.size()}};
}

/// Null where the models have no object of one name: then nothing can be followed, and nothing is lost.
Json contactsJson(const Measures& measures) {
  if (measures.contacts.named == 0) return nullptr;
  return {{"of", measures.contacts.partsUnknown ? "buildings" : "objects"},
          {"objects_in_both", measures.contacts.named},
          {"contacts", measures.contacts.contacts.size()},
          {"kept", measures.count(ContactFate::Kept)},
          {"separated", measures.count(ContactFate::Separated)},
          {"lost", measures.count(ContactFate::Lost)},
          {"unfollowed", measures.contacts.unfollowed},
          {"widest_gap_m", measures.widestGap()}};
}

Json answerOf(const CompareArguments& args, const Model& first, const Model& second,
              const Measures& measures) {
  Json answer{{"type", "comparison"}, {"version", 1},        {"kind", "models"},
              {"a", toJson(first)},   {"b", toJson(second)}, {"pixels_per_degree", args.degree()}};
  answer.update(toJson(measures.pictures.all));
  answer["hausdorff_m"] = measures.deviation.hausdorff();
  answer["a_to_b_m"] = measures.deviation.forward;
  answer["b_to_a_m"] = measures.deviation.backward;
  answer["contacts"] = contactsJson(measures);
  answer["views"] = Json::array();
  for (std::size_t i = 0; i < measures.cameras.size(); ++i) {
    Json view{{"camera", toJson(asGiven(measures.cameras[i], *first.city))}};
    view.update(toJson(measures.pictures.views[i]));
    answer["views"].push_back(std::move(view));
  }
  return answer;
}

void printContacts(const Model& first, const Model& second, const Measures& measures) {
  const ObjectContacts& contacts = measures.contacts;
  if (contacts.objects < 2) {
    fmt::print(
        "contacts     none to follow: {} is one object, and what touches within it has no "
        "name (simplify counts that)\n",
        first.path);
  } else if (contacts.named == 0) {
    fmt::print(
        "contacts     not followed: {} names none of the objects of {}; a GLB does not name its buildings, "
        "CityJSON names buildings and parts\n",
        second.path, first.path);
  } else {
    fmt::print(
        "contacts     {} between {}: {} kept, {} separated, {} lost, widest gap {:.3f} m; {} not "
        "followed\n",
        contacts.contacts.size(), contacts.partsUnknown ? "buildings" : "objects",
        measures.count(ContactFate::Kept), measures.count(ContactFate::Separated),
        measures.count(ContactFate::Lost), measures.widestGap(), contacts.unfollowed);
  }
  if (contacts.named > 0 && contacts.partsUnknown)
    fmt::print("             {} has no parts of buildings: theirs are not followed\n", second.path);
}

void print(const Model& first, const Model& second, const Measures& measures) {
  const auto row = [](const char* what, std::size_t a, std::size_t b) {
    fmt::print("{:<12} {:>12} {:>12}\n", what, a, b);
  };
  fmt::print("{:<12} {:>12} {:>12}\n", "", "A", "B");
  row("buildings", first.city->buildings.size(), second.city->buildings.size());
  row("components", first.mesh.components.size(), second.mesh.components.size());
  row("vertices", first.mesh.vertices.size(), second.mesh.vertices.size());
  row("triangles", first.mesh.triangles.size(), second.mesh.triangles.size());
  const PictureMeasures& all = measures.pictures.all;
  fmt::print("ꟻLIP         {:.6f}  mean of {} views; {:.6f} where a model is seen\n", all.flip,
             measures.cameras.size(), all.flipShown);
  fmt::print("pixel error  {:.6f}  share of pixels that differ\n", all.pixelError);
  fmt::print("Hausdorff    {:.3f} m  A to B {:.3f}, B to A {:.3f}\n", measures.deviation.hausdorff(),
             measures.deviation.forward, measures.deviation.backward);
  printContacts(first, second, measures);
}

}  // namespace

void compareModelFiles(const CompareArguments& args, Run& run) {
  const Model first = load(args, run, args.first);
  const Json inputA = run.input;
  Model second = load(args, run, args.second);
  run.input = {{"a", inputA}, {"b", run.input}};
  placeBeside(run, first, second);
  const Measures measures = measure(args, run, first, second);
  if (measures.pictures.all.shown == 0)
    run.add({diagnose(Code::ModelNotSeen, fmt::format("{} views of {} and {}", measures.cameras.size(),
                                                      args.first, args.second))});
  const Json answer = answerOf(args, first, second, measures);
  writeComparison(args, run, answer);
  run.figures = answer;
  for (const char* told : {"type", "version"}) run.figures.erase(told);
  if (!run.options().quiet) print(first, second, measures);
}

}  // namespace lodestone::cli
