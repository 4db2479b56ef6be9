#include "model/io/citygml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

struct Counts {
  std::size_t buildings = 0, parts = 0, surfaces = 0;
  bool operator==(const Counts&) const = default;
};

Counts countsOf(const CityModel& model) {
  Counts counts;
  counts.buildings = model.buildings.size();
  forEachObjectOf(model, [&](const CityObject& object) {
    if (object.type == ObjectType::BuildingPart) ++counts.parts;
    for (const Geometry& geometry : object.geometries) counts.surfaces += geometry.surfaceCount();
  });
  return counts;
}

/// The files of the issue and what their README counts; `surfaces` are polygons and triangles, less those that the
/// reader leaves out and names, plus those that two solids share.
struct RealFile {
  const char* path;
  Counts counts;
};

class RealCityGml : public testing::TestWithParam<RealFile> {};

TEST_P(RealCityGml, HasTheCountsOfItsReadme) {
  const auto path = test::sharedData(GetParam().path);
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const auto model = cityGmlFormat().read(path, {}, {});
  ASSERT_TRUE(model);
  const Counts counts = countsOf(*model);
  EXPECT_EQ(counts.buildings, GetParam().counts.buildings);
  EXPECT_EQ(counts.parts, GetParam().counts.parts);
  EXPECT_EQ(counts.surfaces, GetParam().counts.surfaces);
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealCityGml,
    testing::Values(
        RealFile{"A_citygml/berlin_lod2_argis/Berlin1b/3900_5820.gml", {75, 0, 2325}},
        RealFile{"A_citygml/berlin_lod2_argis/Berlin1b/3910_5820.gml", {56, 0, 3031}},
        RealFile{"A_citygml/berlin_lod2_argis/Berlin1b/3920_5820.gml", {6, 0, 133}},
        RealFile{"A_citygml/nrw_lod2/LoD2_32_280_5657_1_NW.gml", {83, 50, 1144}},
        RealFile{"A_citygml/potsdam_berlin_3dcitydb/Potsdam/CityGML/Potsdam_LoD1/Potsdam_LoD1.gml", {97, 0, 1547}},
        RealFile{"A_citygml/libcitygml/berlin_open_data_sample_data.citygml", {61, 0, 1125}},
        RealFile{"A_citygml/plateau_tiles_yuuhayashi/51311568_bldg_6697_op.gml", {225, 0, 1946}},
        RealFile{"A_citygml/plateau_tiles_yuuhayashi/53375768_bldg_6697_op.gml", {329, 0, 3523}},
        RealFile{"A_citygml/citygml4j/lod2_buildings_v3.gml", {100, 0, 700}},
        RealFile{"A_citygml/ingolstadt_lod3/4018128/4018128.xml", {1, 0, 2309}}));

}  // namespace
}  // namespace lodestone
