// lodestone-cli: parses, calls, prints.
#include <algorithm>
#include <filesystem>
#include <new>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <oneapi/tbb/global_control.h>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "model/io/output_failure.h"

#include "version.h"

namespace lodestone::cli {
namespace {

void addCommon(CLI::App& app, CommonOptions& common) {
  app.add_option("--threads", common.threads, "Threads to use; 0: all cores")->check(CLI::Range(0, 1024));
  app.add_option("--report", common.report, "Write stages, figures and diagnostics to this JSON file");
  app.add_flag("--quiet", common.quiet, "Warnings and errors only: no progress bar, notes or tables");
  app.add_flag("--verbose", common.verbose, "Every message");
}

/// Options that cannot be understood only once the input is read, and endings that nothing writes.
bool isWrongUsage(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& d) {
    const int code = static_cast<int>(d.code);
    return (code >= 500 && code < 600) || d.code == Code::OutputFormatUnknown;
  });
}

/// An output named like an input is a slip: nobody wants to lose what was read.
void refuseToReplaceInput(const CLI::App& command) {
  const CLI::Option* output = command.get_option_no_throw("--output");
  if (!output || output->empty()) return;
  for (const char* name : {"INPUT", "MODEL", "--targets", "--barriers"}) {
    const CLI::Option* input = command.get_option_no_throw(name);
    if (!input) continue;
    for (const std::string& path : input->results()) {
      std::error_code notThere;
      if (std::filesystem::equivalent(path, output->results().front(), notThere))
        throw Failure(diagnose(Code::OutputExists, path + " is an input"));
    }
  }
}

int execute(const Chosen& chosen, const CommonOptions& common, const CLI::App& command) {
  Interrupt interrupt;
  Run run(chosen.name, common, interrupt.token());
  try {
    refuseToReplaceInput(command);
    chosen.work(run);
    return run.finish(kDone);
  } catch (const Cancelled&) {
    fmt::print(stderr, "interrupted: nothing was written that is not whole\n");
    return run.finish(kInterrupted);
  } catch (const Failure& failure) {
    run.add(failure.diagnostics());
    if (isWrongUsage(failure.diagnostics())) return run.finish(kWrongUsage);
  } catch (const std::system_error& error) {
    run.add({outputFailure(error)});
  } catch (const std::bad_alloc&) {
    run.add({diagnose(Code::Internal, "out of memory")});
  } catch (const std::exception& error) {
    run.add({diagnose(Code::Internal, error.what())});
  }
  return run.finish(kFailed);
}

/// Says which word was taken for a command, and which commands there are; false when the mistake is another.
bool sayUnknownCommand(const CLI::App& app) {
  if (!app.get_subcommands().empty()) return false;
  const std::vector<std::string> left = app.remaining();
  const auto word =
      std::find_if(left.begin(), left.end(), [](const std::string& text) { return !text.starts_with("-"); });
  if (word == left.end()) return false;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  fmt::print(stderr, "unknown command '{}'; there are {}\nRun with --help for more information.\n", *word,
             fmt::join(names, ", "));
  return true;
}

}  // namespace
}  // namespace lodestone::cli

int main(int argc, char** argv) {
  using namespace lodestone::cli;
  CLI::App app("Chains of levels of detail for 3D city models", "lodestone-cli");
  app.set_version_flag("--version", "lodestone-cli " LODESTONE_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  app.footer(
      "Exit status: 0 done; 1 failed; 2 wrong usage; 3 done, with objects skipped or repaired; 130 "
      "interrupted.");
  CommonOptions common;
  addCommon(app, common);
  Chosen chosen;
  for (const auto add : {addInfo, addConvert, addSynth, addCluster, addMerge, addCut, addFly, addChain, addClassify,
                         addSimplify, addPerceive, addCompare, addVisibility, addRender})
    add(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    if (!sayUnknownCommand(app)) (void)app.exit(error);
    return kWrongUsage;
  }
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(threadsOf(common)));
  return execute(chosen, common, *app.get_subcommands().front());
}
