// The eye's filter and the classes of detail on pictures of real buildings; skipped where the data is absent.
#include <cmath>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>

#include "algorithms/geometry/components.h"
#include "algorithms/perception/difference_classes.h"
#include "algorithms/perception/hvs_filter.h"
#include "algorithms/rendering/model_rendering.h"
#include "model/io/read_city.h"
#include "tests/support/plain_classes.h"
#include "tests/support/plain_filter.h"
#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

/// From the south-west and above.
ModelPicture pictureOf(const std::filesystem::path& file) {
  const Result<CityModel> city = readCity({file});
  if (!city.ok()) throw std::runtime_error(file.string());
  std::vector<std::uint32_t> buildings(city->buildings.size());
  std::iota(buildings.begin(), buildings.end(), 0U);
  const ComponentMesh mesh = makeComponentMesh(*city, buildings);
  const ModelRenderer renderer(mesh, nullptr);
  return renderer.render(fitCamera(bounds(mesh), Vec3(1, 1, -0.7), 45, 300, 211));
}

class RealPictures : public testing::TestWithParam<const char*> {};

TEST_P(RealPictures, AreFilteredAndClassifiedAsTheSlowWayDoes) {
  const auto file = test::sharedData(GetParam());
  if (file.empty()) GTEST_SKIP() << "shared data not present";
  const ModelPicture picture = pictureOf(file);
  for (const double distance : {0.6, 5.0}) {
    PerceiveOptions options;
    options.distance = distance;
    const GreyImage seen = filterAsSeen(picture.grey, options);
    const std::vector<double> expected = plainlyFiltered(picture.grey, options);
    DifferenceHistogram histogram{};
    for (std::size_t place = 0; place < expected.size(); ++place) {
      ASSERT_NEAR(seen.pixels[place], expected[place], 1e-3);
      if (picture.triangle[place] == kNoTriangle) continue;
      const float difference = std::abs(picture.grey.pixels[place] - seen.pixels[place]);
      ++histogram[static_cast<std::size_t>(differenceBin(difference))];
    }
    const auto pixels =
        static_cast<double>(std::accumulate(histogram.begin(), histogram.end(), std::uint64_t{0}));
    ASSERT_GT(pixels, 1000);
    const DifferenceClasses classes = classifyDifferences(histogram, options);
    const std::vector<std::size_t> sizes = PlainClasses(histogram).run();
    for (std::size_t k = 0; k < kDetailClasses; ++k)
      EXPECT_NEAR(classes.gaussians[k].prior * pixels, static_cast<double>(sizes[k]), 1e-6) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Buildings, RealPictures,
                         testing::Values("D_meshes/gazebo_buildings/school/meshes/school.dae",
                                         "A_citygml/ingolstadt_lod3/4018115/4018115.xml"));

}  // namespace
}  // namespace lodestone
