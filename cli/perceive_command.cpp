#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algorithms/perception/perceiving.h"
#include "algorithms/perception/viewpoints.h"
#include "cli/camera_argument.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/folder_in_the_making.h"
#include "cli/perceive_flags.h"
#include "model/io/perception_json.h"

namespace lodestone::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  CityInput city;
  PerceiveOptions options;
  std::vector<std::string> cameras;
  bool pictures = true;
  std::string output;
};

/// Views of an earlier run that had more of them look as if they belonged to this one.
void tellLeftOvers(Run& run, const fs::path& folder, const std::vector<std::string>& written) {
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("view_") && !std::binary_search(written.begin(), written.end(), name))
      left.push_back(name);
  }
  if (left.empty()) return;
  const std::string more = left.size() == 1 ? "" : fmt::format(" and {} more", left.size() - 1);
  const std::string first = *std::min_element(left.begin(), left.end());
  run.add({diagnose(Code::OutputLeftOver, fmt::format("{}: {}{}", folder.string(), first, more))});
}

/// The pictures of the views, written as they come, by several threads; differences are kept until the
/// classes are known.
class ViewPictures {
 public:
  ViewPictures(fs::path folder, std::size_t views) : folder_(std::move(folder)), differences_(views) {}

  void take(std::size_t view, PerceivedView&& pictures) {
    write(view, "render", pictures.rendered.picture);
    write(view, "filtered", greyPicture(pictures.filtered));
    differences_[view] = std::move(pictures.difference);
  }

  void finish(const DifferenceClasses& classes) {
    for (std::size_t view = 0; view < differences_.size(); ++view) {
      write(view, "difference", differencePicture(differences_[view], classes));
      write(view, "classes", classPicture(differences_[view], classes));
    }
  }

  /// Of the first picture that could not be written.
  [[nodiscard]] const Diagnostics& failure() const { return failure_; }

 private:
  void write(std::size_t view, std::string_view what, const Picture& picture) {
    if (hasFailed()) return;
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(differences_.size() - 1).size());
    const Result<bool> written =
        writePicture(picture, folder_ / fmt::format("view_{:0{}}_{}.png", view, digits, what));
    if (written) return;
    const std::lock_guard lock(mutex_);
    if (failure_.empty()) failure_ = written.diagnostics;
  }

  [[nodiscard]] bool hasFailed() {
    const std::lock_guard lock(mutex_);
    return !failure_.empty();
  }

  fs::path folder_;
  std::vector<DifferenceImage> differences_;
  std::mutex mutex_;
  Diagnostics failure_;
};

/// Pictures to perceive are held to what --size may be: they are several, and all in memory. \throw Failure
/// (503)
void requireSize(const std::string& text, const Camera& camera) {
  const auto& table = fields<PerceiveOptions>();
  const auto size = std::find_if(table.begin(), table.end(), [](const auto& f) { return f.name == "size"; });
  if (std::max(camera.width, camera.height) <= size->max) return;
  throw Failure(
      diagnose(Code::OptionBadValue,
               fmt::format("camera \"{}\": {}x{} is more than perceive looks at; ask for a WxH of at "
                           "most {:.0f} pixels each, or for several cameras with a part each",
                           text, camera.width, camera.height, size->max)));
}

std::vector<Camera> camerasOf(const Arguments& args, const CityModel& city, const ComponentMesh& mesh) {
  if (args.cameras.empty()) return viewpointsAround(bounds(mesh), args.options);
  std::vector<Camera> cameras;
  for (const std::string& text : args.cameras) {
    cameras.push_back(parseCamera(text, city));
    requireSize(text, cameras.back());
  }
  return cameras;
}

/// The table: triangles by class, and where the classes begin.
void print(const Perception& perception, const std::array<std::uint32_t, kDetailClasses>& triangles,
           std::size_t unseen) {
  fmt::print("{:<10} {:>10} {:>9} {:>9} {:>9} {:>9}\n", "class", "triangles", "from", "mean", "sigma",
             "pixels");
  for (std::size_t c = 0; c < kDetailClasses; ++c) {
    const Gaussian& gaussian = perception.differences.gaussians[c];
    const int cut = c == 0 ? 0 : perception.differences.cuts[c - 1];
    const std::string from = cut < kDifferenceBins ? fmt::format("{:.2f}", binBegin(cut)) : "-";
    fmt::print("{:<10} {:>10} {:>9} {:>9.2f} {:>9.2f} {:>8.1f}%\n", toString(static_cast<DetailClass>(c)),
               triangles[c], from, gaussian.mean, gaussian.sigma, 100 * gaussian.prior);
  }
  fmt::print("{:<10} {:>10}\n", "unseen", unseen);
  const auto inPictures = static_cast<std::size_t>(std::count_if(
      perception.pixels.begin(), perception.pixels.end(), [](auto pixels) { return pixels > 0; }));
  const std::size_t glimpsed = perception.pixels.size() - unseen - inPictures;
  if (glimpsed > 0)
    fmt::print("{} triangles of class none are in no picture, but in sight from between the viewpoints\n",
               glimpsed);
}

bool showsTheModel(const Perception& perception) {
  return std::any_of(perception.pixels.begin(), perception.pixels.end(),
                     [](auto count) { return count > 0; });
}

void note(Run& run, const Perception& perception) {
  const auto [triangles, unseen] = countDetail(perception);
  run.figures["views"] = perception.cameras.size();
  run.figures["triangles"] = perception.classes.size();
  for (std::size_t c = 0; c < kDetailClasses; ++c)
    run.figures[fmt::format("triangles_{}", toString(static_cast<DetailClass>(c)))] = triangles[c];
  run.figures["triangles_unseen"] = unseen;
  if (run.options().quiet) return;
  if (showsTheModel(perception))
    print(perception, triangles, unseen);
  else
    fmt::print("none of {} views shows any of {} triangles\n", perception.cameras.size(),
               perception.classes.size());
}

void work(const Arguments& args, Run& run) {
  requireRisingThresholds(args.options);
  const auto city = args.city.load(run);
  const ComponentMesh mesh = meshOf(run, *city);
  requireSurfaces(mesh, args.city.paths);
  const std::vector<Camera> cameras = camerasOf(args, *city, mesh);
  tellCost(run, lookingCost(cameras, mesh.triangles.size(), threadsOf(run.options()), args.pictures),
           fmt::format("{} views", cameras.size()));
  if (city->buildings.size() > 1)
    run.add({diagnose(Code::LookedAtByGroup,
                      fmt::format("{} buildings fill each picture together", city->buildings.size()))});
  FolderInTheMaking folder(args.output);
  Diagnostics diagnostics;
  const auto look = run.stage("textures", [&](const Progress& progress) {
    return readModelLook(*city, mesh, &diagnostics, progress);
  });
  run.add(std::move(diagnostics));
  ViewPictures pictures(folder.path(), args.pictures ? cameras.size() : 0);
  ViewSink sink;
  if (args.pictures)
    sink = [&](std::size_t view, PerceivedView&& seen) { pictures.take(view, std::move(seen)); };
  const Perception perception = run.stage("perceive", [&](const Progress& progress) {
    const auto closer =
        args.cameras.empty() ? closerViewpoints(bounds(mesh), args.options) : std::vector<Vec3>();
    return perceive(ModelRenderer(mesh, look), cameras, args.options, progress, sink, closer);
  });
  pictures.finish(perception.differences);
  if (!pictures.failure().empty()) throw Failure(pictures.failure());
  if (!showsTheModel(perception))
    run.add({diagnose(Code::ModelNotSeen,
                      fmt::format("{} views of {}", cameras.size(), fmt::join(args.city.paths, ", ")))});
  std::vector<Camera> given;
  for (const Camera& camera : cameras) given.push_back(asGiven(camera, *city));
  writePerceivedTriangles(mesh, perception, folder.path() / "triangles.json");
  writePerceivedViews(perception, given, folder.path() / "views.json");
  const std::vector<std::string> files = folder.finish();
  for (const std::string& file : files) run.output["files"].push_back((folder.place() / file).string());
  tellLeftOvers(run, folder.place(), files);
  note(run, perception);
}

}  // namespace

void addPerceive(CLI::App& app, Chosen& chosen) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "perceive",
      "What of a model people perceive: pictures, what the eye filters away, classes of triangles");
  args->city.addTo(*command);
  addPerceiveFlags(*command, args->options);
  command
      ->add_option("--camera", args->cameras,
                   std::string("Look from here instead of from all around; may be given several times. ") +
                       kCameraHelp)
      ->allow_extra_args(false)
      ->excludes("--viewpoints")
      ->excludes("--views")
      ->excludes("--size");
  command->add_flag_callback(
      "--no-pictures", [args] { args->pictures = false; }, "Only the classes of triangles");
  command->add_option("-o,--output", args->output, "Folder for the pictures, views.json and triangles.json")
      ->required();
  command->callback([args, &chosen] { chosen = {"perceive", [args](Run& run) { work(*args, run); }}; });
}

}  // namespace lodestone::cli
