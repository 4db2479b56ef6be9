#include "algorithms/geometry/triangle_tree.h"

#include <random>

#include <gtest/gtest.h>

#include "algorithms/geometry/box_pairs.h"
#include "algorithms/geometry/triangle_distance.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

struct Soup {
  std::vector<Vec3> vertices;
  std::vector<TriangleTree::Triangle> triangles;
};

Soup randomSoup(std::mt19937& random, int count, double size) {
  std::uniform_real_distribution<double> place(-10, 10);
  std::uniform_real_distribution<double> spread(-size, size);
  Soup soup;
  for (int i = 0; i < count; ++i) {
    const Vec3 centre(place(random), place(random), place(random));
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (int corner = 0; corner < 3; ++corner)
      soup.vertices.push_back(centre + Vec3(spread(random), spread(random), spread(random)));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriangleCorners cornersOf(const Soup& soup, std::size_t t) {
  return {soup.vertices[soup.triangles[t][0]], soup.vertices[soup.triangles[t][1]],
          soup.vertices[soup.triangles[t][2]]};
}

TEST(TriangleTree, ClosestPointEqualsTheLeastOverAllTriangles) {
  std::mt19937 random(1);
  const Soup soup = randomSoup(random, 300, 2);
  const TriangleTree tree(soup.vertices, soup.triangles);
  std::uniform_real_distribution<double> place(-14, 14);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p(place(random), place(random), place(random));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
      least = std::min(least, (closestPoint(cornersOf(soup, t), p) - p).squaredNorm());
    EXPECT_EQ(tree.closest(p).squared, least);
  }
}

/// Least distance of points strewn over both triangles: never below the true one, and near to it.
double strewnDistance(const TriangleCorners& s, const TriangleCorners& t) {
  constexpr int kSteps = 24;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps;
      const double v = static_cast<double>(j) / kSteps;
      const Vec3 p = s[0] + u * (s[1] - s[0]) + v * (s[2] - s[0]);
      least = std::min(least, (closestPoint(t, p) - p).norm());
    }
  }
  return least;
}

TEST(TriangleDistance, LiesJustBelowTheDistanceOfStrewnPoints) {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    const Soup soup = randomSoup(random, 2, 8);
    const double exact = std::sqrt(squaredDistance(cornersOf(soup, 0), cornersOf(soup, 1)));
    const double strewn = strewnDistance(cornersOf(soup, 0), cornersOf(soup, 1));
    EXPECT_LE(exact, strewn + 1e-12);
    EXPECT_GE(exact, strewn - 1.2);  // a step of the strewing
    EXPECT_NEAR(exact, std::sqrt(squaredDistance(cornersOf(soup, 1), cornersOf(soup, 0))), 1e-12);
  }
}

TEST(TriangleTree, DistanceEqualsTheLeastOverAllPairs) {
  std::mt19937 random(3);
  for (int run = 0; run < 20; ++run) {
    const Soup a = randomSoup(random, 20, 0.5);
    const Soup b = randomSoup(random, 25, 0.5);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < a.triangles.size(); ++s) {
      for (std::size_t t = 0; t < b.triangles.size(); ++t)
        least = std::min(least, squaredDistance(cornersOf(a, s), cornersOf(b, t)));
    }
    const TriangleTree treeA(a.vertices, a.triangles);
    const TriangleTree treeB(b.vertices, b.triangles);
    EXPECT_NEAR(treeA.distance(treeB), std::sqrt(least), 1e-12);
    EXPECT_EQ(treeA.distance(treeB, 1e-9), least < 1e-18 ? std::sqrt(least) : 1e-9);
  }
}

TEST(TriangleTree, EnclosesWhatLiesInABoxEvenWhereRaysGrazeItsEdges) {
  const ComponentMesh mesh = meshOfParts({boxFaces({0, 0, 0}, {4, 4, 4})});
  const TriangleTree tree(mesh.vertices, mesh.triangles);
  for (double x = -0.5; x < 5; x += 0.5) {
    for (double y = -0.5; y < 5; y += 0.5) {
      for (double z = -0.5; z < 5; z += 0.5) {
        const Vec3 p(x, y, z);
        if ((p.array() == 0).any() || (p.array() == 4).any()) continue;  // on the surface
        EXPECT_EQ(tree.encloses(p), (p.array() > 0).all() && (p.array() < 4).all()) << p.transpose();
      }
    }
  }
}

TEST(TriangleTree, VisitsEveryTriangleWhoseBoxMeets) {
  std::mt19937 random(4);
  const Soup soup = randomSoup(random, 200, 1);
  const TriangleTree tree(soup.vertices, soup.triangles);
  std::uniform_real_distribution<double> place(-10, 10);
  for (int run = 0; run < 50; ++run) {
    Box3 box;
    box.add(Vec3(place(random), place(random), place(random)));
    box.add(box.min + Vec3(2, 3, 4));
    std::vector<bool> visited(soup.triangles.size(), false);
    tree.forEachIn(box, [&](std::uint32_t t) { visited[t] = true; });
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
      Box3 own;
      for (const Vec3& corner : cornersOf(soup, t)) own.add(corner);
      EXPECT_TRUE(visited[t] || !meet(own, box));
    }
  }
}

TEST(BoxPairs, AreThoseOfAllPairs) {
  std::mt19937 random(5);
  for (int run = 0; run < 20; ++run) {
    std::vector<Box3> boxes(60);
    for (Box3& box : boxes) {
      const Vec3 min(random() % 20, random() % 20, random() % 20);
      if (random() % 10 == 0) continue;  // empty
      box.add(min);
      box.add(min + Vec3(random() % 4, random() % 4, random() % 4));
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::uint32_t a = 0; a < boxes.size(); ++a) {
      for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
        if (!boxes[a].empty() && !boxes[b].empty() && meet(boxes[a], boxes[b])) expected.emplace_back(a, b);
      }
    }
    EXPECT_EQ(meetingPairs(boxes), expected);
  }
}

}  // namespace
}  // namespace lodestone
