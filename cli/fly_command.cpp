#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algorithms/flights/fidelity.h"
#include "algorithms/flights/flight.h"
#include "algorithms/flights/made_paths.h"
#include "cli/camera_argument.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "model/io/atomic_file.h"
#include "model/io/flight_json.h"
#include "model/io/places/georeference.h"
#include "model/perceive_options.h"

namespace lodestone::cli {
namespace {

struct Arguments {
  CityInput city;
  TreeInput tree;
  CutOptions cut;
  CutOffOptions cutOff;
  std::string path = "ground-to-sky";
  std::string method = "legible";
  std::string size = "1280x800";
  double framesPerSecond = 30;
  std::uint32_t seed = 1;
  std::string savedPath;
  std::size_t compareEvery = 0;  ///< frames; 0: never
  double pixelsPerDegree = PerceiveOptions().pixelsPerDegree();
  std::string output;
};

std::vector<Box3> boxesOf(const CityModel& city) {
  std::vector<Box3> boxes;
  for (const Building& building : city.buildings) boxes.push_back(bounds(building));
  return boxes;
}

/// Keys of a file are in the input's CRS, as cameras are.
FlightPath localPath(FlightPath path, const CityModel& city) {
  if (city.crs.kind == CrsKind::Geographic) return path;
  for (KeyCamera& key : path.keys) {
    key.eye = toLocal(city, key.eye);
    key.target = toLocal(city, key.target);
  }
  return path;
}

FlightPath pathAsGiven(FlightPath path, const CityModel& city) {
  for (KeyCamera& key : path.keys) {
    const Camera camera = asGiven({key.eye, key.target}, city);
    key.eye = camera.eye;
    key.target = camera.target;
  }
  return path;
}

/// That of a file; nothing where the path is to be made.
std::optional<FlightPath> givenPath(Run& run, const Arguments& args) {
  if (args.path == "ground-to-sky" || args.path == "random") return std::nullopt;
  return run.take(loadFlightPath(args.path));
}

/// \throw Failure (618) where no building stands anywhere
FlightPath madePath(const Arguments& args, const CityModel& city) {
  const std::vector<Box3> boxes = boxesOf(city);
  const std::vector<Box3> worth = withoutStrays(boxes);
  if (worth.empty())
    throw Failure(diagnose(Code::ModelEmpty, fmt::format("{}", fmt::join(args.city.paths, ", "))));
  if (args.path == "ground-to-sky") return groundToSky(boxes);
  Box3 area;
  for (const Box3& box : worth) area.add(box);
  return randomPath(area, {.seed = args.seed});
}

std::unique_ptr<Switcher> switcherOf(const Arguments& args, const std::shared_ptr<const CityModel>& city,
                                     const std::shared_ptr<const ClusterTree>& tree) {
  if (args.method == "all") return visibleSwitcher(tree);
  if (args.method == "none") return everythingSwitcher(tree);
  if (args.method == "range" || args.method == "prism") {
    const auto levels = std::make_shared<const BuildingLevels>(city, args.cutOff);
    return args.method == "range" ? rangeSwitcher(tree, levels) : prismSwitcher(tree, levels);
  }
  return legibleSwitcher(tree, args.cut);
}

/// Beside each frame; nothing where no pictures were compared.
using FrameFidelity = std::vector<std::optional<PictureMeasures>>;

struct Flown {
  std::vector<FlightFrame> frames;
  FrameFidelity fidelity;
};

Flown flown(Run& run, const Arguments& args, const Camera& size, const std::shared_ptr<const CityModel>& city,
            const std::shared_ptr<const ClusterTree>& tree, const FlightPath& path) {
  std::optional<Fidelity> everything;
  if (args.compareEvery > 0) {
    everything = run.stage(
        "everything", [&](const Progress&) { return std::optional<Fidelity>(std::in_place, city, tree); });
  }
  return run.stage("fly", [&](const Progress& progress) {
    Flown result;
    const auto compare = [&](const FlightFrame&, const Cut& cut) {
      const bool turn = everything && result.fidelity.size() % args.compareEvery == 0;
      result.fidelity.push_back(turn ? std::optional(everything->measure(cut, args.pixelsPerDegree,
                                                                         Progress({}, progress.stopToken())))
                                     : std::nullopt);
    };
    const auto switcher = switcherOf(args, city, tree);
    result.frames =
        fly(*tree, *switcher, path, {args.framesPerSecond, size.width, size.height}, progress, compare);
    return result;
  });
}

void writeFrames(const std::vector<FlightFrame>& frames, const FrameFidelity& fidelity,
                 const ClusterTree& tree, const CityModel& city, const std::string& path) {
  AtomicFile file(path);
  std::ostream& out = file.stream();
  out << "time_s,eye_x,eye_y,eye_z,polygons,share,triangles,clusters,buildings,landmarks,culled,switches,"
         "pixel_error,flip,pick_ms\n";
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FlightFrame& frame = frames[i];
    const std::string measures =
        fidelity[i] ? fmt::format("{:.6f},{:.6f}", fidelity[i]->pixelError, fidelity[i]->flip) : ",";
    const Vec3 eye = asGiven(frame.camera, city).eye;
    out << fmt::format("{:.4f},{:.3f},{:.3f},{:.3f},{},{:.6f},{},{},{},{},{},{},{},{:.3f}\n", frame.time,
                       eye.x(), eye.y(), eye.z(), frame.faces.polygons,
                       share(frame.faces, tree.buildingFaces), frame.faces.triangles, frame.clusters,
                       frame.buildings, frame.landmarks, frame.culled, frame.switches, measures,
                       1000 * frame.pickTime);
  }
  file.commit();
}

void addFigures(Run& run, const std::vector<FlightFrame>& frames, const ClusterTree& tree, double seconds) {
  std::vector<double> shares;
  std::vector<double> times;
  std::uint64_t switches = 0;
  for (const FlightFrame& frame : frames) {
    shares.push_back(share(frame.faces, tree.buildingFaces));
    times.push_back(1000 * frame.pickTime);
    switches += frame.switches;
  }
  std::sort(shares.begin(), shares.end());
  std::sort(times.begin(), times.end());
  const double aSecond = seconds > 0 ? static_cast<double>(switches) / seconds : 0.0;
  run.figures["frames"] = frames.size();
  run.figures["share_median"] = shares[shares.size() / 2];
  run.figures["share_most"] = shares.back();
  run.figures["pick_ms_median"] = times[times.size() / 2];
  run.figures["pick_ms_most"] = times.back();
  run.figures["switches_a_second"] = aSecond;
  if (run.options().quiet) return;
  fmt::print("frames      {}, {:.1f} s\n", frames.size(), seconds);
  fmt::print("polygons    median {:.2f}%, at most {:.2f}% of {}\n", 100 * shares[shares.size() / 2],
             100 * shares.back(), tree.buildingFaces.polygons);
  fmt::print("switches    {}, {:.1f} a second\n", switches, aSecond);
  fmt::print("chosen in   median {:.2f} ms, at most {:.2f} ms\n", times[times.size() / 2], times.back());
}

/// Means over the frames that were compared.
void addFidelity(Run& run, const FrameFidelity& fidelity) {
  double count = 0;
  double error = 0;
  double flip = 0;
  for (const auto& frame : fidelity) {
    if (!frame) continue;
    ++count;
    error += frame->pixelError;
    flip += frame->flip;
  }
  if (count == 0) return;
  run.figures["frames_compared"] = count;
  run.figures["pixel_error_mean"] = error / count;
  run.figures["flip_mean"] = flip / count;
  if (run.options().quiet) return;
  fmt::print("pictures    {} compared: {:.2f}% of the pixels differ, mean FLIP {:.4f}\n", count,
             100 * error / count, flip / count);
}

void work(Run& run, const Arguments& args) {
  if (args.compareEvery > 0 && (args.method == "range" || args.method == "prism"))
    throw Failure(diagnose(Code::OptionsContradict,
                           "--compare: pictures are of buildings at their finest level; "
                           "take legible, all or none"));
  // What is wrong with these is said before minutes are spent on the city.
  Camera size;
  parseSize(args.size, args.size, size);
  const std::optional<FlightPath> given = givenPath(run, args);
  const auto city = args.city.load(run);
  const FlightPath path = given ? localPath(*given, *city) : madePath(args, *city);
  const auto tree = args.tree.build(run, *city);
  const Flown result = flown(run, args, size, city, tree, path);
  writeFrames(result.frames, result.fidelity, *tree, *city, args.output);
  run.output["files"] = {args.output};
  if (!args.savedPath.empty()) {
    AtomicFile file(args.savedPath);
    file.stream() << flightPathText(pathAsGiven(path, *city));
    file.commit();
    run.output["files"].push_back(args.savedPath);
  }
  addFigures(run, result.frames, *tree, path.duration());
  addFidelity(run, result.fidelity);
}

}  // namespace

void addFly(CLI::App& app, Chosen& chosen) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("fly", "What is drawn along a camera path, frame by frame");
  args->city.addTo(*command);
  args->tree.addMergeTo(*command);
  addFlags(*command, args->cut);
  command->add_option(
      "--path", args->path,
      "Camera path, JSON; or ground-to-sky: from the roofs of the densest place to all of the "
      "city, or random: 50 m above the ground at 20 m/s (default ground-to-sky)");
  command->add_option("--seed", args->seed, "Of a random path (default 1)");
  command
      ->add_option("--method", args->method,
                   "What chooses: legible; range, prism: every building in the picture, at one of its own "
                   "levels of detail; all: each at its finest; none: every building (default legible)")
      ->check(CLI::IsMember({"legible", "range", "prism", "all", "none"}));
  addFlags(*command, args->cutOff);
  command->add_option("--fps", args->framesPerSecond, "Frames for each second of the flight (default 30)")
      ->check(CLI::Range(0.01, 1000.0));
  command->add_option("--size", args->size, "Picture, WxH pixels (default 1280x800)");
  command->add_option(
      "--compare", args->compareEvery,
      "Compares every N-th frame with a picture of all buildings: share of pixels that differ, "
      "FLIP (default 0: none)");
  command->add_option("--ppd", args->pixelsPerDegree, "Pixels per degree of the viewer's sight, for FLIP")
      ->check(CLI::Range(1.0, 1000.0));
  command->add_option("--save-path", args->savedPath, "Writes the path that was flown, JSON");
  command->add_option("-o,--output", args->output, "Frames, CSV")->required();
  command->callback([args, &chosen] { chosen = {"fly", [args](Run& run) { work(run, *args); }}; });
}

}  // namespace lodestone::cli
