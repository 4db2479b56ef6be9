#include <numeric>
#include <sstream>

#include <gmock/gmock.h>

#include "tests/cli/cli_support.h"

namespace lodestone {
namespace {

using test::cli;
using test::readText;
using testing::HasSubstr;

std::vector<std::vector<std::string>> rowsOf(const std::filesystem::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(readText(path));
  for (std::string line; std::getline(text, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// All but the time that choosing took.
std::vector<std::vector<std::string>> untimed(const std::filesystem::path& path) {
  auto rows = rowsOf(path);
  for (auto& row : rows) row.pop_back();
  return rows;
}

TEST(Fly, WritesEveryFrameAndThePathThatMakesThemAgain) {
  const test::TemporaryFolder folder;
  const std::string input = test::town(folder);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  const auto outcome =
      cli({"fly", input, "--fps", "2", "-o", file("a.csv"), "--save-path", file("path.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("polygons    median"));
  const auto rows = rowsOf(folder / "a.csv");
  ASSERT_EQ(rows.size(), 122U);  // a minute
  for (const auto& row : rows) ASSERT_EQ(row.size(), rows.front().size());
  EXPECT_EQ(rows[0][4], "polygons");
  EXPECT_LT(std::stod(rows[1][3]), std::stod(rows.back()[3])) << "it climbs";
  ASSERT_EQ(cli({"fly", input, "--fps", "2", "-o", file("b.csv"), "--path", file("path.json")}).status, 0);
  EXPECT_EQ(untimed(folder / "b.csv"), untimed(folder / "a.csv"));
}

TEST(Fly, DrawsEveryBuildingWhereItIsTold) {
  const test::TemporaryFolder folder;
  const std::string input = test::town(folder);
  const auto polygons = [&](const std::string& method) {
    const std::string path = (folder / (method + ".csv")).string();
    EXPECT_EQ(cli({"fly", input, "--path", "random", "--fps", "1", "--method", method, "-o", path}).status,
              0);
    std::vector<double> counts;
    for (const auto& row : rowsOf(path)) {
      if (row[4] != "polygons") counts.push_back(std::stod(row[4]));
    }
    return counts;
  };
  const auto none = polygons("none");
  const auto all = polygons("all");
  const auto legible = polygons("legible");
  ASSERT_EQ(none.size(), all.size());
  ASSERT_EQ(none.size(), legible.size());
  for (std::size_t i = 0; i < none.size(); ++i) {
    EXPECT_EQ(none[i], none[0]);
    EXPECT_LE(all[i], none[i]);
    EXPECT_LE(legible[i], none[i]);
  }
}

TEST(Fly, ComparesPicturesWithThoseOfAllBuildings) {
  const test::TemporaryFolder folder;
  const std::string input = test::town(folder);
  const auto errors = [&](const std::string& method, const std::string& epsilon) {
    const std::string path = (folder / "f.csv").string();
    EXPECT_EQ(cli({"fly", input, "--fps", "0.2", "--compare", "2", "--size", "320x200", "--method", method,
                   "--epsilon", epsilon, "-o", path})
                  .status,
              0);
    std::vector<double> found;
    std::size_t number = 0;
    for (const auto& row : rowsOf(path)) {
      if (row[4] == "polygons") continue;
      EXPECT_EQ(row[12].empty(), number++ % 2 == 1);
      if (!row[12].empty()) found.push_back(std::stod(row[12]));
    }
    EXPECT_EQ(found.size(), 7U);
    return found;
  };
  // What culling leaves out is in no picture.
  for (const double error : errors("all", "100")) EXPECT_EQ(error, 0);
  for (const double error : errors("none", "100")) EXPECT_EQ(error, 0);
  const auto coarse = errors("legible", "2000");
  const auto fine = errors("legible", "1");
  EXPECT_GT(std::accumulate(coarse.begin(), coarse.end(), 0.0), 0.01);
  EXPECT_LT(std::accumulate(fine.begin(), fine.end(), 0.0),
            std::accumulate(coarse.begin(), coarse.end(), 0.0));
}

TEST(Fly, SaysWhatIsWrong) {
  const test::TemporaryFolder folder;
  const std::string input = test::town(folder, 20);
  const std::string out = (folder / "f.csv").string();
  test::writeText(folder / "path.json", R"({"type": "path", "version": 1, "keys": []})");
  const auto outcome = cli({"fly", input, "-o", out, "--path", (folder / "path.json").string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("no \"keys\""));
  EXPECT_THAT(cli({"fly", input, "-o", out, "--path", (folder / "no.json").string()}).err, HasSubstr("101"));
  EXPECT_THAT(cli({"fly", input, "-o", out, "--size", "12"}).err, HasSubstr("503"));
  EXPECT_FALSE(std::filesystem::exists(out));
  // Before the city is read, which may take minutes.
  EXPECT_THAT(cli({"fly", (folder / "none.gml").string(), "-o", out, "--size", "12"}).err, HasSubstr("503"));
}

TEST(Fly, SaysNothingWhereItIsToBeQuiet) {
  const test::TemporaryFolder folder;
  const std::string input = test::town(folder, 20);
  const auto outcome = cli({"fly", input, "--quiet", "--fps", "0.1", "--compare", "3", "--size", "64x64",
                            "-o", (folder / "f.csv").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace lodestone
