#include "algorithms/chains/chain_building.h"
#include "algorithms/merging/cutting.h"
#include "algorithms/rendering/rendering.h"
#include "cli/camera_argument.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/flags.h"

namespace lodestone::cli {

void addRender(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    CityInput city;
    TreeInput tree;
    CutOptions cut;
    std::string style = "plain";
    std::string camera = "fit";
    bool original = false;
    std::string output;
  };
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("render", "A picture, ray cast: needs no display");
  args->city.addTo(*command);
  args->tree.addMergeTo(*command);
  addFlags(*command, args->cut);
  command->add_option("--style", args->style, "Drawing style")->check(CLI::IsMember({"plain"}));
  command->add_option("--camera", args->camera, kCameraHelp);
  command->add_flag("--original", args->original, "Every building itself instead of what legible LOD draws");
  command->add_option("-o,--output", args->output, "Picture: " + pictureEndings())->required();
  command->callback([args, &chosen] {
    chosen = {"render", [args](Run& run) {
                if (auto why = whyNoPicture(args->output)) throw Failure(*why);
                const auto city = args->city.load(run);
                const Camera camera = parseCamera(args->camera, *city);
                LodLevel level;
                if (args->original) {
                  level = run.take(makeChain(city, nullptr, {})).levels.front();
                } else {
                  const auto tree = args->tree.build(run, *city);
                  level = levelOfCut(city, tree, makeCut(*tree, args->cut, camera));
                }
                run.figures["polygons_drawn"] = level.faces.polygons;
                run.figures["triangles_drawn"] = level.faces.triangles;
                const Picture picture = run.stage(
                    "render", [&](const Progress& progress) { return renderLevel(level, camera, progress); });
                (void)run.take(writePicture(picture, args->output));
                run.output["files"] = {args->output};
              }};
  });
}

}  // namespace lodestone::cli
