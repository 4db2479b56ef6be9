#include "algorithms/merging/cutting.h"
#include "cli/camera_argument.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "model/io/dendrogram_json.h"

namespace lodestone::cli {

void addCut(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    CityInput city;
    TreeInput tree;
    CutOptions cut;
    std::string camera = "fit";
    std::string output;
  };
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("cut", "What legible LOD draws from one camera");
  args->city.addTo(*command);
  args->tree.addMergeTo(*command);
  addFlags(*command, args->cut);
  command->add_option("--camera", args->camera, kCameraHelp)->required();
  command->add_option("-o,--output", args->output, "Cut, JSON")->required();
  command->callback([args, &chosen] {
    chosen = {"cut", [args](Run& run) {
                const auto city = args->city.load(run);
                const Camera camera = parseCamera(args->camera, *city);
                const auto tree = args->tree.build(run, *city);
                Cut cut =
                    run.stage("cut", [&](const Progress&) { return makeCut(*tree, args->cut, camera); });
                cut.camera = asGiven(cut.camera, *city);
                writeCut(cut, args->output);
                run.figures["drawn"] = cut.drawn.size();
                run.figures["culled"] = cut.culled.size();
                run.figures["polygons_drawn"] = cut.faces.polygons;
                run.figures["triangles_drawn"] = cut.faces.triangles;
                run.output["files"] = {args->output};
              }};
  });
}

}  // namespace lodestone::cli
