#include "model/face_count.h"

#include <gtest/gtest.h>

#include "model/city_model.h"
#include "model/exterior.h"

namespace lodestone {
namespace {

using Corners = std::vector<Vec3>;

Geometry faces(const std::vector<std::pair<Corners, SurfaceType>>& list) {
  Geometry geometry;
  geometry.lod = "2";
  for (const auto& [corners, type] : list) {
    geometry.addRing(corners);
    geometry.finishSurface({type});
  }
  return geometry;
}

const Corners kGround{{0, 0, 0}, {0, 6, 0}, {8, 6, 0}, {8, 0, 0}};
const Corners kSouth{{0, 0, 0}, {8, 0, 0}, {8, 0, 5}, {0, 0, 5}};
const Corners kNorth{{8, 6, 0}, {0, 6, 0}, {0, 6, 5}, {8, 6, 5}};
const Corners kWestGable{{0, 6, 0}, {0, 0, 0}, {0, 0, 5}, {0, 3, 8}, {0, 6, 5}};
const Corners kEastGable{{8, 0, 0}, {8, 6, 0}, {8, 6, 5}, {8, 3, 8}, {8, 0, 5}};
const Corners kSouthRoof{{0, 0, 5}, {8, 0, 5}, {8, 3, 8}, {0, 3, 8}};
const Corners kNorthRoof{{8, 6, 5}, {0, 6, 5}, {0, 3, 8}, {8, 3, 8}};

/// Labels of ground, walls and roofs.
Geometry gabledHouse(SurfaceType ground, SurfaceType wall, SurfaceType roof) {
  return faces({{kGround, ground},
                {kSouth, wall},
                {kNorth, wall},
                {kWestGable, wall},
                {kEastGable, wall},
                {kSouthRoof, roof},
                {kNorthRoof, roof}});
}

// Two wall quads, two gables of three triangles, two roofs of two; the ground is written and never seen.
constexpr FaceCount kHouse{2 + 6 + 4, 2 + 4 + 6 + 4};

TEST(FaceCount, IsTheSameWithLabelsAndWithout) {
  EXPECT_EQ(facesOf(gabledHouse(SurfaceType::Ground, SurfaceType::Wall, SurfaceType::Roof)), kHouse);
  constexpr SurfaceType kNone = SurfaceType::Unknown;
  EXPECT_EQ(facesOf(gabledHouse(kNone, kNone, kNone)), kHouse);
}

TEST(FaceCount, LabelsSayWhatIsGround) {
  // A floor that is no ground: a bridge between two houses.
  const FaceCount seen = facesOf(gabledHouse(SurfaceType::OuterFloor, SurfaceType::Wall, SurfaceType::Roof));
  EXPECT_EQ(seen, (FaceCount{kHouse.polygons + 2, kHouse.triangles}));
}

TEST(FaceCount, GroundWithoutALabelMayFaceEitherWay) {
  Corners up(kGround.rbegin(), kGround.rend());
  constexpr SurfaceType kNone = SurfaceType::Unknown;
  EXPECT_EQ(facesOf(faces({{up, kNone}, {kSouth, kNone}})), (FaceCount{1, 4}));
  EXPECT_EQ(facesOf(faces({{up, kNone}})), (FaceCount{2, 2}))
      << "a sheet that has nothing above it is all there is";
}

TEST(FaceCount, FacesOfRoomsAreNone) {
  EXPECT_EQ(facesOf(faces({{kSouth, SurfaceType::Wall}, {kNorth, SurfaceType::InteriorWall}})),
            (FaceCount{1, 2}));
}

TEST(FaceCount, HolesAndTornFaces) {
  Geometry wall;
  wall.addRing(kSouth);
  wall.addRing({{3, 0, 1}, {3, 0, 2}, {4, 0, 2}, {4, 0, 1}});
  wall.finishSurface({SurfaceType::Wall});
  wall.addRing({{0, 0, 0}, {1, 0, 0}});
  wall.finishSurface({SurfaceType::Wall});
  EXPECT_EQ(facesOf(wall), (FaceCount{8, 8}));
  EXPECT_EQ(facesOf(Geometry{}), FaceCount{});
}

TEST(FaceCount, WallsThatLeanAreNoWallQuads) {
  const Corners leaning{{0, 0, 0}, {8, 0, 0}, {8, 1, 5}, {0, 1, 5}};
  const Corners crooked{{0, 0, 0}, {8, 0.001, 0}, {8, 0, 5}, {0, 0.002, 5}};  // as coordinates are rounded
  EXPECT_EQ(facesOf(faces({{leaning, SurfaceType::Wall}})).polygons, 2U);
  EXPECT_EQ(facesOf(faces({{crooked, SurfaceType::Wall}})).polygons, 1U);
}

MultiPolygon square(double side) {
  return {{{{0, 0}, {side, 0}, {side, side}, {0, side}}, {}}};
}

TEST(FaceCount, OfABlockIsThePapers) {
  EXPECT_EQ(facesOfBlock(square(1)), (FaceCount{6, 12}));
  // Xinxiang's 814,592 = 2 · 502,336 − 2 · 95,042 + 2 for each of its two holes
  MultiPolygon yard = square(9);
  yard[0].holes.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  EXPECT_EQ(facesOfBlock(yard), (FaceCount{2 * 8U - 2 + 2, 4 * 8U - 4 + 4}));
  EXPECT_EQ(facesOfBlock({}), FaceCount{});
}

TEST(FaceCount, OfABuildingIsWhatItIsDrawnWith) {
  Building building;
  building.object.type = ObjectType::Building;
  building.footprint = square(5);
  EXPECT_EQ(facesOf(building), FaceCount{}) << "no height: nothing is drawn";
  building.height = 3;
  EXPECT_EQ(facesOf(building), facesOfBlock(building.footprint));
  building.object.geometries = {gabledHouse(SurfaceType::Ground, SurfaceType::Wall, SurfaceType::Roof)};
  EXPECT_EQ(facesOf(building), kHouse);
}

TEST(FaceCount, ShareIsOfPolygons) {
  EXPECT_EQ(share({3, 100}, {4, 8}), 0.75);
  EXPECT_EQ(share({}, {}), 1);
}

}  // namespace
}  // namespace lodestone
