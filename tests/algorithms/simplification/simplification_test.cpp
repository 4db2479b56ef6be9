#include "algorithms/simplification/simplification.h"

#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/collapse_cost.h"
#include "algorithms/simplification/contacts.h"
#include "algorithms/simplification/half_edges.h"
#include "algorithms/simplification/vertex_queue.h"
#include "tests/support/blocked_view.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

TEST(VertexQueue, GivesTheCheapestFirstWhateverChanged) {
  std::mt19937 random(3);
  VertexQueue queue(200);
  std::map<std::uint32_t, double> reference;
  for (int step = 0; step < 20000; ++step) {
    const std::uint32_t vertex = random() % 200;
    if (random() % 4 == 0) {
      queue.remove(vertex);
      reference.erase(vertex);
    } else {
      const double cost = random() % 50;  // equal costs are frequent
      queue.set(vertex, cost);
      reference[vertex] = cost;
    }
    ASSERT_EQ(queue.empty(), reference.empty());
    if (reference.empty()) continue;
    const auto least = std::min_element(reference.begin(), reference.end(), [](const auto& a, const auto& b) {
      return a.second < b.second;  // the first of equals has the smallest vertex
    });
    ASSERT_EQ(queue.top(), least->first);
  }
}

TEST(HalfEdges, HoldEveryTriangleOfTheWorstMeshes) {
  // three walls on one edge, a bow-tie, a flipped neighbour
  const Faces fan{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}},
                  {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                  {{0, 0, 1}, {0, 0, 0}, {-1, -1, 0}},
                  {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}},
                  {{2, 0, 0}, {2, 1, 0}, {3, 3, 0}}};
  const ComponentMesh mesh = meshOfParts({fan});
  ASSERT_EQ(mesh.triangleCount(), 5U);
  const HalfEdges half = makeHalfEdges(mesh, makeEdges(mesh));
  EXPECT_EQ(half.mesh.n_faces(), 5U);
  for (std::uint32_t t = 0; t < 5; ++t) {
    std::set<std::uint32_t> corners;
    for (auto v = half.mesh.cfv_begin(HalfEdges::Mesh::FaceHandle(static_cast<int>(t))); v.is_valid(); ++v)
      corners.insert(half.vertexAt(*v));
    EXPECT_EQ(corners, std::set<std::uint32_t>(mesh.triangles[t].begin(), mesh.triangles[t].end()));
  }
}

TEST(Simplification, MeetsTheRateToWithinOneOperation) {
  const ComponentMesh mesh = meshOfParts({bumpyBlock(6, {0, 0, 0}, 6, 1), bumpyBlock(5, {6, 0, 0}, 5, 2)});
  for (const SimplifyMethod method : {SimplifyMethod::Topology, SimplifyMethod::Qem}) {
    for (const double rate : {0.0, 0.1, 0.5, 0.73, 0.9}) {
      const Simplified simplified = simplify(mesh, {.method = method, .rate = rate});
      const double removed = mesh.triangleCount() - simplified.mesh.triangleCount();
      EXPECT_GE(removed, std::floor(rate * mesh.triangleCount()));
      EXPECT_LE(removed, std::ceil(rate * mesh.triangleCount()) + 2);
    }
  }
}

TEST(Simplification, FallsShortOfARateThatAsksForMore) {
  SimplifyOptions options;
  options.rate = 0.5;
  EXPECT_TRUE(fallsShort(options, 101, 51));  // 50 are gone, 51 are asked for
  EXPECT_FALSE(fallsShort(options, 101, 50));
  EXPECT_FALSE(fallsShort(options, 100, 50));
  EXPECT_FALSE(fallsShort(options, 0, 0));
  options.method = SimplifyMethod::VertexClustering;
  EXPECT_FALSE(fallsShort(options, 101, 101));
  options.method = SimplifyMethod::Combined;
  EXPECT_TRUE(fallsShort(options, 101, 101));
  options.rate = 1;  // all that is admitted
  EXPECT_FALSE(fallsShort(options, 101, 101));
}

TEST(Simplification, EverythingCanBeRemoved) {
  const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {1, 1, 1}), boxFaces({1, 0, 0}, {2, 1, 1})});
  const Simplified simplified = simplify(mesh, {.rate = 1});
  EXPECT_EQ(simplified.mesh.triangleCount(), 0U);
  EXPECT_EQ(simplified.componentsRemoved, 2U);
}

TEST(Simplification, ClosedStaysClosedAndVerticesStayWhereTheyWere) {
  const ComponentMesh mesh = meshOfParts({bumpyBlock(6, {0, 0, 0}, 6, 4)});
  const Simplified simplified = simplify(mesh, {.method = SimplifyMethod::Qem, .rate = 0.8});
  EXPECT_TRUE(isClosed(makeEdges(simplified.mesh), 0));
  for (std::uint32_t v = 0; v < simplified.mesh.vertexCount(); ++v)
    EXPECT_EQ(simplified.mesh.vertices[v], mesh.vertices[simplified.vertex[v]]);
}

TEST(Simplification, AFlatPlateOfManyTrianglesLosesNoShape) {
  Faces plate;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y)
      plate.push_back({Vec3(x, y, 0), Vec3(x + 1, y, 0), Vec3(x + 1, y + 1, 0), Vec3(x, y + 1, 0)});
  }
  Faces box = boxFaces({0, 0, -1}, {10, 10, 0});
  box.erase(box.begin() + 1);
  const ComponentMesh mesh = meshOfParts({plate});
  const Simplified simplified = simplify(mesh, {.method = SimplifyMethod::Topology, .rate = 0.7});
  double area = 0;
  for (std::uint32_t t = 0; t < simplified.mesh.triangleCount(); ++t)
    area += areaNormal(simplified.mesh, t).norm() / 2;
  EXPECT_NEAR(area, 100, 1e-9);  // inner vertices go first: those of the rim cost QEM*
}

/// Toothed panels and floors, all closed: what holds open edges makes no difference.
TEST(Simplification, ContactsOutliveTheInsideWhereQemLosesThem) {
  const ComponentMesh mesh = meshOfParts(panelledBlock());
  const Classification classes = classify(mesh);
  const auto broken = [&](const SimplifyOptions& options) {
    const auto reports = followContacts(mesh, classes, simplify(mesh, classes, options));
    return std::count_if(reports.begin(), reports.end(),
                         [](const ContactReport& report) { return report.fate != ContactFate::Kept; });
  };
  ASSERT_EQ(classes.contacts.size(), 128U);
  EXPECT_EQ(broken({.rate = 0.7, .a = 2}), 0);
  EXPECT_GE(broken({.method = SimplifyMethod::Qem, .rate = 0.7}), 10);
  EXPECT_GE(broken({.method = SimplifyMethod::Qem, .rate = 0.7, .rimPlanes = true}), 10);
}

/// The corner of an eave, on a post: up the hip it stays in the planes of both slopes, or next to them.
TEST(Simplification, TheCornerOfAnOpenRoofDoesNotRunUpItsHipForNothing) {
  const Vec3 corner(0, 0, 0);
  const Vec3 top(2, 2, 2);
  for (const double bend : {0.0, 0.1}) {  // of the first slope, along its middle
    const Vec3 middle(2, 1, 1 + bend);
    const Faces roof{{corner, Vec3(4, 0, 0), middle}, {corner, middle, top}, {corner, top, Vec3(0, 4, 0)}};
    const ComponentMesh mesh = meshOfParts({roof, boxFaces({-0.1, -0.1, -3}, {0.1, 0.1, 0})});
    const Classification classes = classify(mesh);
    const std::uint32_t from = vertexAt(mesh, 0, corner);
    const std::uint32_t to = vertexAt(mesh, 0, top);
    ASSERT_EQ(classes.vertices[from], VertexClass::Boundary);
    const CollapseCost cost(mesh, &classes, {.a = 2});
    EXPECT_LT(cost(from, to, false), 1);
    EXPECT_GT(cost(from, to, true), 100);
  }
}

/// A component whose every triangle has its texture coordinates from `place(position, chart of the
/// triangle)`.
template <class Place>
ComponentMesh textured(ComponentMesh mesh, const std::vector<int>& charts, const Place& place) {
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    std::array<Vec2f, 3> st;
    for (std::size_t i = 0; i < 3; ++i) st[i] = place(mesh.vertices[mesh.triangles[t][i]], charts[t]);
    mesh.textureCoordinates.push_back(st);
    mesh.surfaces[t].texture = 0;
    mesh.surfaces[t].material = charts[t];  // says afterwards what chart a triangle was of
  }
  return mesh;
}

/// Every corner is a corner of charts: none could move if borders were sacred.
TEST(Simplification, ChartsGoOnOverWhatTheyTakeFromOthers) {
  Faces plate;
  std::vector<int> charts;
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      plate.push_back({Vec3(x, y, 0), Vec3(x + 1, y, 0), Vec3(x + 1, y + 1, 0)});
      plate.push_back({Vec3(x, y, 0), Vec3(x + 1, y + 1, 0), Vec3(x, y + 1, 0)});
      charts.insert(charts.end(), 2, 8 * x + y);
    }
  }
  const auto place = [](const Vec3& p, int chart) {
    const float turn = 0.2F * static_cast<float>(chart);  // each chart lies elsewhere, turned in its own way
    const Vec2f st(p.x(), p.y());
    return Vec2f(std::cos(turn) * st.x() - std::sin(turn) * st.y() + 3.0F * static_cast<float>(chart),
                 std::sin(turn) * st.x() + std::cos(turn) * st.y());
  };
  const ComponentMesh mesh = textured(meshOfParts({plate}), charts, place);
  for (const SimplifyMethod method : {SimplifyMethod::Topology, SimplifyMethod::Qem}) {
    const ComponentMesh left = simplify(mesh, {.method = method, .rate = 0.8}).mesh;
    EXPECT_LE(left.triangleCount(), 26U);
    ASSERT_GT(left.triangleCount(), 0U);
    for (std::uint32_t t = 0; t < left.triangleCount(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec2f expected = place(left.vertices[left.triangles[t][i]], left.surfaces[t].material);
        EXPECT_LT((left.textureCoordinates[t][i] - expected).norm(), 1e-3F);
      }
    }
  }
}

/// A photo for each side of a block: what is next to it in the image is never shown.
TEST(Simplification, ChartsStayInTheImageThatTheyLieIn) {
  const Faces block = bumpyBlock(3, {0, 0, 0}, 3, 9);
  std::vector<int> charts(block.size());
  for (std::size_t t = 0; t < charts.size(); ++t) charts[t] = static_cast<int>(t % 12 / 2);
  const auto place = [](const Vec3& p, int chart) {
    const Vec3 q = (p + Vec3::Ones()) / 5;
    const Vec2f st = chart < 2 ? Vec2f(q.x(), q.y()) : chart < 4 ? Vec2f(q.x(), q.z()) : Vec2f(q.y(), q.z());
    return Vec2f(st.cwiseMax(0).cwiseMin(1));
  };
  const ComponentMesh mesh = textured(meshOfParts({block}), charts, place);
  const Simplified simplified = simplify(mesh, {.rate = 0.9});
  EXPECT_LE(simplified.mesh.triangleCount(), mesh.triangleCount() / 10 + 1);
  EXPECT_EQ(simplified.mesh.components.size(), 1U);
  for (const auto& corners : simplified.mesh.textureCoordinates) {
    for (const Vec2f& st : corners) {
      EXPECT_GE(st.minCoeff(), 0);
      EXPECT_LE(st.maxCoeff(), 1);
    }
  }
}

/// A flat strip whose texture turns back in the middle, as tiles do that are mirrored.
TEST(Simplification, ATextureThatFoldsIsNotDrawnOut) {
  Faces strip;
  for (int x = 0; x < 8; ++x) {
    strip.push_back({Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x + 1, 1, 0)});
    strip.push_back({Vec3(x, 0, 0), Vec3(x + 1, 1, 0), Vec3(x, 1, 0)});
  }
  const auto place = [](const Vec3& p, int) { return Vec2f(4 - std::abs(p.x() - 4), p.y()); };
  const ComponentMesh mesh = textured(meshOfParts({strip}), std::vector<int>(strip.size(), 0), place);
  const ComponentMesh left = simplify(mesh, {.method = SimplifyMethod::Qem, .rate = 0.75}).mesh;
  ASSERT_EQ(left.triangleCount(), 4U);
  for (std::uint32_t t = 0; t < left.triangleCount(); ++t) {
    double min = 8;
    double max = 0;
    for (const std::uint32_t v : left.triangles[t]) {
      min = std::min(min, left.vertices[v].x());
      max = std::max(max, left.vertices[v].x());
    }
    EXPECT_TRUE(max <= 4 || min >= 4);  // none goes across the fold
  }
}

TEST(Simplification, AComponentThatTouchesGoesAfterOneThatDoesNot) {
  const ComponentMesh mesh =
      meshOfParts({tubeFaces({5, 5, 0}, 1), tubeFaces({40, 5, 0}, 1.1), boxFaces({0, 0, -1}, {20, 20, 0})});
  const auto left = [&](SimplifyMethod method) {
    return simplify(mesh, {.method = method, .rate = 0.25, .a = 2}).component;
  };
  EXPECT_EQ(left(SimplifyMethod::Topology), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(left(SimplifyMethod::Qem), (std::vector<std::uint32_t>{1, 2}));  // the smaller one went
}

TEST(Simplification, TheSameForEveryRun) {
  const ComponentMesh mesh = meshOfParts({bumpyBlock(6, {0, 0, 0}, 6, 1), bumpyBlock(5, {5.5, 0, 0}, 5, 2)});
  EXPECT_EQ(simplify(mesh, {.rate = 0.6}).mesh.triangles, simplify(mesh, {.rate = 0.6}).mesh.triangles);
}

}  // namespace
}  // namespace lodestone
