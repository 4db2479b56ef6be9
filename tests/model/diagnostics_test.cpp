#include "model/diagnostics.h"

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

namespace lodestone {
namespace {

TEST(Diagnostics, CodesAreUniqueAndEveryRowIsWhole) {
  std::set<int> codes;
  for (const DiagnosticInfo& row : diagnosticTable()) {
    EXPECT_TRUE(codes.insert(static_cast<int>(row.code)).second) << static_cast<int>(row.code);
    EXPECT_FALSE(row.title.empty());
    EXPECT_FALSE(row.advice.empty());
    EXPECT_EQ(&info(row.code), &row);
  }
}

TEST(Diagnostics, TextNamesCodeObjectPlaceAndAdvice) {
  const std::string text = format(diagnose(Code::CoordinateBad, "x is nan", "b17", "tile.gml:12"));
  EXPECT_THAT(text, testing::AllOf(testing::HasSubstr("warning 204"), testing::HasSubstr("[b17]"),
                                   testing::HasSubstr("x is nan"), testing::HasSubstr("tile.gml:12"),
                                   testing::HasSubstr(std::string(info(Code::CoordinateBad).advice))));
}

// The page for people is the table, row by row. With LODESTONE_UPDATE_DOCS set, the test writes the page.
TEST(Diagnostics, ThePageForPeopleIsTheTable) {
  std::ostringstream page;
  page << "# Diagnostics\n\nEvery message has a code that never changes its meaning. The page is made from "
          "the program's "
          "table.\n\n| code | severity | what | what to do |\n|--:|---|---|---|\n";
  for (const DiagnosticInfo& row : diagnosticTable()) {
    page << "| " << static_cast<int>(row.code) << " | " << toString(row.severity) << " | " << row.title
         << " | " << row.advice << " |\n";
  }
  const std::string path = LODESTONE_SOURCE_DIR "/resources/docs/diagnostics.md";
  if (std::getenv("LODESTONE_UPDATE_DOCS")) std::ofstream(path) << page.str();
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), page.str());
}

}  // namespace
}  // namespace lodestone
