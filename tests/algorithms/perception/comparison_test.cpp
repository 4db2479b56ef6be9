#include "algorithms/perception/comparison.h"

#include <algorithm>
#include <stop_token>

#include <gtest/gtest.h>

#include "algorithms/perception/viewpoints.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// Two boxes wall to wall, the second of which is `depth` deep.
ComponentMesh twoBoxes(double depth) {
  return meshOfParts({boxFaces({0, 0, 0}, {10, 8, 6}), boxFaces({10, 0, 0}, {10 + depth, 8, 4})});
}

std::vector<Camera> around(const ComponentMesh& mesh) {
  PerceiveOptions options;
  options.views = 3;
  options.size = 40;
  return viewpointsAround(bounds(mesh), options);
}

TEST(Comparison, AddsUpWhatEachViewShows) {
  const ComponentMesh before = twoBoxes(5);
  const ComponentMesh after = twoBoxes(4);
  const std::vector<Camera> cameras = around(before);
  const ModelRenderer a(before, nullptr);
  const ModelRenderer b(after, nullptr);
  std::vector<std::size_t> views;
  const ModelComparison comparison =
      compareModels(a, b, cameras, 40, {}, [&](std::size_t view, ComparedView&& pictures) {
        views.push_back(view);
        EXPECT_EQ(pictures.first.rgba, a.render(cameras[view]).picture.rgba);
        EXPECT_EQ(pictures.second.rgba, b.render(cameras[view]).picture.rgba);
      });
  EXPECT_EQ(views, (std::vector<std::size_t>{0, 1, 2}));
  double errors = 0;
  double shownErrors = 0;
  double shown = 0;
  double different = 0;
  for (std::size_t view = 0; view < cameras.size(); ++view) {
    const ModelPicture pa = a.render(cameras[view]);
    const ModelPicture pb = b.render(cameras[view]);
    const FlipMap map = flip(pa.picture, pb.picture, 40);
    EXPECT_DOUBLE_EQ(comparison.views[view].flip, map.mean);
    for (std::size_t i = 0; i < map.errors.size(); ++i) {
      errors += static_cast<double>(map.errors[i]);
      different +=
          std::equal(&pa.picture.rgba[4 * i], &pa.picture.rgba[4 * i] + 4, &pb.picture.rgba[4 * i]) ? 0 : 1;
      if (pa.triangle[i] == kNoTriangle && pb.triangle[i] == kNoTriangle) continue;
      ++shown;
      shownErrors += static_cast<double>(map.errors[i]);
    }
  }
  const double pixels = 3 * 40 * 40;
  EXPECT_GT(different, 0);
  EXPECT_NEAR(comparison.all.flip, errors / pixels, 1e-9);
  EXPECT_NEAR(comparison.all.flipShown, shownErrors / shown, 1e-9);
  EXPECT_NEAR(comparison.all.pixelError, different / pixels, 1e-9);
  EXPECT_NEAR(comparison.all.shown, shown / pixels, 1e-9);
}

TEST(Comparison, OfAModelWithItselfIsNothing) {
  const ComponentMesh mesh = twoBoxes(5);
  const ModelRenderer renderer(mesh, nullptr);
  const ModelComparison comparison = compareModels(renderer, renderer, around(mesh), 40);
  EXPECT_EQ(comparison.all.flip, 0);
  EXPECT_EQ(comparison.all.pixelError, 0);
  EXPECT_GT(comparison.all.shown, 0.02);
  EXPECT_EQ(compareModels(renderer, renderer, {}, 40).all.shown, 0);
}

TEST(Comparison, StopsWhenAsked) {
  const ComponentMesh mesh = twoBoxes(5);
  const ModelRenderer renderer(mesh, nullptr);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW((void)compareModels(renderer, renderer, around(mesh), 40, Progress({}, source.get_token())),
               Cancelled);
}

}  // namespace
}  // namespace lodestone
