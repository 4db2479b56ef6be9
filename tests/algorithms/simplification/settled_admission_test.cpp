#include "algorithms/simplification/settled_admission.h"

#include <gtest/gtest.h>

#include "algorithms/perception/perceiving.h"
#include "algorithms/perception/viewpoints.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/simplification.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// A bumpy block half sunk into a wall with a window's depth between its hidden end and the wall's far side.
ComponentMesh sunkBlock() {
  return meshOfParts({boxFaces({0, 0, 0}, {10, 1, 6}), bumpyBlock(8, {4, -2, 2}, Vec3(2, 2.9, 2), 5)});
}

Perception look(const ComponentMesh& mesh) {
  PerceiveOptions options;
  options.views = 12;
  options.size = 200;
  const Box3 box = bounds(mesh);
  return perceive(ModelRenderer(mesh, nullptr), viewpointsAround(box, options), options, {}, {},
                  closerViewpoints(box, options));
}

std::size_t broughtToLight(const ComponentMesh& mesh, const Perception& perception, const Simplified& level) {
  std::vector<bool> hidden;
  for (const std::uint32_t t : level.triangle) hidden.push_back(!perception.isSeen(t));
  const auto visible = ModelRenderer(level.mesh, nullptr)
                           .visibleFrom(closerViewpoints(bounds(mesh), perception.options), hidden);
  return static_cast<std::size_t>(std::count(visible.begin(), visible.end(), true));
}

TEST(SettledAdmission, KeepsHiddenWhatIsHidden) {
  const ComponentMesh mesh = sunkBlock();
  const Perception perception = look(mesh);
  const Classification classes = classify(mesh);
  for (const SimplifyMethod method : {SimplifyMethod::Perception, SimplifyMethod::Combined}) {
    const SimplifyOptions options{.method = method, .rate = 1, .stage = 1, .unseen = true};
    const Admission settled = settledAdmission(mesh, classes, perception, options);
    const Simplified level = simplify(mesh, classes, options, {}, settled);
    EXPECT_EQ(broughtToLight(mesh, perception, level), 0U);
    EXPECT_LT(level.mesh.triangleCount(), mesh.triangleCount() - 50) << "the hidden end is simplified still";
  }
}

TEST(SettledAdmission, IsThatOfTheStageWithoutTheUnseen) {
  const ComponentMesh mesh = sunkBlock();
  const Perception perception = look(mesh);
  const SimplifyOptions options{.method = SimplifyMethod::Perception, .rate = 1, .stage = 3};
  EXPECT_EQ(settledAdmission(mesh, classify(mesh), perception, options).triangles,
            admissionOf(mesh, perception, options).triangles);
}

TEST(SettledAdmission, NamesWhatIsLeftByTheTrianglesOfTheOriginal) {
  const ComponentMesh mesh = sunkBlock();
  const Perception perception = look(mesh);
  const SimplifyOptions options{.method = SimplifyMethod::Perception, .rate = 1, .stage = 1, .unseen = true};
  const Simplified level = simplify(mesh, {}, options, {}, admissionOf(mesh, perception, options));
  ASSERT_EQ(level.triangle.size(), level.mesh.triangles.size());
  for (std::size_t t = 0; t < level.triangle.size(); ++t) {
    if (!perception.isSeen(level.triangle[t])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      if (perception.classes[level.triangle[t]] == DetailClass::Dramatic) continue;
      EXPECT_EQ(level.mesh.vertices[level.mesh.triangles[t][i]],
                mesh.vertices[mesh.triangles[level.triangle[t]][i]]);
    }
  }
}

}  // namespace
}  // namespace lodestone
