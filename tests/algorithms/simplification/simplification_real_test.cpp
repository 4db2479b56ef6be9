// Simplification of real textured buildings; skipped where the data is absent.
#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "algorithms/simplification/city_simplification.h"
#include "model/io/read_city.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

class RealTexturedBuilding : public testing::Test {
 protected:
  /// \pre the file is there
  static SimplifyReport simplified(const std::filesystem::path& file, const SimplifyOptions& options) {
    Result<CityModel> city = readCity({file});
    if (!city.ok()) {
      ADD_FAILURE() << file;
      return {};
    }
    const auto result = simplifyCity(std::make_shared<const CityModel>(std::move(*city)), options);
    return result->report;
  }

  static std::size_t kept(const SimplifyReport& report) {
    return static_cast<std::size_t>(
        std::count_if(report.contacts.begin(), report.contacts.end(),
                      [](const ContactReport& contact) { return contact.fate == ContactFate::Kept; }));
  }
};

/// Three charts meet at nearly every corner: as long as borders were sacred one of 25 components was left,
/// and walls had moved by 12 m.
TEST_F(RealTexturedBuilding, AFacadeOfPhotographsKeepsItsPartsAndItsPlace) {
  const auto file = test::sharedData("A_citygml/ingolstadt_lod3/4018115/4018115.xml");
  if (file.empty()) GTEST_SKIP() << "shared data not present";
  const SimplifyReport report = simplified(file, {.rate = 0.5});
  EXPECT_LE(2 * report.trianglesAfter, report.trianglesBefore);
  EXPECT_EQ(report.componentsAfter, report.componentsBefore);
  EXPECT_EQ(kept(report), report.contacts.size());
  EXPECT_LT(report.hausdorff, 0.2);
}

/// The same: 10 of 121 components were left.
TEST_F(RealTexturedBuilding, ASchoolKeepsItsWindowFrames) {
  const auto file = test::sharedData("D_meshes/gazebo_buildings/school/meshes/school.dae");
  if (file.empty()) GTEST_SKIP() << "shared data not present";
  const SimplifyReport report = simplified(file, {.rate = 0.6});
  EXPECT_EQ(report.componentsAfter, report.componentsBefore);
  EXPECT_GT(kept(report), report.contacts.size() / 2);
  EXPECT_LT(report.hausdorff, 1);
}

}  // namespace
}  // namespace lodestone
