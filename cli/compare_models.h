// Two models looked at from the same places, and measured.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "cli/run.h"
#include "model/import_options.h"
#include "model/perceive_options.h"

namespace lodestone::cli {

struct CompareArguments {
  std::string first;
  std::string second;
  ImportOptions import;
  PerceiveOptions perceive;
  double pixelsPerDegree = 0;  ///< 0: by the display of `perceive`
  double turn = 0.5;           ///< of the viewpoints, see viewpointsAround()
  bool plain = false;          ///< without textures and materials
  std::string output;          ///< a folder for pictures and comparison.json; empty: none
  std::string unfinished{};    ///< where its files are written until all are there

  [[nodiscard]] double degree() const {
    return pixelsPerDegree > 0 ? pixelsPerDegree : perceive.pixelsPerDegree();
  }
};

/// Where a file of the output folder goes; listed in the report. \throw Failure where it is an input
[[nodiscard]] std::string outputOf(const CompareArguments& args, Run& run, const std::string& name);
/// Writes comparison.json where there is a folder. \throw Failure
void writeComparison(const CompareArguments& args, Run& run, const nlohmann::ordered_json& comparison);

void compareModelFiles(const CompareArguments& args, Run& run);

}  // namespace lodestone::cli
