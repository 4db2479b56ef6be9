#include <algorithm>

#include <fmt/format.h>

#include "algorithms/chains/chain_building.h"
#include "algorithms/simplification/city_simplification.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "cli/perceive_flags.h"
#include "cli/written_files.h"
#include "model/exterior.h"

namespace lodestone::cli {
namespace {

struct Arguments {
  CityInput city;
  SimplifyOptions simplify;
  PerceiveOptions perceive;
  std::string output;
};

double share(std::uint32_t part, std::uint32_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / whole;
}

/// The paper's table 2.
void note(Run& run, const StageReport& stage, const Arguments& args) {
  auto& figures = run.figures;
  figures["stage"] = args.simplify.stage;
  for (std::size_t c = 0; c < kDetailClasses; ++c)
    figures[fmt::format("triangles_{}", toString(static_cast<DetailClass>(c)))] = stage.classes[c];
  figures["triangles_unseen"] = stage.unseen;
  figures["triangles_latent"] = stage.latent();
  figures["triangles_admitted"] = stage.admitted;
  figures["triangles_removed"] = stage.removed;
  // What was removed is counted whether it was seen or not: with the unseen there is no such rate.
  if (!args.simplify.unseen) figures["rate_of_latent"] = share(stage.removed, stage.latent());
  figures["rate_of_admitted"] = share(stage.removed, stage.admitted);
  if (run.options().quiet) return;
  fmt::print("classes     ");
  for (std::size_t c = 0; c < kDetailClasses; ++c)
    fmt::print("{} {}, ", stage.classes[c], toString(static_cast<DetailClass>(c)));
  fmt::print("{} unseen\nstage {}     {} admitted, {} removed: {:.2f}%", stage.unseen, args.simplify.stage,
             stage.admitted, stage.removed, 100 * share(stage.removed, stage.admitted));
  if (!args.simplify.unseen)
    fmt::print("; of {} slight or above {:.2f}%", stage.latent(), 100 * share(stage.removed, stage.latent()));
  fmt::print("\n");
}

void note(Run& run, const SimplifiedCity& result) {
  const SimplifyReport& report = result.report;
  auto& figures = run.figures;
  figures["triangles_before"] = report.trianglesBefore;
  figures["triangles_after"] = report.trianglesAfter;
  figures["vertices_before"] = report.verticesBefore;
  figures["vertices_after"] = report.verticesAfter;
  figures["components_before"] = report.componentsBefore;
  figures["components_after"] = report.componentsAfter;
  figures["boundary_vertices"] = report.boundaryVertices;
  figures["hole_vertices"] = report.holeVertices;
  figures["contacts"] = report.contacts.size();
  figures["contacts_kept"] = report.count(ContactFate::Kept);
  figures["contacts_separated"] = report.count(ContactFate::Separated);
  figures["contacts_lost"] = report.count(ContactFate::Lost);
  figures["widest_gap_m"] = report.widestGap();
  figures["hausdorff_m"] = report.hausdorff;
  figures["a"] = report.a;
  figures["groups"] = result.groups;
  figures["buildings_gone"] = result.buildingsGone;
  for (const AutoTrial& trial : report.trials)
    figures["auto"].push_back({{"a", trial.a},
                               {"score", trial.score},
                               {"widest_gap_m", trial.widestGap},
                               {"hausdorff_m", trial.hausdorff},
                               {"contacts_separated", trial.separated},
                               {"contacts_lost", trial.lost},
                               {"groups", trial.groups}});
  if (run.options().quiet) return;
  fmt::print(
      "triangles   {} -> {}\ncomponents  {} -> {}\ncontacts    {}: {} kept, {} separated, {} lost\n"
      "widest gap  {:.3f} m\nHausdorff   {:.3f} m\n",
      report.trianglesBefore, report.trianglesAfter, report.componentsBefore, report.componentsAfter,
      report.contacts.size(), report.count(ContactFate::Kept), report.count(ContactFate::Separated),
      report.count(ContactFate::Lost), report.widestGap(), report.hausdorff);
  if (report.trials.empty()) return;
  fmt::print("{:>5} {:>9} {:>11} {:>11} {:>10} {:>5} {:>7}\n", "a", "score", "gap m", "Hausdorff m",
             "separated", "lost", "best of");
  for (const AutoTrial& trial : report.trials)
    fmt::print("{:>5} {:>9.5f} {:>11.3f} {:>11.3f} {:>10} {:>5} {:>7}\n", trial.a, trial.score,
               trial.widestGap, trial.hausdorff, trial.separated, trial.lost, trial.groups);
}

/// What would be ignored in silence is refused.
void refuseMeaningless(const CLI::App& command, const SimplifyOptions& options) {
  const std::string method = toText(fields<SimplifyOptions>().front().get(options));
  const auto why = [&](const char* whose) {
    return fmt::format("means nothing with --method {}: it is for {}", method, whose);
  };
  if (!needsPerception(options.method)) {
    std::vector<std::string> flags = flagsOf<PerceiveOptions>();
    flags.insert(flags.end(), {"--stage", "--unseen", "--error"});
    refuseGiven(command, flags, why("perception and combined"));
  }
  if (options.method == SimplifyMethod::Perception)
    refuseGiven(command, {"--rim-planes"}, "means nothing with perception, which always has such planes");
  if (!needsTopology(options.method)) refuseGiven(command, {"--a", "--a-auto"}, why("topology and combined"));
  if (options.method == SimplifyMethod::VertexClustering)
    refuseGiven(command, {"--rim-planes"}, why("topology, qem, qem-optimal and combined"));
}

/// Before it begins: what looking takes, and from where it is done.
void tellLooking(Run& run, const CityModel& city, const std::vector<std::vector<std::uint32_t>>& groups,
                 const Arguments& args) {
  std::size_t most = 0;
  for (const auto& group : groups) {
    std::size_t triangles = 0;
    for (const std::uint32_t b : group) triangles += facesOf(city.buildings[b]).triangles;
    most = std::max(most, triangles);
  }
  const int threads = threadsOf(run.options());
  const Camera camera{.width = args.perceive.size, .height = args.perceive.size};
  const std::vector<Camera> cameras(static_cast<std::size_t>(args.perceive.views), camera);
  tellCost(run, lookingCost(cameras, most, threads, false, groups.size()),
           fmt::format("{} groups of touching buildings, {} views each", groups.size(), args.perceive.views));
  if (groups.size() > 1)
    run.add(
        {diagnose(Code::LookedAtByGroup, fmt::format("{} groups, each fills its pictures", groups.size()))});
}

/// Whether what was asked for was reached, and if not why.
void noteRate(Run& run, const SimplifyReport& report, const Arguments& args) {
  const double rate = share(report.trianglesBefore - report.trianglesAfter, report.trianglesBefore);
  run.figures["rate"] = rate;
  run.figures["rate_asked"] = args.simplify.rate;
  if (!report.stage) return;
  if (args.simplify.rate == 1 && args.simplify.error == 0 && report.stage->removed > 0)
    run.add({diagnose(Code::ErrorUnbounded, fmt::format("Hausdorff distance {:.3f} m", report.hausdorff))});
  if (run.options().quiet || rate >= args.simplify.rate) return;
  fmt::print("rate        {:.2f}% of the {:.0f}% asked for: ", 100 * rate, 100 * args.simplify.rate);
  if (report.stage->removed < report.stage->admitted && args.simplify.error > 0)
    fmt::print("at the error of {} m, or with a vertex in a triangle that is not admitted\n",
               args.simplify.error);
  else
    fmt::print("the stage is at its end; a vertex moves only where all triangles around it are admitted\n");
}

void work(const Arguments& args, Run& run) {
  const Format& format = outputFormat(args.output);
  requireRisingThresholds(args.perceive);
  const auto city = args.city.load(run);
  GroupsKnown tell;
  if (needsPerception(args.simplify.method))
    tell = [&](const auto& groups) { tellLooking(run, *city, groups, args); };
  const SimplifiedCity result = run.take(run.stage("simplify", [&](const Progress& progress) {
    return simplifyCity(city, args.simplify, progress, {}, args.perceive, tell);
  }));
  writeChain(run, simplifiedChain(result.city, args.simplify, result.report.hausdorff, args.perceive), format,
             args.output);
  note(run, result);
  if (result.report.stage) note(run, *result.report.stage, args);
  noteRate(run, result.report, args);
}

}  // namespace

void addSimplify(CLI::App& app, Chosen& chosen) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "simplify", "Remove a share of the triangles of every building, keeping its parts together");
  args->city.addTo(*command);
  addFlags(*command, args->simplify);
  addPerceiveFlags(*command, args->perceive);
  command->get_option("--a")->transform([args](const std::string& text) {
    args->simplify.aAuto = args->simplify.aAuto || text == "auto";
    return text == "auto" ? toText(FieldValue(args->simplify.a)) : text;
  });
  command->add_option("-o,--output", args->output, "Output; the format follows the ending")->required();
  command->callback([args, command, &chosen] {
    chosen = {"simplify", [args, command](Run& run) {
                refuseMeaningless(*command, args->simplify);
                work(*args, run);
              }};
  });
}

}  // namespace lodestone::cli
