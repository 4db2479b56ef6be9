// What the tests of the command line share.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace lodestone::test {

using Json = nlohmann::json;

inline Outcome cli(std::vector<std::string> arguments, int interruptAfter = 0) {
  arguments.insert(arguments.begin(), LODESTONE_CLI);
  return runProgram(arguments, interruptAfter);
}

inline Json jsonOf(const std::filesystem::path& path) {
  return Json::parse(readText(path));
}

inline std::set<std::string> filesIn(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      names.insert(std::filesystem::relative(entry.path(), folder).generic_string());
  }
  return names;
}

/// A made-up town of a few buildings.
inline std::string town(const TemporaryFolder& folder, int buildings = 120) {
  const std::string path = (folder / "town.city.json").string();
  const Outcome outcome = cli({"synth", "-o", path, "--buildings", std::to_string(buildings)});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return path;
}

}  // namespace lodestone::test
