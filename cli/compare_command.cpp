#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "algorithms/perception/flip.h"
#include "cli/commands.h"
#include "cli/compare_models.h"
#include "cli/folder_in_the_making.h"
#include "cli/perceive_flags.h"
#include "model/io/atomic_file.h"

namespace lodestone::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void comparePictureFiles(const CompareArguments& args, Run& run) {
  run.input = {{"a", args.first}, {"b", args.second}};
  const Picture a = run.take(readPicture(args.first));
  const Picture b = run.take(readPicture(args.second));
  if (a.width != b.width || a.height != b.height)
    throw Failure(diagnose(Code::PicturesUnlike,
                           fmt::format("{} × {} and {} × {}", a.width, a.height, b.width, b.height)));
  const FlipMap map =
      run.stage("flip", [&](const Progress& progress) { return flip(a, b, args.degree(), progress); });
  const double pixels = pixelError(a, b);
  if (!args.output.empty()) (void)run.take(writePicture(flipPicture(map), outputOf(args, run, "flip.png")));
  writeComparison(args, run,
                  {{"type", "comparison"},
                   {"version", 1},
                   {"kind", "pictures"},
                   {"a", {{"source", args.first}}},
                   {"b", {{"source", args.second}}},
                   {"size", {a.width, a.height}},
                   {"pixels_per_degree", args.degree()},
                   {"flip", map.mean},
                   {"pixel_error", pixels}});
  run.figures["flip"] = map.mean;
  run.figures["pixel_error"] = pixels;
  run.figures["pixels_per_degree"] = args.degree();
  if (run.options().quiet) return;
  fmt::print(
      "ꟻLIP         {:.6f}  mean, at {:.1f} pixels a degree\npixel error  {:.6f}  share of pixels that "
      "differ\n",
      map.mean, args.degree(), pixels);
}

/// One that is not there is found out before minutes are spent on the other.
void requireBoth(const CompareArguments& args) {
  for (const std::string& path : {args.first, args.second}) {
    std::error_code error;
    if (!fs::exists(path, error)) throw Failure(diagnose(Code::FileNotFound, path));
  }
}

void work(CompareArguments args, Run& run) {
  requireBoth(args);
  const bool picture = isPicturePath(args.first);
  if (picture != isPicturePath(args.second))
    throw Failure(diagnose(Code::InputsUnlike,
                           fmt::format("{} is a picture, {} is none", picture ? args.first : args.second,
                                       picture ? args.second : args.first)));
  std::optional<FolderInTheMaking> folder;
  if (!args.output.empty()) args.unfinished = folder.emplace(args.output).path().string();
  if (picture)
    comparePictureFiles(args, run);
  else
    compareModelFiles(args, run);
  if (folder) (void)folder->finish();
}

/// What would be ignored in silence is refused.
void refuseMeaningless(const CLI::App& command, const CompareArguments& args) {
  if (args.pixelsPerDegree > 0)
    refuseGiven(command, {"--distance", "--screen-width", "--screen-resolution"},
                "means nothing beside --ppd, which stands for the display and its distance");
  if (!isPicturePath(args.first) || !isPicturePath(args.second)) return;
  const std::string why = "is for models; two pictures are compared as they are";
  refuseGiven(command, {"--views", "--viewpoints", "--size", "--turn", "--plain"}, why);
  refuseGiven(command, flagsOf<ImportOptions>(), why);
}

}  // namespace

std::string outputOf(const CompareArguments& args, Run& run, const std::string& name) {
  const fs::path path = fs::path(args.output) / name;
  for (const std::string& input : {args.first, args.second}) {
    std::error_code notThere;
    if (fs::equivalent(path, input, notThere))
      throw Failure(diagnose(Code::OutputExists, input + " is an input"));
  }
  run.output["files"].push_back(path.string());
  return (fs::path(args.unfinished) / name).string();
}

void writeComparison(const CompareArguments& args, Run& run, const Json& comparison) {
  if (args.output.empty()) return;
  writeFile(outputOf(args, run, "comparison.json"),
            comparison.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void addCompare(CLI::App& app, Chosen& chosen) {
  auto args = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "How different two pictures or two models look (ꟻLIP, pixel error), and how far models lie apart");
  command->add_option("A", args->first, "Picture or model that counts as the reference")->required();
  command->add_option("B", args->second, "The other")->required();
  addFlags(*command, args->import);
  addPerceiveFlags(*command, args->perceive);
  for (const char* unused :
       {"--csf", "--slight", "--moderate", "--dramatic"})  // of classes, which are not asked for
    command->remove_option(command->get_option(unused));
  command
      ->add_option("--ppd", args->pixelsPerDegree,
                   "Pixels in a degree of sight, in place of those of the display [0.1–100000]")
      ->check(CLI::Range(0.1, 1e5));
  command
      ->add_option(
          "--turn", args->turn,
          "Turn of the viewpoints around the models against those that perceive looks from: 1 is a full "
          "turn; of street views, from one to the next (default 0.5)")
      ->check(CLI::Range(0.0, 1.0));
  command->add_flag("--plain", args->plain,
                    "Models without their textures and materials: what differs is their shape");
  command->add_option("-o,--output", args->output, "Folder for difference pictures and comparison.json");
  command->callback([args, command, &chosen] {
    chosen = {"compare", [args, command](Run& run) {
                refuseMeaningless(*command, *args);
                work(*args, run);
              }};
  });
}

}  // namespace lodestone::cli
