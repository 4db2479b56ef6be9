#include "algorithms/rendering/model_rendering.h"

#include <cmath>
#include <map>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "algorithms/rendering/camera_rays.h"
#include "algorithms/rendering/fixed_lights.h"
#include "algorithms/rendering/srgb_curve.h"
#include "algorithms/rendering/texture_sampling.h"

namespace lodestone {
namespace {

ComponentMesh meshOf(std::vector<Vec3> vertices, std::vector<ComponentMesh::Triangle> triangles) {
  ComponentMesh mesh;
  mesh.objects.push_back({"model", 0, ""});
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  mesh.surfaces.resize(mesh.triangles.size());
  mesh.components.push_back({0, 0, mesh.vertexCount(), 0, mesh.triangleCount()});
  return mesh;
}

/// Triangles anywhere in a cube, a third of them twice, so that some lie in one place.
ComponentMesh randomSoup(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  std::vector<Vec3> vertices;
  std::vector<ComponentMesh::Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const Vec3 middle(place(random), place(random), place(random));
    for (int k = 0; k < 3; ++k)
      vertices.emplace_back(middle + 0.4 * Vec3(place(random), place(random), place(random)));
    triangles.push_back({first, first + 1, first + 2});
    if (i % 3 == 0) triangles.push_back({first + 1, first + 2, first});
  }
  return meshOf(std::move(vertices), std::move(triangles));
}

Camera cameraAt(const Vec3& eye, int width = 96, int height = 64) {
  return {.eye = eye, .target = Vec3::Zero(), .fov = 45, .width = width, .height = height};
}

/// Distance along a ray at which it meets a triangle; negative: it does not.
double meets(const ComponentMesh& mesh, std::size_t t, const Ray& ray) {
  const Vec3 origin = ray.origin.cast<double>();
  const Vec3 along = ray.direction.cast<double>();
  const Vec3 a = mesh.vertices[mesh.triangles[t][0]];
  const Vec3 ab = mesh.vertices[mesh.triangles[t][1]] - a;
  const Vec3 ac = mesh.vertices[mesh.triangles[t][2]] - a;
  const Vec3 normal = ab.cross(ac);
  const double facing = normal.dot(along);
  if (facing == 0) return -1;
  const double distance = normal.dot(a - origin) / facing;
  const Vec3 at = origin + distance * along - a;
  const double u = at.cross(ac).dot(normal) / normal.squaredNorm();
  const double v = ab.cross(at).dot(normal) / normal.squaredNorm();
  return distance >= 0 && u >= 0 && v >= 0 && u + v <= 1 ? distance : -1;
}

/// Of all triangles in turn the nearest; of those within a hair of it the last.
std::uint32_t nearestInTurn(const ComponentMesh& mesh, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double distance = meets(mesh, t, ray);
    if (distance >= 0) nearest = std::min(nearest, distance);
  }
  std::uint32_t found = kNoTriangle;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double distance = meets(mesh, t, ray);
    if (distance >= 0 && distance <= nearest * (1 + 1e-5)) found = static_cast<std::uint32_t>(t);
  }
  return found;
}

TEST(ModelRendering, SeesTheNearestTriangleAndOfSeveralInOnePlaceTheLast) {
  const ComponentMesh mesh = randomSoup(60, 7);
  const Camera camera = cameraAt({3, -2, 1.5});
  const ModelPicture picture = ModelRenderer(mesh, nullptr).render(camera);
  const CameraRays rays(camera, Vec3::Zero());
  int differ = 0;
  int shown = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      std::map<std::uint32_t, int> counts;
      for (std::size_t i = 0; i < CameraRays::kSamples; ++i)
        ++counts[nearestInTurn(mesh, rays.through(x, y, i))];
      const std::uint32_t seen = picture.triangle[static_cast<std::size_t>(y * camera.width + x)];
      const auto most = std::max_element(counts.begin(), counts.end(),
                                         [](auto& a, auto& b) { return a.second < b.second; });
      shown += seen != kNoTriangle ? 1 : 0;
      differ += counts[seen] < most->second ? 1 : 0;
    }
  }
  EXPECT_GT(shown, 500);
  EXPECT_LE(differ, 6) << "rays that graze an edge may fall either way in floats";
}

TEST(ModelRendering, IsTheSameForAnyNumberOfThreads) {
  const ComponentMesh mesh = randomSoup(3000, 11);
  const Camera camera = cameraAt({2.5, 2.5, 1}, 200, 150);
  const auto render = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    ModelPicture picture;
    tbb::task_arena(threads).execute([&] { picture = ModelRenderer(mesh, nullptr).render(camera); });
    return picture;
  };
  const ModelPicture one = render(1);
  for (const int threads : {2, 5}) {
    const ModelPicture other = render(threads);
    EXPECT_EQ(one.picture.rgba, other.picture.rgba);
    EXPECT_EQ(one.triangle, other.triangle);
    EXPECT_EQ(one.grey.pixels, other.grey.pixels);
  }
}

TEST(ModelRendering, LightsAFaceByLambertOnTheSideThatIsSeen) {
  const ComponentMesh mesh = meshOf({{-9, 0, -9}, {9, 0, -9}, {0, 0, 12}}, {{0, 1, 2}});
  const FixedLights lights;
  for (const double side : {-1.0, 1.0}) {
    const ModelPicture picture = ModelRenderer(mesh, nullptr).render(cameraAt({0, 5 * side, 0}, 8, 8));
    const double linear = toLinear(0.8F) * lights.brightness({0, side, 0});
    EXPECT_NEAR(picture.grey.pixels[36], 255 * toSrgb(static_cast<float>(linear)), 0.05);
    EXPECT_EQ(picture.triangle[36], 0U);
  }
}

TEST(ModelRendering, IsTheSameWhereverTheModelStands) {
  ComponentMesh mesh = randomSoup(200, 5);
  Camera camera = cameraAt({3, 1, 1});
  const ModelPicture here = ModelRenderer(mesh, nullptr).render(camera);
  const Vec3 far(1 << 19, -(1 << 20), 512);  // whole numbers: nothing is lost by moving
  for (Vec3& p : mesh.vertices) p = Vec3((p.array() * 1024).round() / 1024);
  const ModelPicture rounded = ModelRenderer(mesh, nullptr).render(camera);
  for (Vec3& p : mesh.vertices) p += far;
  camera.eye += far;
  camera.target += far;
  const ModelPicture there = ModelRenderer(mesh, nullptr).render(camera);
  EXPECT_EQ(rounded.triangle, there.triangle);
  EXPECT_NE(here.triangle, std::vector<std::uint32_t>(here.triangle.size(), kNoTriangle));
}

TEST(ModelRendering, ShowsNothingOfAnEmptyModel) {
  const ModelPicture picture = ModelRenderer(ComponentMesh{}, nullptr).render(cameraAt({1, 1, 1}, 5, 3));
  EXPECT_EQ(picture.triangle, std::vector<std::uint32_t>(15, kNoTriangle));
  EXPECT_NEAR(picture.grey.pixels[7], 127.5, 0.1);
}

TEST(ModelRendering, LooksOutFromInside) {
  const ComponentMesh box = meshOf({{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}},
                                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  Camera camera = cameraAt({-0.2, -0.2, -0.2}, 16, 16);
  camera.target = Vec3(1, 2, 0);
  const ModelPicture picture = ModelRenderer(box, nullptr).render(camera);
  EXPECT_EQ(std::count(picture.triangle.begin(), picture.triangle.end(), kNoTriangle), 0);
}

/// From points of both sides of each triangle to each eye, past every other triangle in turn.
TEST(ModelRendering, FindsWhatIsInSightFromAnEye) {
  const ComponentMesh mesh = randomSoup(300, 21);
  const std::vector<Vec3> eyes{{3, 1, 0.5}, {-2, 2, 2}, {0.1, 0.1, 0.1}};
  const std::vector<bool> all(mesh.triangles.size(), true);
  const std::vector<bool> visible = ModelRenderer(mesh, nullptr).visibleFrom(eyes, all);
  const double skip = 2e-5 * bounds(mesh).size().norm();
  std::size_t differ = 0;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::array<Vec3, 3> corners{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    std::vector<Vec3> points{middle};
    for (const Vec3& corner : corners) points.emplace_back(middle + 0.85 * (corner - middle));
    const Vec3 normal = areaNormal(mesh, t).normalized();
    bool found = false;
    for (const Vec3& point : points) {
      for (const Vec3& eye : eyes) {
        const Vec3 from = point + skip * (normal.dot(eye - point) < 0 ? -1 : 1) * normal;
        const Ray ray{from.cast<float>(), (eye - from).cast<float>()};
        bool blocked = false;
        for (std::size_t other = 0; other < mesh.triangles.size() && !blocked; ++other) {
          const double distance = meets(mesh, other, ray);
          blocked = distance >= 0 && distance <= 1;
        }
        found = found || !blocked;
      }
    }
    differ += found != visible[t] ? 1 : 0;
  }
  const auto count = static_cast<std::size_t>(std::count(visible.begin(), visible.end(), true));
  EXPECT_GT(count, 50U);
  EXPECT_LT(count, visible.size());
  EXPECT_LE(differ, 2U) << "rays that graze an edge may fall either way in floats";
}

TEST(ModelRendering, LooksOnlyForWhatIsAskedFor) {
  const ComponentMesh mesh = meshOf({{-9, 0, -9}, {9, 0, -9}, {0, 0, 12}}, {{0, 1, 2}});
  const ModelRenderer renderer(mesh, nullptr);
  EXPECT_TRUE(renderer.visibleFrom({{0, 5, 0}}, {true})[0]);
  EXPECT_FALSE(renderer.visibleFrom({{0, 5, 0}}, {false})[0]);
  EXPECT_FALSE(renderer.visibleFrom({}, {true})[0]);
}

TEST(ModelRendering, StopsWhenAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  const ModelRenderer renderer(randomSoup(10, 1), nullptr);
  EXPECT_THROW((void)renderer.render(cameraAt({2, 2, 2}), Progress({}, stop.get_token())), Cancelled);
}

/// A picture of two halves, the lower red, the upper green.
TexturePyramid twoHalves(int size, TextureWrap wrap) {
  TexturePyramid::Level level{size, size, {}};
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const bool low = row < size / 2;
      for (const int value : {low ? 255 : 0, low ? 0 : 255, 0, 255})
        level.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return makePyramid(std::move(level), wrap);
}

TEST(ModelRendering, DrawsTexturesByTheirCoordinates) {
  ComponentMesh mesh = meshOf({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  for (SurfaceInfo& surface : mesh.surfaces) surface.texture = 0;
  mesh.textureCoordinates = {{Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1)},
                             {Vec2f(0, 0), Vec2f(1, 1), Vec2f(0, 1)}};
  auto look = std::make_shared<ModelLook>();
  look->textures.push_back(std::make_shared<const TexturePyramid>(twoHalves(64, TextureWrap::Repeat)));
  const ModelPicture picture = ModelRenderer(mesh, look).render(cameraAt({0, -3, 0}, 40, 40));
  const auto channel = [&](int x, int y, int c) {
    return picture.picture.rgba[static_cast<std::size_t>(4 * (y * 40 + x) + c)];
  };
  EXPECT_GT(channel(20, 25, 0), 100);  // below the middle: the lower half of the image
  EXPECT_EQ(channel(20, 25, 1), 0);
  EXPECT_GT(channel(20, 15, 1), 100);
  EXPECT_EQ(channel(20, 15, 0), 0);
  // The same surfaces without the image are grey, not black.
  const ModelPicture plain = ModelRenderer(mesh, nullptr).render(cameraAt({0, -3, 0}, 40, 40));
  EXPECT_EQ(plain.triangle, picture.triangle);
  EXPECT_GT(plain.grey.pixels[15 * 40 + 20], 100);
}

TEST(ModelRendering, TakesTheMeanOfATextureFromAfar) {
  ComponentMesh mesh = meshOf({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  for (SurfaceInfo& surface : mesh.surfaces) surface.texture = 0;
  const float times = 200;  // the image lies on the square that many times each way
  mesh.textureCoordinates = {{Vec2f(0, 0), Vec2f(times, 0), Vec2f(times, times)},
                             {Vec2f(0, 0), Vec2f(times, times), Vec2f(0, times)}};
  auto look = std::make_shared<ModelLook>();
  look->textures.push_back(std::make_shared<const TexturePyramid>(twoHalves(64, TextureWrap::Repeat)));
  const ModelPicture picture = ModelRenderer(mesh, look).render(cameraAt({0, -3, 0}, 40, 40));
  std::vector<float> greys;
  for (int y = 12; y < 28; ++y)
    for (int x = 12; x < 28; ++x) greys.push_back(picture.grey.pixels[static_cast<std::size_t>(y * 40 + x)]);
  const auto [low, high] = std::minmax_element(greys.begin(), greys.end());
  EXPECT_LT(*high - *low, 3) << "no moiré";
  const double half = 0.5 * (0.2126 + 0.7152) * FixedLights().brightness({0, -1, 0});
  EXPECT_NEAR(*low, 255 * toSrgb(static_cast<float>(half)), 3);
}

TEST(FixedLights, AreAboveZeroAndAtMostOneForAnyNormal) {
  const FixedLights lights;
  std::mt19937 random(2);
  std::normal_distribution<double> part;
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 normal = Vec3(part(random), part(random), part(random)).normalized();
    EXPECT_GE(lights.brightness(normal), lights.ambient);
    EXPECT_LE(lights.brightness(normal), 1);
  }
}

TEST(SrgbCurve, AgreesWithTheStandardsPowers) {
  for (float linear = 0; linear <= 1; linear += 0.00037F)
    EXPECT_NEAR(encodeSrgb(linear), toSrgb(linear), 2e-4);
  EXPECT_EQ(encodeSrgb(-1), 0);
  EXPECT_EQ(encodeSrgb(2), toSrgb(1));
  EXPECT_EQ(encodeSrgb(std::nanf("")), 0);
}

TEST(TexturePyramid, HalvesOddSizesWithoutLosingAnything) {
  TexturePyramid::Level level{5, 3, {}};
  for (int i = 0; i < 15; ++i)
    for (const int value : {i == 0 ? 255 : 0, 0, 0, 255})
      level.rgba.push_back(static_cast<std::uint8_t>(value));
  const TexturePyramid pyramid = makePyramid(std::move(level), TextureWrap::Clamp);
  ASSERT_EQ(pyramid.levels.size(), 3U);
  EXPECT_EQ(pyramid.levels[1].width, 2);
  EXPECT_EQ(pyramid.levels[1].height, 1);
  EXPECT_EQ(pyramid.levels[2].width, 1);
  EXPECT_GT(pyramid.levels[2].rgba[0], 0) << "the one red texel is still felt";
}

TEST(TextureMap, KnowsCoordinatesThatCannotBeSampled) {
  const TexturePyramid image = twoHalves(16, TextureWrap::Repeat);
  const std::array<Vec3f, 3> corners{Vec3f(0, 0, 0), Vec3f(1e-3F, 0, 0), Vec3f(0, 1e-3F, 0)};
  EXPECT_TRUE(TextureMap(image, corners, {Vec2f(0, 0), Vec2f(9, 0), Vec2f(0, 9)}).isFinite());
  EXPECT_FALSE(TextureMap(image, corners, {Vec2f(0, 0), Vec2f(1e36F, 0), Vec2f(0, 1e36F)}).isFinite());
  EXPECT_FALSE(TextureMap(image, corners, {Vec2f(1e12F, 0), Vec2f(1e12F, 1), Vec2f(1e12F, 2)}).isFinite());
}

TEST(ModelRendering, DrawsTheMaterialWhereTextureCoordinatesMakeNoSense) {
  ComponentMesh mesh = meshOf({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}}, {{0, 1, 2}});
  const ModelPicture plain = ModelRenderer(mesh, nullptr).render(cameraAt({0, -3, 0}, 20, 20));
  mesh.surfaces[0].texture = 0;
  mesh.textureCoordinates = {{Vec2f(0, 0), Vec2f(1e37F, 0), Vec2f(1e37F, 1e37F)}};
  auto look = std::make_shared<ModelLook>();
  look->textures.push_back(std::make_shared<const TexturePyramid>(twoHalves(64, TextureWrap::Repeat)));
  EXPECT_EQ(ModelRenderer(mesh, look).render(cameraAt({0, -3, 0}, 20, 20)).grey.pixels, plain.grey.pixels);
}

TEST(TextureMap, RepeatsMirrorsOrHoldsTheBorder) {
  const std::array<Vec3f, 3> corners{Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
  const std::array<Vec2f, 3> coordinates{Vec2f(0, 0), Vec2f(1, 0), Vec2f(0, 1)};
  const auto isUpper = [&](TextureWrap wrap, float y) {
    const TexturePyramid image = twoHalves(16, wrap);
    const Vec3f colour = TextureMap(image, corners, coordinates).sample({0.5F, y, 0}, 0);
    EXPECT_GT(std::max(colour.x(), colour.y()), 0.9F);
    return colour.y() > colour.x();
  };
  for (int quarter = -15; quarter < 16; quarter += 2) {
    const float y = static_cast<float>(quarter) / 4 + 0.02F;
    const bool upperHalf = (quarter + 16) / 2 % 2 == 1;  // of the image as it is repeated
    const bool backward = (quarter + 16) / 4 % 2 == 1;
    EXPECT_EQ(isUpper(TextureWrap::Repeat, y), upperHalf) << y;
    EXPECT_EQ(isUpper(TextureWrap::Mirror, y), upperHalf != backward) << y;
    EXPECT_EQ(isUpper(TextureWrap::Clamp, y), y > 0.5F) << y;
  }
}

}  // namespace
}  // namespace lodestone
