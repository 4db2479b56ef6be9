#include "algorithms/simplification/settled_admission.h"

#include <gtest/gtest.h>

#include "algorithms/perception/perceiving.h"
#include "algorithms/perception/viewpoints.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/contacts.h"
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

/// Seen everywhere, and nothing of it matters.
Perception everythingSlight(const ComponentMesh& mesh) {
  Perception perception;
  perception.pixels.assign(mesh.triangleCount(), 1);
  perception.classes.assign(mesh.triangleCount(), DetailClass::Slight);
  return perception;
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

/// Bumpy blocks in a row, each leaning on the next, and everything of them may go.
TEST(SettledAdmission, KeepsTogetherWhatTouchesInCombined) {
  const ComponentMesh mesh =
      meshOfParts({bumpyBlock(6, {0, 0, 0}, {3, 3, 3}, 1), bumpyBlock(6, {3, 0.5, 0}, {3, 2, 4}, 2),
                   bumpyBlock(6, {6, 0, 0.5}, {2, 3, 2}, 3), bumpyBlock(6, {2, 2.9, 0.2}, {5, 2, 2}, 4)});
  const Classification classes = classify(mesh);
  ASSERT_GE(classes.contacts.size(), 3U);
  const Perception perception = everythingSlight(mesh);
  const auto separated = [&](const Admission& admission, const SimplifyOptions& options) {
    const Simplified level = simplify(mesh, classes, options, {}, admission);
    EXPECT_LT(level.mesh.triangleCount(), mesh.triangleCount() * 3 / 5);
    const auto contacts = followContacts(mesh, classes, level);
    return std::count_if(contacts.begin(), contacts.end(),
                         [](const ContactReport& contact) { return contact.fate != ContactFate::Kept; });
  };
  const SimplifyOptions options{.method = SimplifyMethod::Combined, .rate = 1, .stage = 3};
  EXPECT_GT(separated(admissionOf(mesh, perception, options), options), 0) << "or there is nothing to keep";
  EXPECT_EQ(separated(settledAdmission(mesh, classes, perception, options), options), 0);
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
