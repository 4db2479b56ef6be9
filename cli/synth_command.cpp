#include "algorithms/chains/chain_building.h"
#include "algorithms/synthesis/synthesis.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "cli/written_files.h"

namespace lodestone::cli {

void addSynth(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    SynthOptions options;
    std::string output;
  };
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("synth", "Make up a city: the same seed gives the same bytes");
  addFlags(*command, args->options);
  command->add_option("-o,--output", args->output, "Output; the format follows the ending")->required();
  command->callback([args, &chosen] {
    chosen = {
        "synth", [args](Run& run) {
          const Format& format = outputFormat(args->output);
          const auto city = std::make_shared<const CityModel>(run.stage(
              "synth", [&](const Progress& progress) { return synthesiseCity(args->options, progress); }));
          run.figures["buildings"] = city->buildings.size();
          writeChain(run, run.take(makeChain(city, nullptr, {})), format, args->output);
        }};
  });
}

}  // namespace lodestone::cli
