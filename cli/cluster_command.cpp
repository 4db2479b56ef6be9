#include "cli/city_input.h"
#include "cli/commands.h"
#include "model/io/dendrogram_json.h"

namespace lodestone::cli {

void addCluster(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    CityInput city;
    TreeInput tree;
    std::string output;
  };
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("cluster", "Cluster the buildings: a dendrogram");
  args->city.addTo(*command);
  args->tree.addClusterTo(*command);
  command->add_option("-o,--output", args->output, "Dendrogram, JSON")->required();
  command->callback([args, &chosen] {
    chosen = {"cluster", [args](Run& run) {
                const auto city = args->city.load(run);
                const auto table = std::make_shared<const FootprintTable>(footprintTable(*city));
                const auto dendrogram = args->tree.dendrogram(run, *city, table);
                writeDendrogram(*dendrogram, buildingIds(*city), args->output);
                run.output["files"] = {args->output};
              }};
  });
}

}  // namespace lodestone::cli
