#include "algorithms/perception/perceiving.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "algorithms/perception/difference_classes.h"
#include "algorithms/perception/hvs_filter.h"
#include "algorithms/perception/viewpoints.h"
#include "model/detail_colours.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// A box stands hidden inside.
ComponentMesh bumpyHouse() {
  return meshOfParts({bumpyBlock(10, {0, 0, 0}, Vec3(8, 6, 5), 3), boxFaces({2, 2, 1}, {3, 3, 2})});
}

PerceiveOptions small(int views = 6, int size = 120) {
  PerceiveOptions options;
  options.views = views;
  options.size = size;
  return options;
}

Perception look(const ComponentMesh& mesh, const PerceiveOptions& options, const ViewSink& sink = {}) {
  return perceive(ModelRenderer(mesh, nullptr), viewpointsAround(bounds(mesh), options), options, {}, sink);
}

/// Everything once more, pixel by pixel and in the order of the views.
TEST(Perceiving, CountsWhatEveryPixelOfEveryViewShows) {
  const ComponentMesh mesh = bumpyHouse();
  const PerceiveOptions options = small();
  const Perception perception = look(mesh, options);
  const ModelRenderer renderer(mesh, nullptr);
  std::vector<std::vector<float>> differences(mesh.triangles.size());
  DifferenceHistogram histogram{};
  for (const Camera& camera : perception.cameras) {
    const ModelPicture picture = renderer.render(camera);
    const GreyImage filtered = filterAsSeen(picture.grey, options);
    for (std::size_t place = 0; place < picture.triangle.size(); ++place) {
      if (picture.triangle[place] == kNoTriangle) continue;
      const float difference = std::abs(picture.grey.pixels[place] - filtered.pixels[place]);
      differences[picture.triangle[place]].push_back(difference);
      ++histogram[static_cast<std::size_t>(differenceBin(difference))];
    }
  }
  EXPECT_EQ(perception.histogram, histogram);
  std::size_t unseen = 0;
  for (std::size_t t = 0; t < differences.size(); ++t) {
    EXPECT_EQ(perception.pixels[t], differences[t].size());
    EXPECT_EQ(perception.isSeen(t), !differences[t].empty());
    unseen += differences[t].empty() ? 1 : 0;
    std::array<int, kDetailClasses> counts{};
    for (const float difference : differences[t])
      ++counts[static_cast<std::size_t>(perception.differences.of(differenceBin(difference)))];
    for (std::size_t c = 0; c < kDetailClasses; ++c) {
      const auto own = static_cast<std::size_t>(perception.classes[t]);
      EXPECT_GE(counts[own], counts[c]);
      if (c < own && !differences[t].empty()) {
        EXPECT_GT(counts[own], counts[c]) << "a tie: the lower class";
      }
    }
  }
  EXPECT_GE(unseen, 12U) << "the box inside is never seen";
  EXPECT_LT(unseen, differences.size() / 4);
}

TEST(Perceiving, OnlyWhatIsHiddenStaysUnseen) {
  const ComponentMesh mesh = bumpyHouse();
  const PerceiveOptions options = small(2, 24);  // so few and coarse that pictures miss a lot
  const auto cameras = viewpointsAround(bounds(mesh), options);
  const ModelRenderer renderer(mesh, nullptr);
  const auto unseen = [&](const Perception& perception) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) count += perception.isSeen(t) ? 0 : 1;
    return count;
  };
  EXPECT_GT(unseen(perceive(renderer, cameras, options)), 300U);
  const Perception closer =
      perceive(renderer, cameras, options, {}, {}, closerViewpoints(bounds(mesh), options));
  EXPECT_EQ(unseen(closer), 12U) << "the box inside";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (closer.glimpsed[t]) {
      EXPECT_EQ(closer.pixels[t], 0U);
      EXPECT_EQ(closer.classes[t], DetailClass::None);
    }
  }
}

TEST(Perceiving, IsTheSameForAnyNumberOfThreads) {
  const ComponentMesh mesh = bumpyHouse();
  const auto run = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    Perception perception;
    tbb::task_arena(threads).execute([&] { perception = look(mesh, small()); });
    return perception;
  };
  const Perception one = run(1);
  const Perception four = run(4);
  EXPECT_EQ(one.histogram, four.histogram);
  EXPECT_EQ(*one.triangleBins, *four.triangleBins);
  EXPECT_EQ(one.classes, four.classes);
}

TEST(Perceiving, HasAViewInWorkForEachThreadButOneOfLargeOnes) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
  const auto atOnce = [](std::size_t views, int size) {
    std::size_t result = 0;
    tbb::task_arena(3).execute(
        [&] { result = viewsAtOnce(std::vector<Camera>(views, Camera{.width = size, .height = size})); });
    return result;
  };
  EXPECT_EQ(atOnce(26, 1024), 3U);
  EXPECT_EQ(atOnce(2, 1024), 2U);
  EXPECT_EQ(atOnce(26, 4096), 1U);
  EXPECT_EQ(atOnce(0, 64), 0U);
}

TEST(Perceiving, TakesMemoryForTheViewsThatAreInWorkAndForEachModel) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 4);
  const auto bytes = [](std::size_t views, int size, std::size_t triangles, std::size_t models) {
    const std::vector<Camera> cameras(views, Camera{.width = size, .height = size});
    double result = 0;
    tbb::task_arena(3).execute([&] { result = perceivingMemory(cameras, triangles, models); });
    return result;
  };
  constexpr double kSmall = 20.0 * 1000 * 1000;
  constexpr double kLarge = 20.0 * 4096 * 4096;
  EXPECT_EQ(bytes(26, 1000, 10, 1), 3 * kSmall + 10240);
  EXPECT_EQ(bytes(2, 1000, 0, 1), 2 * kSmall);
  EXPECT_EQ(bytes(26, 4096, 0, 1), kLarge);
  EXPECT_EQ(bytes(26, 1000, 10, 2), 3 * kSmall + 20480) << "no more views than threads";
  EXPECT_EQ(bytes(26, 4096, 10, 3), 3 * kLarge + 30720) << "a large one for each model";
  EXPECT_EQ(bytes(0, 64, 0, 1), 0);
}

TEST(Perceiving, TellsOfEachViewOnceWithAllItsPictures) {
  const ComponentMesh mesh = bumpyHouse();
  std::vector<int> told(6);
  const Perception perception = look(mesh, small(), [&](std::size_t view, PerceivedView&& pictures) {
    ++told[view];
    EXPECT_EQ(pictures.rendered.picture.rgba.size(), 120U * 120 * 4);
    EXPECT_EQ(pictures.filtered.pixels.size(), 120U * 120);
    EXPECT_EQ(pictures.difference.bins.size(), 120U * 120);
  });
  EXPECT_EQ(told, std::vector<int>(6, 1));
}

TEST(Perceiving, AnEmptyModelHasNoViewsAndNoClasses) {
  const Perception perception = look(ComponentMesh{}, small());
  EXPECT_TRUE(perception.cameras.empty());
  EXPECT_TRUE(perception.classes.empty());
  for (const Gaussian& gaussian : perception.differences.gaussians) EXPECT_EQ(gaussian.prior, 0);
}

TEST(Perceiving, OneTriangleIsSeenFromBothSides) {
  ComponentMesh mesh;
  mesh.objects.push_back({"one", 0, ""});
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 1, 2}};
  mesh.surfaces.resize(1);
  mesh.components.push_back({0, 0, 3, 0, 1});
  const Perception perception = look(mesh, small());
  EXPECT_GT(perception.pixels[0], 1000U);
  EXPECT_EQ(perception.classes[0], DetailClass::None) << "most of it is one plain colour";
}

TEST(Perceiving, NothingIsSeenByACameraThatLooksAway) {
  const ComponentMesh mesh = bumpyHouse();
  Camera camera{.eye = {0, -50, 2}, .target = {0, -100, 2}, .width = 64, .height = 48};
  const Perception perception = perceive(ModelRenderer(mesh, nullptr), {camera}, small());
  EXPECT_EQ(perception.pixels, std::vector<std::uint32_t>(mesh.triangles.size(), 0));
  EXPECT_EQ(admittedTriangles(perception, 3, false), std::vector<bool>(mesh.triangles.size(), false));
  EXPECT_EQ(admittedTriangles(perception, 1, true), std::vector<bool>(mesh.triangles.size(), true));
}

TEST(Perceiving, FromInsideTheModelItsInnerSideIsSeen) {
  const ComponentMesh mesh = bumpyHouse();
  Camera camera{.eye = {2.5, 2.5, 1.5}, .target = {2.5, 9, 1.5}, .width = 64, .height = 48};
  const Perception perception = perceive(ModelRenderer(mesh, nullptr), {camera}, small());
  EXPECT_EQ(std::accumulate(perception.pixels.begin(), perception.pixels.end(), 0U), 64U * 48U);
}

TEST(Perceiving, FromFartherAwayMoreIsFilteredAway) {
  const ComponentMesh mesh = bumpyHouse();
  PerceiveOptions near = small();
  near.distance = 0.2;
  PerceiveOptions far = small();
  far.distance = 3;
  const auto sum = [](const Perception& perception) {
    double all = 0;
    for (int bin = 0; bin < kDifferenceBins; ++bin)
      all += binBegin(bin) * static_cast<double>(perception.histogram[static_cast<std::size_t>(bin)]);
    return all;
  };
  EXPECT_GT(sum(look(mesh, far)), 3 * sum(look(mesh, near)));
}

TEST(Perceiving, IsJudgedAgainByOtherThresholds) {
  const ComponentMesh mesh = bumpyHouse();
  PerceiveOptions options = small();
  const Perception found = look(mesh, options);
  options.slight = 0.5;
  options.moderate = 1;
  options.dramatic = 2;
  const Perception given = judgedAgain(found, options);
  EXPECT_EQ(given.histogram, found.histogram);
  EXPECT_EQ(given.triangleBins, found.triangleBins) << "shared: there are 100 MB of a large model";
  EXPECT_EQ(given.classes, look(mesh, options).classes);
  EXPECT_EQ(given.differences.cuts[2], differenceBin(2));
}

TEST(Perceiving, PicturesShowClassesInTheirColoursOnWhite) {
  DifferenceImage image{2, 2, {0, 16, 24, 120}, {true, true, true, false}};
  DifferenceClasses classes;
  classes.cuts = {10, 20, 100};
  const Picture picture = classPicture(image, classes);
  const auto red = [](DetailClass c) { return static_cast<int>(255 * detailColour(c)[0] + 0.5F); };
  EXPECT_EQ(picture.rgba[0], red(DetailClass::None));
  EXPECT_EQ(picture.rgba[4], red(DetailClass::Slight));
  EXPECT_EQ(picture.rgba[8], red(DetailClass::Moderate));
  EXPECT_EQ(picture.rgba[12], 255);
  const Picture difference = differencePicture(image, classes);
  EXPECT_EQ(difference.rgba[0], 0);
  EXPECT_GT(difference.rgba[8], difference.rgba[4]);
}

TEST(Perceiving, HandsOverEachViewOnceFromSeveralThreads) {
  constexpr std::size_t kViews = 40;
  std::array<std::atomic<int>, kViews> taken{};
  std::atomic<int> inside{0};
  std::atomic<int> most{0};
  (void)look(bumpyHouse(), small(kViews, 64), [&](std::size_t view, PerceivedView&&) {
    const int now = ++inside;
    for (int before = most; now > before && !most.compare_exchange_weak(before, now);) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ++taken[view];
    --inside;
  });
  for (const auto& count : taken) EXPECT_EQ(count, 1);
  if (tbb::this_task_arena::max_concurrency() > 1) {
    EXPECT_GT(most, 1) << "no view waits for what is done with another";
  }
}

TEST(Perceiving, StopsWhenAskedTo) {
  std::stop_source stop;
  const ComponentMesh mesh = bumpyHouse();
  const PerceiveOptions options = small(200, 64);
  const auto sink = [&](std::size_t, PerceivedView&&) { stop.request_stop(); };
  EXPECT_THROW((void)perceive(ModelRenderer(mesh, nullptr), viewpointsAround(bounds(mesh), options), options,
                              Progress({}, stop.get_token()), sink),
               Cancelled);
}

TEST(LongPerceiving, LargePicturesComeOneAfterTheOther) {
  const ComponentMesh mesh = bumpyHouse();
  std::vector<std::size_t> order;
  const Perception perception = look(mesh, small(5, 2100), [&](std::size_t i, PerceivedView&& view) {
    order.push_back(i);
    EXPECT_EQ(view.difference.bins.size(), 2100U * 2100U);
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_GT(std::accumulate(perception.pixels.begin(), perception.pixels.end(), 0U), 4'000'000U);
}

}  // namespace
}  // namespace lodestone
