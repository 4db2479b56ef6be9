// The commands of lodestone-cli, one file each.
#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/run.h"

namespace lodestone::cli {

/// What a parsed command line asks for: a command's name and its work.
struct Chosen {
  std::string name;
  std::function<void(Run&)> work;
};

void addInfo(CLI::App& app, Chosen& chosen);
void addConvert(CLI::App& app, Chosen& chosen);
void addSynth(CLI::App& app, Chosen& chosen);
void addCluster(CLI::App& app, Chosen& chosen);
void addMerge(CLI::App& app, Chosen& chosen);
void addCut(CLI::App& app, Chosen& chosen);
void addFly(CLI::App& app, Chosen& chosen);
void addChain(CLI::App& app, Chosen& chosen);
void addRender(CLI::App& app, Chosen& chosen);
void addClassify(CLI::App& app, Chosen& chosen);
void addSimplify(CLI::App& app, Chosen& chosen);
void addVisibility(CLI::App& app, Chosen& chosen);
void addCompare(CLI::App& app, Chosen& chosen);
void addPerceive(CLI::App& app, Chosen& chosen);

}  // namespace lodestone::cli
