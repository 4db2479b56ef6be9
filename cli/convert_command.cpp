#include "algorithms/chains/chain_building.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/written_files.h"

namespace lodestone::cli {

void addConvert(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    CityInput city;
    std::string output;
  };
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("convert", "Import and export, nothing else");
  args->city.addTo(*command);
  command->add_option("-o,--output", args->output, "Output; the format follows the ending")->required();
  command->callback([args, &chosen] {
    chosen = {"convert", [args](Run& run) {
                const Format& format = outputFormat(args->output);
                const auto city = args->city.load(run);
                LodChain chain = run.take(makeChain(city, nullptr, {}));
                chain.recipe = recipeText(args->city.recipe(chain), folderOf(args->output));
                writeChain(run, chain, format, args->output);
              }};
  });
}

}  // namespace lodestone::cli
