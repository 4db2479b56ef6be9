#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <fmt/format.h>

#include "algorithms/rendering/visibility.h"
#include "algorithms/simplification/city_simplification.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "model/io/atomic_file.h"
#include "model/io/places/georeference.h"

namespace lodestone::cli {
namespace {

struct Arguments {
  CityInput models;
  std::vector<std::string> targets;
  std::vector<std::string> street;
  std::vector<double> eye;
  std::vector<double> towards;
  Viewpoint viewpoint;
  std::vector<int> size{1024, 512};
  std::string output;
  std::string picture;
};

using CityPointer = std::shared_ptr<const CityModel>;

/// One picture's worth: a model, the street's buildings at the rates of their distances.
struct Level {
  std::string name;
  CityPointer city;
  Sighting sighting;
};

/// What stands in view, in the frame of `frame`.
class Scenes {
 public:
  /// `targets` is null where the buildings of the models are the targets themselves.
  Scenes(CityPointer frame, CityPointer targets) : frame_(std::move(frame)), targets_(std::move(targets)) {
    const CityModel& named = targets_ ? *targets_ : *frame_;
    for (const Building& building : named.buildings) {
      indexOf_.emplace(building.object.id, static_cast<std::uint32_t>(ids_.size()));
      ids_.push_back(building.object.id);
    }
  }

  [[nodiscard]] const std::vector<std::string>& ids() const { return ids_; }

  [[nodiscard]] OwnedTriangles with(const CityModel& model) const {
    OwnedTriangles scene;
    if (targets_)
      place(
          *targets_, [](std::uint32_t building) { return building; }, scene);
    place(
        model,
        [&](std::uint32_t building) {
          if (targets_) return kBlocked;
          const auto found = indexOf_.find(model.buildings[building].object.id);
          return found == indexOf_.end() ? kBlocked : found->second;
        },
        scene);
    return scene;
  }

 private:
  void place(const CityModel& model, const std::function<std::uint32_t(std::uint32_t)>& ownerOf,
             OwnedTriangles& scene) const {
    const std::size_t first = scene.vertices.size();
    addBuildings(model, ownerOf, scene);
    if (&model == frame_.get() || frame_->crs.kind == CrsKind::Geographic) return;
    const std::span<Vec3> added = std::span(scene.vertices).subspan(first);
    toWorld(model, added);
    toLocal(*frame_, added);
  }

  CityPointer frame_;
  CityPointer targets_;
  std::vector<std::string> ids_;
  std::unordered_map<std::string, std::uint32_t> indexOf_;
};

Viewpoint viewpointOf(const Arguments& args, const CityModel& frame) {
  Viewpoint viewpoint = args.viewpoint;
  const auto place = [&](const std::vector<double>& p) {
    const Vec3 point(p[0], p[1], p[2]);
    return frame.crs.kind == CrsKind::Geographic ? point : toLocal(frame, point);
  };
  viewpoint.eye = place(args.eye);
  viewpoint.direction = place(args.towards) - viewpoint.eye;
  if (viewpoint.direction.norm() == 0)
    throw Failure(diagnose(Code::OptionBadValue, "--viewpoint and --towards are the same point"));
  viewpoint.width = args.size[0];
  viewpoint.height = args.size[1];
  return viewpoint;
}

/// A point of one model's frame in another's. Geographic models are taken as they stand, as Scenes takes
/// them.
Vec3 inFrameOf(const CityModel& city, const CityModel& frame, const Vec3& point) {
  if (&city == &frame || frame.crs.kind == CrsKind::Geographic) return point;
  return toLocal(city, toWorld(frame, point));
}

/// The street of figure 18: the farther a group of touching buildings from the eye (in the frame of the
/// city), the coarser.
CityPointer streetOf(Run& run, CityPointer city, const std::string& method, const Vec3& eye,
                     double distance) {
  SimplifyOptions options;
  (void)setValues(options, {{"method", method}});
  const auto rate = [&](const std::vector<std::uint32_t>& group) {
    double nearest = distance;
    for (const std::uint32_t b : group) {
      const Box3 box = bounds(city->buildings[b]);
      if (box.empty()) continue;
      const Vec3 closest = eye.cwiseMax(box.min).cwiseMin(box.max);
      nearest = std::min(nearest, (closest - eye).norm());
    }
    return streetRate(nearest / distance);
  };
  return run
      .take(run.stage("simplify",
                      [&](const Progress& progress) { return simplifyCity(city, options, progress, rate); }))
      .city;
}

nlohmann::ordered_json toJson(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

nlohmann::ordered_json toJson(const Level& level, const Sighting& original) {
  nlohmann::ordered_json visible = nlohmann::ordered_json::array();
  for (std::uint32_t t = 0; t < level.sighting.pixels.size(); ++t) {
    if (level.sighting.sees(t)) visible.push_back({{"target", t}, {"pixels", level.sighting.pixels[t]}});
  }
  return {{"source", level.name},
          {"visible", std::move(visible)},
          {"appeared", seenOnlyIn(level.sighting, original)},
          {"vanished", seenOnlyIn(original, level.sighting)}};
}

void writeAnswer(const Arguments& args, const Viewpoint& viewpoint, const std::vector<std::string>& ids,
                 const std::vector<Level>& levels) {
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  for (const Level& level : levels) models.push_back(toJson(level, levels.front().sighting));
  const nlohmann::ordered_json answer{{"type", "visibility"},
                                      {"version", 1},
                                      {"viewpoint",
                                       {{"eye", args.eye},
                                        {"towards", args.towards},
                                        {"direction", toJson(viewpoint.direction.normalized())},
                                        {"angle", viewpoint.angle},
                                        {"distance", viewpoint.distance},
                                        {"size", {viewpoint.width, viewpoint.height}}}},
                                      {"targets", ids},
                                      {"models", std::move(models)}};
  AtomicFile file(args.output);
  file.stream() << answer.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
  file.commit();
}

/// The levels' pictures below each other.
Picture stacked(const std::vector<Level>& levels) {
  Picture all;
  for (const Level& level : levels) {
    const Picture one = identityPicture(level.sighting, levels.front().sighting);
    all.width = one.width;
    all.height += one.height;
    all.rgba.insert(all.rgba.end(), one.rgba.begin(), one.rgba.end());
  }
  return all;
}

void printTable(const std::vector<Level>& levels) {
  std::size_t width = 0;
  for (const Level& level : levels) width = std::max(width, level.name.size());
  fmt::print("{:<{}} {:>8} {:>9} {:>9}\n", "model", width, "visible", "appeared", "vanished");
  const Sighting& original = levels.front().sighting;
  for (const Level& level : levels) {
    const auto visible = std::count_if(level.sighting.pixels.begin(), level.sighting.pixels.end(),
                                       [](std::uint32_t pixels) { return pixels > 0; });
    fmt::print("{:<{}} {:>8} {:>9} {:>9}\n", level.name, width, visible,
               seenOnlyIn(level.sighting, original).size(), seenOnlyIn(original, level.sighting).size());
  }
}

CityPointer loadOne(Run& run, const Arguments& args, const std::vector<std::string>& paths) {
  CityInput input = args.models;
  input.paths = paths;
  return input.load(run);
}

/// A level that stands elsewhere hides nothing: GLB and OBJ hold local metres, and do not say from where.
void sayWhatStandsElsewhere(Run& run, const CityModel& original, const Level& level) {
  const auto worldBox = [](const CityModel& city) {
    Box3 box;
    for (const Building& building : city.buildings) {
      Box3 own = bounds(building);
      if (own.empty()) continue;
      std::array<Vec3, 2> ends{own.min, own.max};
      toWorld(city, ends);
      for (const Vec3& end : ends) box.add(end);
    }
    return box;
  };
  const Box3 there = worldBox(original);
  const Box3 here = worldBox(*level.city);
  if (there.empty() || here.empty()) return;
  const Vec3 apart = (here.min - there.max).cwiseMax(there.min - here.max).cwiseMax(0);
  if (apart.head<2>().norm() == 0) return;
  run.add({diagnose(
      Code::InputsFarApart,
      fmt::format("{} does not stand where {} does; levels as CityJSON or CityGML keep their place",
                  level.name, original.sources.empty() ? "the original" : original.sources.front().path))});
}

/// A viewpoint in other coordinates than the model's sees nothing, and would not say why.
void sayWhereNothingIsInReach(Run& run, const CityModel& frame, const Viewpoint& viewpoint) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Building& building : frame.buildings) {
    const Box3 box = bounds(building);
    if (!box.empty())
      nearest = std::min(nearest, (viewpoint.eye.cwiseMax(box.min).cwiseMin(box.max) - viewpoint.eye).norm());
  }
  if (nearest > viewpoint.distance && std::isfinite(nearest))
    run.add({diagnose(Code::InputsFarApart,
                      fmt::format("the nearest building is {:.0f} m from --viewpoint, and sight goes {:g} m",
                                  nearest, viewpoint.distance))});
}

void work(const Arguments& args, Run& run) {
  if (!args.picture.empty()) {
    if (auto why = whyNoPicture(args.picture)) throw Failure(*why);
  }
  const CityPointer targets = args.targets.empty() ? nullptr : loadOne(run, args, args.targets);
  std::vector<Level> levels;
  for (const std::string& path : args.models.paths) levels.push_back({path, loadOne(run, args, {path}), {}});
  for (const Level& level : levels) sayWhatStandsElsewhere(run, *levels.front().city, level);
  const CityPointer frame = targets ? targets : levels.front().city;
  const Viewpoint viewpoint = viewpointOf(args, *frame);
  sayWhereNothingIsInReach(run, *frame, viewpoint);
  const CityPointer street = levels.front().city;
  const Vec3 eye = inFrameOf(*street, *frame, viewpoint.eye);
  for (const std::string& method : args.street)
    levels.push_back({"street, " + method, streetOf(run, street, method, eye, viewpoint.distance), {}});
  const Scenes scenes(frame, targets);
  for (Level& level : levels)
    level.sighting = run.stage("look", [&](const Progress& progress) {
      return lookFrom(viewpoint, scenes.with(*level.city), static_cast<std::uint32_t>(scenes.ids().size()),
                      progress);
    });
  writeAnswer(args, viewpoint, scenes.ids(), levels);
  run.output["files"] = {args.output};
  if (!args.picture.empty()) {
    (void)run.take(writePicture(stacked(levels), args.picture));
    run.output["files"].push_back(args.picture);
  }
  run.figures["targets"] = scenes.ids().size();
  run.figures["models"] = levels.size();
  if (!run.options().quiet) printTable(levels);
}

}  // namespace

void addVisibility(CLI::App& app, Chosen& chosen) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("visibility", "Which buildings are seen past a model, and past each of its levels");
  command
      ->add_option("MODEL", args->models.paths,
                   "The original, then its levels: each stands in view by itself")
      ->required();
  addFlags(*command, args->models.options);
  command->add_option(
      "--targets", args->targets,
      "City whose buildings are looked for; without it the models' own, matched by their ids");
  command
      ->add_option("--street", args->street,
                   "A level more for each method: the first model at 0–30, 30–70 and 70–95% by distance")
      ->check(CLI::IsMember({"topology", "qem", "qem-optimal", "vertex-clustering"}));
  const auto point = [&](const std::string& name, std::vector<double>& value, const std::string& help) {
    command->add_option(name, value, help)->required()->delimiter(',')->expected(3)->type_name("x,y,z");
  };
  point("--viewpoint", args->eye, "Where somebody stands, in the coordinates of the targets");
  point("--towards", args->towards, "A point that is looked to");
  command->add_option("--angle", args->viewpoint.angle, "Horizontal opening, degrees (default 60)")
      ->check(CLI::Range(0.1, 169.0));
  command->add_option("--distance", args->viewpoint.distance, "How far sight goes, metres (default 1000)")
      ->check(CLI::Range(0.01, 1e7));
  command->add_option("--size", args->size, "Pixels of the picture (default 1024x512)")
      ->delimiter('x')
      ->expected(2)
      ->type_name("WxH")
      ->check(CLI::Range(1, 16384));
  command->add_option("-o,--output", args->output, "Answer, JSON")->required();
  command->add_option("--picture", args->picture,
                      "Identity pictures of all models below each other: " + pictureEndings());
  command->callback([args, &chosen] { chosen = {"visibility", [args](Run& run) { work(*args, run); }}; });
}

}  // namespace lodestone::cli
