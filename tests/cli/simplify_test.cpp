// What `simplify` says of what it was asked for.
#include <fmt/format.h>

#include "tests/cli/cli_support.h"

namespace lodestone::test {
namespace {

class Simplify : public testing::Test {
 protected:
  Outcome simplify(const std::vector<std::string>& more, const std::string& output = "less.city.json") {
    std::vector<std::string> arguments{"simplify",       town_, "-o", (folder_ / output).string(), "--report",
                                       report().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cli(std::move(arguments));
  }
  [[nodiscard]] std::filesystem::path report() const { return folder_ / "r.json"; }

  TemporaryFolder folder_;
  std::string town_ = town(folder_, 30);
};

TEST_F(Simplify, OptionsOfOtherMethodsAreRefused) {
  for (const std::vector<std::string>& given : {std::vector<std::string>{"--stage", "1"},
                                                {"--unseen"},
                                                {"--error", "0.1"},
                                                {"--views", "2"},
                                                {"--distance", "2"},
                                                {"--slight", "3"},
                                                {"--method", "qem", "--stage", "1"},
                                                {"--a", "3", "--method", "qem"},
                                                {"--a", "auto", "--method", "perception"},
                                                {"--rim-planes", "--method", "vertex-clustering"},
                                                {"--rim-planes", "--method", "perception"}}) {
    const Outcome outcome = simplify(given);
    EXPECT_EQ(outcome.status, 2) << given[0];
    EXPECT_NE(outcome.err.find("505"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "less.city.json"));
  }
}

TEST_F(Simplify, SaysWhyAStageStopsShortOfTheRate) {
  const Outcome outcome =
      simplify({"--method", "perception", "--stage", "1", "--views", "2", "--size", "64", "--rate", "0.9"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("of the 90% asked for"), std::string::npos) << outcome.out;
  const Json figures = jsonOf(report())["figures"];
  EXPECT_EQ(figures["rate_asked"], 0.9);
  EXPECT_LT(figures["rate"].get<double>(), 0.9);
}

TEST_F(Simplify, SaysThatEachGroupIsLookedAtByItself) {
  const Outcome outcome =
      simplify({"--method", "perception", "--views", "2", "--size", "32", "--rate", "0.5"});
  EXPECT_NE(outcome.err.find("620"), std::string::npos) << outcome.err;
}

/// Pictures of 2049² are large: each group has one in work, 80 MiB, and each thread a group.
TEST_F(Simplify, CountsTheMemoryOfAGroupForEachThread) {
  const auto told = [&](const std::string& threads) {
    std::vector<std::string> arguments{"simplify", town_, "-o", (folder_ / "less.city.json").string()};
    for (const char* more : {"--method", "perception", "--views", "8", "--size", "2049", "--threads"})
      arguments.emplace_back(more);
    arguments.push_back(threads);
    const Outcome outcome = cli(arguments, 1500);
    EXPECT_EQ(outcome.status, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("619"), std::string::npos) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(told("1").find(" 80 MiB"), std::string::npos) << told("1");
  EXPECT_NE(told("2").find(" 160 MiB"), std::string::npos) << told("2");
}

/// A box within a closed box goes whole: nobody sees it.
TEST_F(Simplify, AStageWithoutABoundOnTheErrorIsSaid) {
  const auto box = [](const std::string& name, double from, double to) {
    std::string text = "o " + name + "\n";
    for (const double z : {from, to}) {
      for (const auto& [x, y] : {std::pair(from, from), {to, from}, {to, to}, {from, to}})
        text += fmt::format("v {} {} {}\n", x, y, z);
    }
    for (const char* face :
         {"-8 -5 -6 -7", "-4 -3 -2 -1", "-8 -7 -3 -4", "-7 -6 -2 -3", "-6 -5 -1 -2", "-5 -8 -4 -1"})
      text += fmt::format("f {}\n", face);
    return text;
  };
  writeText(folder_ / "boxes.obj", box("out", 0, 9) + box("in", 3, 5));
  std::vector<std::string> all{"simplify",
                               (folder_ / "boxes.obj").string(),
                               "--method",
                               "perception",
                               "--unseen",
                               "--views",
                               "4",
                               "--size",
                               "64",
                               "--rate",
                               "1",
                               "-o",
                               (folder_ / "out.glb").string(),
                               "--report",
                               report().string()};
  const Outcome outcome = cli(all);
  EXPECT_EQ(jsonOf(report())["figures"]["triangles_removed"], 12);
  EXPECT_NE(outcome.err.find("621"), std::string::npos) << outcome.err;
  all.insert(all.end(), {"--error", "0.1"});
  EXPECT_EQ(cli(all).err.find("621"), std::string::npos);
}

TEST_F(Simplify, LossesAreSaidWhereThereMayBeAny) {
  EXPECT_NE(simplify({"--rate", "0"}, "a.glb").err.find("703"), std::string::npos);
  for (const char* name : {"b.glb", "b.city.json"}) {
    const Outcome outcome =
        cli({"simplify", (folder_ / "a.glb").string(), "--rate", "0", "-o", (folder_ / name).string()});
    EXPECT_EQ(outcome.err.find("703"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace lodestone::test
