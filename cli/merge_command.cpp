#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/written_files.h"
#include "model/io/outlines/hulls_layer.h"

namespace lodestone::cli {

void addMerge(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    CityInput city;
    TreeInput tree;
    std::string output;
  };
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("merge", "Merge the clusters: the hull of every node");
  args->city.addTo(*command);
  args->tree.addMergeTo(*command);
  command->add_option("-o,--output", args->output, "Hulls: " + hullEndings())->required();
  command->callback([args, &chosen] {
    chosen = {"merge", [args](Run& run) {
                if (auto why = whyNoHulls(args->output)) throw Failure(*why);
                const auto city = args->city.load(run);
                const auto tree = args->tree.build(run, *city);
                noteFiles(run, run.take(run.stage("write", [&](const Progress& progress) {
                  return writeHulls(*city, *tree, args->output, progress);
                })));
              }};
  });
}

}  // namespace lodestone::cli
