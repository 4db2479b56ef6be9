#include "algorithms/simplification/classification.h"

#include <map>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "algorithms/simplification/edge_contact.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

VertexClass classAt(const ComponentMesh& mesh, const Classification& classes, std::uint32_t component,
                    const Vec3& position) {
  return classes.vertices.at(vertexAt(mesh, component, position));
}

std::size_t count(const ComponentMesh& mesh, const Classification& classes, std::uint32_t component,
                  VertexClass wanted) {
  std::size_t found = 0;
  for (std::uint32_t v = mesh.components[component].firstVertex; v < mesh.components[component].endVertex();
       ++v)
    found += classes.vertices[v] == wanted ? 1 : 0;
  return found;
}

TEST(ComponentMesh, PartsAreNeverWeldedToEachOther) {
  const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {1, 1, 1}), boxFaces({1, 0, 0}, {2, 1, 1})});
  ASSERT_EQ(mesh.components.size(), 2U);
  EXPECT_EQ(mesh.components[0].vertexCount, 8U);
  EXPECT_EQ(mesh.components[1].triangleCount, 12U);
  EXPECT_EQ(mesh.objects[mesh.components[1].object].id, "part-1");
}

TEST(ComponentMesh, OneObjectFallsIntoItsConnectedSets) {
  Faces faces = boxFaces({0, 0, 0}, {1, 1, 1});
  for (const auto& face : boxFaces({5, 0, 0}, {6, 1, 1})) faces.push_back(face);
  const ComponentMesh mesh = meshOfParts({faces});
  ASSERT_EQ(mesh.components.size(), 2U);
  EXPECT_EQ(mesh.components[0].object, mesh.components[1].object);
}

TEST(ComponentMesh, CopiesAndTrianglesWithoutAreaAreCounted) {
  Faces faces = boxFaces({0, 0, 0}, {1, 1, 1});
  faces.push_back(faces.front());
  Diagnostics diagnostics;
  const std::uint32_t first = 0;
  const ComponentMesh mesh = makeComponentMesh(cityOfParts({faces}), {&first, 1}, &diagnostics);
  EXPECT_EQ(mesh.triangleCount(), 12U);
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics.front().code, Code::TrianglesDropped);
}

TEST(Classification, BoxThroughBoxHasBothEndsOutside) {
  // a beam right through a block: all ends of its long edges are outside, and boundary
  // beside the diagonals of the block's faces, which it would pierce
  const ComponentMesh mesh =
      meshOfParts({boxFaces({0, 0, 0}, {4, 4, 4}), boxFaces({-2, 0.5, 2}, {6, 1, 2.5})});
  const Classification classes = classify(mesh);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Boundary), 8U);
  EXPECT_EQ(count(mesh, classes, 0, VertexClass::Boundary), 0U);
  ASSERT_FALSE(classes.edges.empty());
  for (const BoundaryEdge& edge : classes.edges) {
    EXPECT_TRUE(edge.passesThrough);
    EXPECT_EQ(edge.rule, InsideRule::Solid);
  }
  EXPECT_EQ(classes.contacts, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}}));
}

TEST(Classification, BeamEndInsideIsBoundaryItsOtherEndIsNot) {
  const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {4, 4, 4}), boxFaces({2, 1, 1}, {6, 2, 2})});
  const Classification classes = classify(mesh);
  EXPECT_EQ(classAt(mesh, classes, 1, {2, 1, 1}), VertexClass::Boundary);
  EXPECT_EQ(classAt(mesh, classes, 1, {6, 1, 1}), VertexClass::Ordinary);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Boundary), 4U);
}

TEST(Classification, TheInsideOfAFlippedSolidIsStillItsInside) {
  Faces flipped = boxFaces({0, 0, 0}, {4, 4, 4});
  for (auto& face : flipped) std::reverse(face.begin(), face.end());
  const ComponentMesh mesh = meshOfParts({flipped, boxFaces({2, 1, 1}, {6, 2, 2})});
  const Classification classes = classify(mesh);
  EXPECT_EQ(classAt(mesh, classes, 1, {2, 1, 1}), VertexClass::Boundary);
  EXPECT_EQ(classAt(mesh, classes, 1, {6, 1, 1}), VertexClass::Ordinary);
}

TEST(Classification, BoxOnSlabTouchesWithItsFoot) {
  const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {10, 10, 1}), boxFaces({3, 3, 1}, {5, 5, 4})});
  const Classification classes = classify(mesh);
  for (const Vec3& foot : {Vec3(3, 3, 1), Vec3(5, 3, 1), Vec3(5, 5, 1), Vec3(3, 5, 1)})
    EXPECT_EQ(classAt(mesh, classes, 1, foot), VertexClass::Boundary);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Boundary), 4U);
  const std::uint32_t foot = vertexAt(mesh, 1, {3, 3, 1});
  EXPECT_NEAR(edgeComponentAngle(mesh, classes, foot, vertexAt(mesh, 1, {5, 3, 1})), 0, 1e-9);
  EXPECT_NEAR(edgeComponentAngle(mesh, classes, foot, vertexAt(mesh, 1, {3, 3, 4})), 90, 1e-9);
}

TEST(Classification, AGapCountsUpToTheShareOfTheEdge) {
  const auto at = [](double gap) {
    const ComponentMesh mesh =
        meshOfParts({boxFaces({0, 0, 0}, {10, 10, 1}), boxFaces({3, 3, 1 + gap}, {5, 5, 3 + gap})});
    return std::pair(count(mesh, classify(mesh), 1, VertexClass::Boundary), classify(mesh).edges);
  };
  const auto [near, edges] = at(0.005 * 2);
  EXPECT_EQ(near, 4U);
  for (const BoundaryEdge& edge : edges) EXPECT_EQ(edge.rule, InsideRule::Lengthened);
  EXPECT_EQ(at(0.03 * 2).first, 0U);
}

TEST(Classification, RoofEmbeddedOnWallsMarksAllFourCorners) {
  // the roof's bottom is one large quad of two triangles that overhangs the walls: figure 11
  const Faces roof{{{-1, -1, 3}, {-1, 7, 3}, {9, 7, 3}, {9, -1, 3}},
                   {{-1, -1, 3}, {9, -1, 3}, {4, 3, 6}},
                   {{9, -1, 3}, {9, 7, 3}, {4, 3, 6}},
                   {{9, 7, 3}, {-1, 7, 3}, {4, 3, 6}},
                   {{-1, 7, 3}, {-1, -1, 3}, {4, 3, 6}}};
  for (const double top : {3.0, 3.2}) {  // walls that end at the roof's bottom, and that reach into it
    const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {8, 6, top}), roof});
    const Classification classes = classify(mesh);
    for (const Vec3& corner : {Vec3(-1, -1, 3), Vec3(-1, 7, 3), Vec3(9, 7, 3), Vec3(9, -1, 3)})
      EXPECT_EQ(classAt(mesh, classes, 1, corner), VertexClass::Boundary) << top;
    EXPECT_EQ(classAt(mesh, classes, 1, {4, 3, 6}), VertexClass::Ordinary) << top;
  }
}

TEST(Classification, AnOpenBoxHasHoleVerticesAtItsRim) {
  Faces open = boxFaces({0, 0, 0}, {1, 1, 1});
  open.erase(open.begin() + 1);  // the top
  const ComponentMesh mesh = meshOfParts({open});
  const Classification classes = classify(mesh);
  EXPECT_EQ(count(mesh, classes, 0, VertexClass::Hole), 4U);
  EXPECT_EQ(classAt(mesh, classes, 0, {0, 0, 0}), VertexClass::Ordinary);
  EXPECT_TRUE(classes.fill.empty());
}

TEST(Classification, AHoleBetweenBoundaryVerticesIsFilledAndItsVerticesAreBoundary) {
  Faces open = boxFaces({3, 3, 1}, {5, 5, 4});
  open.erase(open.begin());  // the bottom, where it stands on the slab
  const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {10, 10, 1}), open});
  const Classification classes = classify(mesh);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Hole), 0U);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Boundary), 4U);
  EXPECT_EQ(classes.fill.size(), 2U);
}

TEST(Classification, AColumnThroughASlabPassesThroughIt) {
  const ComponentMesh mesh =
      meshOfParts({boxFaces({0, 0, 3}, {10, 10, 3.3}), boxFaces({6, 1, 0}, {7, 2, 8})});
  const Classification classes = classify(mesh);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Boundary), 8U);
  EXPECT_EQ(count(mesh, classes, 0, VertexClass::Boundary), 0U);
}

/// A leg that ends flush with the far side of a top: its free end has nothing to do with the top, whichever
/// way up the model stands.
TEST(Classification, AnEndOnTheFarSideOfAPlateIsInsideItsOtherEndIsNot) {
  const Faces plate = boxFaces({0, 0, 3}, {10, 10, 3.3});
  for (const auto& [leg, flush, free] :
       {std::tuple(boxFaces({6, 1, 0}, {7, 2, 3.3}), 3.3, 0.0), {boxFaces({6, 1, 3}, {7, 2, 8}), 3.0, 8.0}}) {
    const ComponentMesh mesh = meshOfParts({plate, leg});
    const Classification classes = classify(mesh);
    EXPECT_EQ(classAt(mesh, classes, 1, {6, 1, flush}), VertexClass::Boundary);
    EXPECT_EQ(classAt(mesh, classes, 1, {6, 1, free}), VertexClass::Ordinary);
    EXPECT_EQ(count(mesh, classes, 1, VertexClass::Boundary), 4U);
    for (const BoundaryEdge& edge : classes.edges) {
      if (edge.other == 0) {
        EXPECT_FALSE(edge.passesThrough);
      }
    }
  }
}

TEST(Classification, AHitInTheLengthenedPartMarksOnlyTheEndThatItExtends) {
  // above a thin slab: the lengthened foot would reach through it
  const ComponentMesh mesh =
      meshOfParts({boxFaces({0, 0, 0}, {10, 10, 0.01}), boxFaces({4, 4, 0.02}, {5, 5, 10.02})});
  const Classification classes = classify(mesh);
  EXPECT_EQ(classAt(mesh, classes, 1, {4, 4, 0.02}), VertexClass::Boundary);
  EXPECT_EQ(classAt(mesh, classes, 1, {4, 4, 10.02}), VertexClass::Ordinary);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Boundary), 4U);
}

TEST(Classification, AComponentInsideAnotherHasOrdinaryVertices) {
  const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {10, 10, 10}), boxFaces({4, 4, 4}, {5, 5, 5})});
  const Classification classes = classify(mesh);
  EXPECT_EQ(count(mesh, classes, 1, VertexClass::Ordinary), 8U);
  EXPECT_TRUE(classes.edges.empty());
  EXPECT_TRUE(classes.contacts.empty());
}

TEST(Classification, AnOpenSheetDecidesByItsNormal) {
  // a wall without thickness, its normal towards +x; the beam's end behind it is inside
  const Faces wall{{{0, 0, 0}, {0, 10, 0}, {0, 10, 10}, {0, 0, 10}}};
  const ComponentMesh mesh = meshOfParts({wall, boxFaces({-1, 4, 4}, {6, 5, 5})});
  const Classification classes = classify(mesh);
  EXPECT_EQ(classAt(mesh, classes, 1, {-1, 4, 4}), VertexClass::Boundary);
  EXPECT_EQ(classAt(mesh, classes, 1, {6, 4, 4}), VertexClass::Ordinary);
  for (const BoundaryEdge& edge : classes.edges) {
    EXPECT_EQ(edge.rule, edge.other == 0 ? InsideRule::Normal : InsideRule::Solid);
  }
}

/// Ends in the plane of a triangle within the noise, on edges that are nearly flat: the place where the edge
/// goes through the plane is far away.
TEST(EdgeContact, OfAFlatEdgeIsWhereItsEndLies) {
  const TriangleCorners triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  constexpr double kTolerance = 1e-5;
  const auto contact = [&](Vec3 p1, Vec3 p2, bool turned) {
    for (Vec3* p : {&p1, &p2}) p->z() *= kTolerance;
    EdgeContact found = edgeContact(turned ? p2 : p1, turned ? p1 : p2, triangle, 0.01, kTolerance);
    if (turned) {
      std::swap(found.touches1, found.touches2);
      std::swap(found.reaches1, found.reaches2);
    }
    return found;
  };
  for (const bool turned : {false, true}) {
    for (const double rise : {2.0, -2.0, 10.0, -10.0, 1e4, -1e4}) {  // of the edge, in tolerances
      const EdgeContact inside = contact({0.2, 0.2, 0.9}, {0.4, 0.3, 0.9 + rise}, turned);
      EXPECT_TRUE(inside.meets && inside.touches1) << rise;
      EXPECT_FALSE(inside.touches2) << rise;
    }
    const EdgeContact far =
        contact({-5, 0.3, 0.9}, {5, 0.3, -1.1}, turned);  // over the triangle in its middle
    EXPECT_FALSE(far.touches1 || far.touches2);
    const EdgeContact through = contact({-4, 0.3, 0.9}, {4.5, 0.3, -1.1}, turned);
    EXPECT_FALSE(through.touches1 || through.touches2);
    EXPECT_FALSE(contact({-5, 0.3, 0.9}, {-4, 0.3, 5}, turned).meets);
  }
}

/// Every edge of every component against every triangle of every other one, with the same test of one pair.
std::set<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> contactsByBruteForce(
    const ComponentMesh& mesh, double gap) {
  std::set<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> found;
  const double tolerance = 1e-6 * bounds(mesh).size().norm();
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
      for (std::uint32_t u = 0; u < mesh.triangleCount(); ++u) {
        if (componentOfTriangle(mesh, t) == componentOfTriangle(mesh, u)) continue;
        const auto& [p, q, r] = mesh.triangles[u];
        if (edgeContact(mesh.vertices[a], mesh.vertices[b],
                        {mesh.vertices[p], mesh.vertices[q], mesh.vertices[r]}, gap, tolerance)
                .meets)
          found.insert({{a, b}, u});
      }
    }
  }
  return found;
}

TEST(Classification, FindsWhatBruteForceFindsOnRandomBoxes) {
  std::mt19937 random(7);
  // a small grid of whole numbers: touching, overlapping and coplanar faces are the rule
  const auto pick = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most)); };
  for (int run = 0; run < 30; ++run) {
    std::vector<Faces> parts;
    for (int part = 0; part < 8; ++part) {
      const Vec3 min(pick(8), pick(8), pick(8));
      parts.push_back(boxFaces(min, min + Vec3(1 + pick(4), 1 + pick(4), 1 + pick(4))));
      if (part % 3 == 0) parts.back().pop_back();
    }
    const ComponentMesh mesh = meshOfParts(parts);
    const Classification classes = classify(mesh);
    std::set<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> found;
    for (const BoundaryEdge& edge : classes.edges) {
      for (const std::uint32_t triangle : edge.triangles) found.insert({{edge.from, edge.to}, triangle});
    }
    EXPECT_EQ(found, contactsByBruteForce(mesh, classes.gap)) << run;
  }
}

/// By place and part, in the mirror's own coordinates.
std::map<std::array<double, 4>, VertexClass> classesByPlace(const ComponentMesh& mesh, const Vec3& mirror) {
  const Classification classes = classify(mesh);
  std::map<std::array<double, 4>, VertexClass> result;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.vertices[v].cwiseProduct(mirror);
    const std::uint32_t object = mesh.objects[mesh.components[componentOfVertex(mesh, v)].object].id.back();
    result[{p.x(), p.y(), p.z(), static_cast<double>(object)}] = classes.vertices[v];
  }
  return result;
}

TEST(Classification, IsTheSameForAModelInAMirror) {
  std::mt19937 random(17);
  const auto pick = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most)); };
  for (int run = 0; run < 40; ++run) {
    std::vector<Faces> parts;
    for (int part = 0; part < 7; ++part) {
      const Vec3 min(pick(8), pick(8), pick(8));
      Faces triangles;
      for (const auto& face : boxFaces(min, min + Vec3(1 + pick(4), 1 + pick(4), 1 + pick(4)))) {
        triangles.push_back({face[0], face[1], face[2]});
        triangles.push_back({face[0], face[2], face[3]});
      }
      if (part % 3 == 0) triangles.resize(10);
      parts.push_back(triangles);
    }
    const auto expected = classesByPlace(meshOfParts(parts), Vec3::Ones());
    for (const Vec3& mirror : {Vec3(1, 1, -1), Vec3(-1, 1, 1), Vec3(-1, -1, -1)}) {
      std::vector<Faces> mirrored = parts;
      for (Faces& faces : mirrored) {
        for (auto& face : faces) {
          for (Vec3& p : face) p = p.cwiseProduct(mirror);
          std::swap(face[1], face[2]);  // what was outside stays outside
        }
      }
      EXPECT_EQ(classesByPlace(meshOfParts(mirrored), mirror), expected) << run;
    }
  }
}

}  // namespace
}  // namespace lodestone
