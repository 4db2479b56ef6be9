// Footprints of real models against their own ground surfaces, and merged hulls of real footprints against
// the reference.
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "algorithms/footprints/import.h"
#include "algorithms/geometry/overlap_area.h"
#include "algorithms/geometry/predicates.h"
#include "algorithms/merging/merging.h"
#include "tests/support/plain_dendrogram.h"
#include "tests/support/reference_hull.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

const char* const kModels[] = {
    "A_citygml/berlin_lod2_argis/Berlin1b/3900_5820.gml",
    "A_citygml/berlin_lod2_argis/Berlin1b/3910_5820.gml",
    "A_citygml/nrw_lod2",
    "A_citygml/potsdam_berlin_3dcitydb/Potsdam/CityGML/Potsdam_LoD1/Potsdam_LoD1.gml",
    "A_citygml/plateau_gis_converter/nusamai-plateau/tests/data/yokosuka-shi/udx/bldg/"
    "52397519_bldg_6697_op.gml",
    "A_citygml/fzkhaus_all_lods/FZK-Haus-LoD-all-KIT-IAI-KHH-B36-V1.zip",
    "B_cityjson/denhaag_zip_dtcc/DenHaag_01.city.json.zip",
};

/// The named file, or the first model file of the named folder.
std::filesystem::path modelFile(const std::string& name) {
  const std::filesystem::path path = test::sharedData(name);
  if (!std::filesystem::is_directory(path)) return path;
  std::filesystem::path first;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
    const auto ending = entry.path().extension();
    if ((ending == ".gml" || ending == ".xml") && (first.empty() || entry.path() < first))
      first = entry.path();
  }
  return first;
}

using Sides = std::vector<OverlapSide>;

void addRing(const Ring& ring, bool hole, Sides& sides) {
  const bool turn = (signedArea(ring) > 0) == hole;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    sides.push_back(turn ? OverlapSide{b, a} : OverlapSide{a, b});
  }
}

/// Ground surfaces seen from above, by LoD.
std::map<std::string, std::vector<Sides>> groundSurfaces(const CityObject& building) {
  std::map<std::string, std::vector<Sides>> result;
  forEachObject(building, [&](const CityObject& object) {
    for (const Geometry& g : object.geometries) {
      for (std::size_t s = 0; s < g.surfaceCount(); ++s) {
        if (g.surfaces[s].type != SurfaceType::Ground) continue;
        Sides& sides = result[g.lod].emplace_back();
        for (std::uint32_t r = g.surfaceStart[s]; r < g.surfaceStart[s + 1]; ++r) {
          Ring ring;
          for (std::uint32_t k = g.ringStart[r]; k < g.ringStart[r + 1]; ++k) {
            ring.push_back(g.vertices[g.ringVertices[k]].head<2>());
          }
          addRing(ring, r > g.surfaceStart[s], sides);
        }
      }
    }
  });
  return result;
}

double common(Sides a, const Sides& b) {
  for (OverlapSide side : b) {
    side.set = 1;
    a.push_back(side);
  }
  return overlapArea(a);
}

/// Bounds on the area of the union: the sum, and the sum less all that two surfaces share (equal where no
/// three do).
std::pair<double, double> unionBounds(const std::vector<Sides>& surfaces) {
  double sum = 0;
  double shared = 0;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    sum += common(surfaces[i], surfaces[i]);
    for (std::size_t j = 0; j < i; ++j) shared += common(surfaces[i], surfaces[j]);
  }
  return {sum - shared, sum};
}

class RealModel : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::filesystem::path path = modelFile(GetParam());
    if (path.empty()) GTEST_SKIP() << "shared data not present";
    Result<CityModel> result = importCity({path});
    ASSERT_TRUE(result);
    model_ = std::move(*result);
    diagnostics_ = std::move(result.diagnostics);
  }
  CityModel model_;
  Diagnostics diagnostics_;
};

TEST_P(RealModel, EveryBuildingHasAFootprintAndAHeightOrIsNamed) {
  EXPECT_FALSE(model_.buildings.empty());
  for (const Building& b : model_.buildings) {
    if (b.footprint.empty()) {
      EXPECT_TRUE(std::any_of(diagnostics_.begin(), diagnostics_.end(), [&](const Diagnostic& d) {
        return d.object == b.object.id && d.code == Code::FootprintMissing;
      })) << b.object.id;
    }
    for (const Polygon& polygon : b.footprint) EXPECT_TRUE(isValid(polygon)) << b.object.id;
    EXPECT_GT(b.height, 0) << b.object.id;
    EXPECT_NE(b.heightSource, HeightSource::None) << b.object.id;
  }
}

TEST_P(RealModel, FootprintsAreTheUnionOfTheGroundSurfaces) {
  for (const Building& b : model_.buildings) {
    const auto surfaces = groundSurfaces(b.object);
    const double footprint = area(b.footprint);
    const double noise = 1e-6 * footprint;
    const bool fits = std::any_of(surfaces.begin(), surfaces.end(), [&](const auto& lod) {
      const auto [low, high] = unionBounds(lod.second);
      return footprint >= low - noise && footprint <= high + noise;
    });
    EXPECT_TRUE(surfaces.empty() || fits) << b.object.id << ", footprint " << footprint;
  }
}

TEST_P(RealModel, MergedHullsEqualTheReference) {
  const auto footprints = std::make_shared<const FootprintTable>(footprintTable(model_));
  if (footprints->buildingCount() < 2) return;
  const ClusterTree tree =
      makeClusterTree(footprints, std::make_shared<const Dendrogram>(test::plainDendrogram(*footprints)));
  const auto ring = [&](NodeId id) { return Ring(tree.hull(id).begin(), tree.hull(id).end()); };
  constexpr std::size_t kMostEdges = 28;  // of both children: the reference is slow
  constexpr int kMostNodes = 15;
  int compared = 0;
  for (NodeId id = 0; id < tree.nodes.size(); ++id) {
    if (tree.isLeaf(id)) continue;
    const std::vector<Ring> children{ring(tree.nodes[id].a), ring(tree.nodes[id].b)};
    if (children[0].empty() || children[1].empty()) continue;
    const std::size_t edges = children[0].size() + children[1].size();
    const std::size_t target = edges * 3 / 4;
    if (edges <= kMostEdges && compared < kMostNodes) {
      ASSERT_EQ(ring(id), test::referenceHull(children, target)) << "node " << id;
      ++compared;
    }
    if (edges <= 200 && id % 8 == 0) {
      ASSERT_EQ(test::brokenRule(ring(id), children, target), "") << "node " << id;
    }
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(SharedData, RealModel, testing::ValuesIn(kModels));

}  // namespace
}  // namespace lodestone
