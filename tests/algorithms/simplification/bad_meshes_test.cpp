// Meshes as they should not be: nothing crashes, and every face is left, removed or told.
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "algorithms/simplification/city_simplification.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/half_edges.h"
#include "algorithms/simplification/simplification.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// Those that ask pictures where they may touch a model.
constexpr std::array kByPictures{SimplifyMethod::Perception, SimplifyMethod::Combined};
constexpr std::array kMethods{SimplifyMethod::Topology, SimplifyMethod::Qem, SimplifyMethod::QemOptimal,
                              SimplifyMethod::VertexClustering};

/// Faces that the diagnostics say were left out.
std::size_t told(const Diagnostics& diagnostics) {
  std::size_t count = 0;
  for (const Diagnostic& d : diagnostics) {
    if (d.code == Code::TrianglesDropped)
      count += std::strtoul(d.text.c_str() + d.text.find_first_of("0123456789"), nullptr, 10);
  }
  return count;
}

std::size_t surfacesOf(const CityModel& city) {
  std::size_t count = 0;
  for (const Building& building : city.buildings) {
    forEachObject(building.object, [&](const CityObject& object) {
      for (const Geometry& geometry : object.geometries) count += geometry.surfaceCount();
    });
  }
  return count;
}

void expectSound(const ComponentMesh& mesh) {
  for (const Component& component : mesh.components) {
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      EXPECT_TRUE(a != b && b != c && c != a);
      for (const std::uint32_t v : mesh.triangles[t])
        EXPECT_TRUE(v >= component.firstVertex && v < component.endVertex());
    }
  }
}

/// `parts` hold triangles only. By pictures, where least shapes stay.
void expectEveryFaceAccountedForByPictures(const std::vector<Faces>& parts) {
  std::size_t faces = 0;
  for (const Faces& part : parts) faces += part.size();
  const auto city = std::make_shared<const CityModel>(cityOfParts(parts));
  const PerceiveOptions small{.views = 2, .size = 24, .slight = 0.01, .moderate = 0.02, .dramatic = 0.03};
  for (const SimplifyMethod method : kByPictures) {
    const Result<SimplifiedCity> result =
        simplifyCity(city, {.method = method, .rate = 1, .stage = 3, .unseen = true}, {}, {}, small);
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(faces, result->report.trianglesBefore + told(result.diagnostics));
    if (result->report.trianglesBefore > 0) {
      EXPECT_EQ(surfacesOf(*result->city), result->report.trianglesAfter);
    }
  }
}

/// `parts` hold triangles only. Faces in = faces left + faces removed + faces told, whatever is asked.
void expectEveryFaceAccountedFor(const std::vector<Faces>& parts) {
  std::size_t faces = 0;
  for (const Faces& part : parts) faces += part.size();
  const auto city = std::make_shared<const CityModel>(cityOfParts(parts));
  for (const SimplifyMethod method : kMethods) {
    for (const double rate : {0.0, 0.4, 0.9, 1.0}) {
      SCOPED_TRACE(testing::Message() << "method " << static_cast<int>(method) << " at " << rate);
      const Result<SimplifiedCity> result = simplifyCity(city, {.method = method, .rate = rate});
      ASSERT_TRUE(result.ok());
      const SimplifyReport& report = result->report;
      EXPECT_EQ(faces, report.trianglesBefore + told(result.diagnostics));
      if (rate == 0) {
        EXPECT_EQ(report.trianglesAfter, report.trianglesBefore);
      }
      if (rate == 1) {
        EXPECT_EQ(report.trianglesAfter, 0U);
      }
      const bool missed = std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                                      [](const Diagnostic& d) { return d.code == Code::RateNotMet; });
      if (missed) {
        const std::uint32_t first = 0;
        EXPECT_EQ(makeComponentMesh(*result->city, {&first, 1}).components.size(), 1U) << "more could go";
      } else if (method != SimplifyMethod::VertexClustering) {
        EXPECT_LE(report.trianglesAfter, std::floor((1 - rate) * report.trianglesBefore + 1e-9));
      }
      if (report.trianglesBefore > 0) {
        EXPECT_EQ(surfacesOf(*result->city), report.trianglesAfter);
      }
    }
  }
  expectEveryFaceAccountedForByPictures(parts);
}

Faces trianglesOf(const Faces& faces) {
  Faces triangles;
  for (const auto& face : faces) {
    for (std::size_t i = 2; i < face.size(); ++i) triangles.push_back({face[0], face[i - 1], face[i]});
  }
  return triangles;
}

void append(Faces& faces, const Faces& more) {
  for (const auto& face : more) faces.push_back(face);
}

TEST(BadMeshes, OneTriangle) {
  expectEveryFaceAccountedFor({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
}

TEST(BadMeshes, EdgesOfThreeAndFourTriangles) {
  Faces faces = trianglesOf(boxFaces({0, 0, 0}, {2, 2, 2}));
  append(faces, trianglesOf(boxFaces({2, 2, 0}, {4, 4, 2})));  // an edge in common: four triangles
  append(faces, {{{0, 0, 0}, {2, 0, 0}, {1, -3, 0}}, {{0, 0, 2}, {2, 0, 2}, {1, -3, 2}}});
  expectEveryFaceAccountedFor({faces, trianglesOf(boxFaces({1, 1, 2}, {3, 3, 3}))});
}

/// The same faces seen in a point, turned so that what was outside stays outside.
Faces mirrored(Faces faces, const Vec3& at) {
  for (auto& face : faces) {
    for (Vec3& p : face) p = 2 * at - p;
    std::swap(face[0], face[1]);
  }
  return faces;
}

TEST(BadMeshes, BowTies) {
  Faces faces = trianglesOf(bumpyBlock(3, {0, 0, 0}, 3, 1));
  append(faces, mirrored(faces, faces.front().front()));
  expectEveryFaceAccountedFor({faces});
}

TEST(BadMeshes, CopiesAndTrianglesWithoutArea) {
  Faces faces = trianglesOf(boxFaces({0, 0, 0}, {1, 1, 1}));
  faces.push_back(faces[3]);
  faces.push_back({faces[4][0], faces[4][2], faces[4][1]});  // a copy that is turned over: stays
  faces.push_back({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}});      // corners on a line
  faces.push_back({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}});        // two in one place
  faces.push_back({{0.2, 0.2, 0.2}, {0.2, 0.2, 0.2}, {0.2, 0.2, 0.2}});
  faces.push_back({{0, 0, 0}, {1, 0, std::numeric_limits<double>::quiet_NaN()}, {1, 1, 0}});
  expectEveryFaceAccountedFor({faces});
}

TEST(BadMeshes, NothingButTrianglesWithoutArea) {
  expectEveryFaceAccountedFor({{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}}}});
}

TEST(BadMeshes, FlippedComponentsAndFlippedTriangles) {
  Faces flipped = trianglesOf(bumpyBlock(3, {0, 0, 0}, 3, 3));
  for (auto& face : flipped) std::swap(face[0], face[1]);
  Faces mixed = trianglesOf(bumpyBlock(3, {2.8, 0, 0}, 3, 4));
  for (std::size_t i = 0; i < mixed.size(); i += 3) std::swap(mixed[i][0], mixed[i][1]);
  expectEveryFaceAccountedFor({flipped, mixed});
}

TEST(BadMeshes, ComponentsInsideOneAnotherAndInTheSamePlace) {
  std::vector<Faces> parts;
  for (int i = 0; i < 5; ++i)
    parts.push_back(trianglesOf(bumpyBlock(2, Vec3(Vec3::Constant(0.5 * i)), 6 - 1.0 * i, 7)));
  parts.push_back(parts.front());
  parts.push_back(trianglesOf(boxFaces({1, 1, 1}, {2, 2, 2})));
  parts.push_back(trianglesOf(boxFaces({1, 1, 1}, {2, 2, 2})));
  expectEveryFaceAccountedFor(parts);
}

TEST(BadMeshes, MoebiusStrip) {
  Faces strip;
  constexpr int kSteps = 12;
  const auto at = [](int i, double side) {
    const double angle = 2 * M_PI * (i % kSteps) / kSteps;
    const double turn = angle / 2 + (i >= kSteps ? M_PI : 0);
    const double r = 5 + side * std::cos(turn);
    return Vec3(std::round(1e6 * r * std::cos(angle)) / 1e6, std::round(1e6 * r * std::sin(angle)) / 1e6,
                std::round(1e6 * side * std::sin(turn)) / 1e6);
  };
  for (int i = 0; i < kSteps; ++i) {
    strip.push_back({at(i, -1), at(i + 1, -1), at(i + 1, 1)});
    strip.push_back({at(i, -1), at(i + 1, 1), at(i, 1)});
  }
  expectEveryFaceAccountedFor({strip});
}

/// Triangles between any three of a few points.
Faces soup(std::mt19937& random, unsigned points, unsigned faces) {
  std::uniform_real_distribution<double> place(0, 4);
  std::vector<Vec3> all;
  for (unsigned i = 0; i < points; ++i) all.emplace_back(place(random), place(random), place(random));
  Faces result;
  for (unsigned i = 0; i < faces; ++i)
    result.push_back({all[random() % points], all[random() % points], all[random() % points]});
  return result;
}

TEST(BadMeshes, Soups) {
  std::mt19937 random(11);
  for (int run = 0; run < 40; ++run) {
    const unsigned points = 6 + random() % 30;
    expectEveryFaceAccountedFor({soup(random, points, 10 + random() % 120), soup(random, 8, 12)});
  }
}

/// Whether every edge has an even number of triangles.
bool isClosedAll(const ComponentMesh& mesh) {
  const MeshEdges edges = makeEdges(mesh);
  for (std::uint32_t c = 0; c < mesh.components.size(); ++c) {
    if (!isClosed(edges, c)) return false;
  }
  return true;
}

/// Boxes on a grid in one object: edges of four triangles, vertices of several fans.
TEST(BadMeshes, BoxesThatShareEdges) {
  std::mt19937 random(5);
  for (int run = 0; run < 20; ++run) {
    Faces faces;
    for (int i = 0; i < 14; ++i) {
      const Vec3 min(random() % 4, random() % 4, random() % 3);
      append(faces, trianglesOf(boxFaces(min, min + Vec3::Ones())));
    }
    const ComponentMesh mesh = meshOfParts({faces});
    const bool closed = isClosedAll(mesh);
    std::vector<SimplifyMethod> methods(kMethods.begin(), kMethods.end());
    methods.insert(methods.end(), kByPictures.begin(), kByPictures.end());
    for (const SimplifyMethod method : methods) {
      for (const double rate : {0.3, 0.6, 0.9}) {
        const Simplified simplified = simplify(mesh, {.method = method, .rate = rate});
        expectSound(simplified.mesh);
        if (closed && method != SimplifyMethod::VertexClustering) {
          EXPECT_TRUE(isClosedAll(simplified.mesh)) << "copies of vertices came apart";
        }
        EXPECT_EQ(makeHalfEdges(simplified.mesh, makeEdges(simplified.mesh)).mesh.n_faces(),
                  simplified.mesh.triangleCount());
      }
    }
  }
}

/// A component of two boxes that touch at one vertex, each with its own part of the texture.
TEST(BadMeshes, BoxesThatShareATextureSeamVertexAreOneComponentAndStaySo) {
  CityModel city = cityOfParts({trianglesOf(bumpyBlock(4, {0, 0, 0}, 4, 21))});
  Geometry& geometry = city.buildings.front().object.children.front().geometries.front();
  const Vec3 seam = geometry.vertices[geometry.ringVertices.front()];
  const Faces other = mirrored(trianglesOf(bumpyBlock(4, {0, 0, 0}, 4, 21)), seam);
  const std::size_t each = other.size();
  for (const auto& face : other) {
    geometry.addRing(face);
    geometry.finishSurface();
  }
  for (std::size_t i = 0; i < geometry.ringVertices.size(); ++i) {
    const Vec3& p = geometry.vertices[geometry.ringVertices[i]];
    const float side = i < 3 * each ? 0.0F : 0.5F;
    geometry.textureCoordinates.emplace_back(side + static_cast<float>(p.x()) / 20,
                                             static_cast<float>(p.y()) / 20);
  }
  const std::uint32_t first = 0;
  const ComponentMesh mesh = makeComponentMesh(city, {&first, 1});
  ASSERT_EQ(mesh.components.size(), 1U);
  ASSERT_EQ(mesh.triangleCount(), 2 * each);
  EXPECT_TRUE(classify(mesh).contacts.empty());
  for (const SimplifyMethod method : {SimplifyMethod::Topology, SimplifyMethod::Qem}) {
    const Simplified simplified = simplify(mesh, {.method = method, .rate = 0.7});
    EXPECT_EQ(simplified.mesh.components.size(), 1U);  // the vertex holds on, or moves in both boxes
    for (std::uint32_t t = 0; t < simplified.mesh.triangleCount(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {  // coordinates are those of the place in the triangle's own part
        const Vec3& p = simplified.mesh.vertices[simplified.mesh.triangles[t][i]];
        const Vec2f& st = simplified.mesh.textureCoordinates[t][i];
        const float off = st.x() - static_cast<float>(p.x()) / 20;
        EXPECT_NEAR(off, off > 0.25F ? 0.5F : 0.0F, 1e-5F);
        EXPECT_NEAR(st.y(), p.y() / 20, 1e-5);
      }
    }
  }
}

/// A height field of a million triangles.
TEST(LongBadMeshes, AMillionTrianglesInOneComponent) {
  constexpr int kSide = 708;
  ComponentMesh mesh;
  mesh.objects.push_back({"field", 0, "3"});
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x)
      mesh.vertices.emplace_back(
          x, y, 10 * std::sin(0.02 * x) * std::cos(0.03 * y) + 0.01 * ((x * 7 + y * 13) % 11));
  }
  const auto at = [](int x, int y) { return static_cast<std::uint32_t>(y * (kSide + 1) + x); };
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      mesh.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  mesh.surfaces.resize(mesh.triangles.size());
  mesh.components.push_back({0, 0, mesh.vertexCount(), 0, mesh.triangleCount()});
  ASSERT_GT(mesh.triangleCount(), 1000000U);
  for (const SimplifyMethod method : kMethods) {
    const Simplified simplified = simplify(mesh, {.method = method, .rate = 0.9});
    expectSound(simplified.mesh);
    EXPECT_NEAR(simplified.mesh.triangleCount(), 0.1 * mesh.triangleCount(),
                method == SimplifyMethod::VertexClustering ? 0.005 * mesh.triangleCount() : 2);
  }
}

}  // namespace
}  // namespace lodestone
