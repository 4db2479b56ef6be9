#include "algorithms/simplification/settled_simplification.h"

#include <gtest/gtest.h>

#include "algorithms/perception/perceiving.h"
#include "algorithms/perception/viewpoints.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/contacts.h"
#include "algorithms/simplification/measured_simplification.h"
#include "algorithms/simplification/simplification.h"
#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// A bumpy block half sunk into a wall with a window's depth between its hidden end and the wall's far side.
ComponentMesh sunkBlock() {
  return meshOfParts({boxFaces({0, 0, 0}, {10, 1, 6}), bumpyBlock(8, {4, -2, 2}, Vec3(2, 2.9, 2), 5)});
}

/// Bumpy blocks in a row, each leaning on the next, and everything of them may go.
ComponentMesh leaningBlocks() {
  return meshOfParts({bumpyBlock(6, {0, 0, 0}, {3, 3, 3}, 1), bumpyBlock(6, {3, 0.5, 0}, {3, 2, 4}, 2),
                      bumpyBlock(6, {6, 0, 0.5}, {2, 3, 2}, 3), bumpyBlock(6, {2, 2.9, 0.2}, {5, 2, 2}, 4)});
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

TEST(Settled, KeepsHiddenWhatIsHidden) {
  const ComponentMesh mesh = sunkBlock();
  const Perception perception = look(mesh);
  const Classification classes = classify(mesh);
  for (const SimplifyMethod method : {SimplifyMethod::Perception, SimplifyMethod::Combined}) {
    const SimplifyOptions options{.method = method, .rate = 1, .stage = 1, .unseen = true};
    const Simplified level = simplifySettled(mesh, classes, perception, options).simplified;
    EXPECT_EQ(broughtToLight(mesh, perception, level), 0U);
    EXPECT_LT(level.mesh.triangleCount(), mesh.triangleCount() - 50) << "the hidden end is simplified still";
  }
}

TEST(Settled, IsThatOfTheStageWithoutTheUnseen) {
  const ComponentMesh mesh = sunkBlock();
  const Perception perception = look(mesh);
  const SimplifyOptions options{.method = SimplifyMethod::Perception, .rate = 1, .stage = 3};
  EXPECT_EQ(simplifySettled(mesh, classify(mesh), perception, options).admission.triangles,
            admissionOf(mesh, perception, options).triangles);
}

TEST(Settled, KeepsTogetherWhatTouchesInCombined) {
  const ComponentMesh mesh = leaningBlocks();
  const Classification classes = classify(mesh);
  ASSERT_GE(classes.contacts.size(), 3U);
  const Perception perception = everythingSlight(mesh);
  const auto separated = [&](const Simplified& level) {
    const auto contacts = followContacts(mesh, classes, level);
    return std::count_if(contacts.begin(), contacts.end(),
                         [](const ContactReport& contact) { return contact.fate != ContactFate::Kept; });
  };
  const SimplifyOptions options{.method = SimplifyMethod::Combined, .rate = 1, .stage = 3};
  EXPECT_GT(separated(simplify(mesh, classes, options, {}, admissionOf(mesh, perception, options))), 0)
      << "or there is nothing to keep";
  const Settled settled = simplifySettled(mesh, classes, perception, options);
  EXPECT_EQ(separated(settled.simplified), 0);
  EXPECT_LT(settled.simplified.mesh.triangleCount(), mesh.triangleCount() * 3 / 5);
  // It is what it says that it was made with.
  EXPECT_EQ(simplify(mesh, classes, options, {}, settled.admission).mesh.triangles,
            settled.simplified.mesh.triangles);
}

TEST(Settled, HoldsWhateverAIsTaken) {
  const ComponentMesh mesh = leaningBlocks();
  const Classification classes = classify(mesh);
  const Perception perception = everythingSlight(mesh);
  const SimplifyOptions options{.method = SimplifyMethod::Combined, .rate = 1, .aAuto = true, .stage = 3};
  const Measured best = simplifyAndMeasure(mesh, classes, options, {}, &perception);
  ASSERT_GT(best.trials.size(), 1U);
  for (const AutoTrial& trial : best.trials) EXPECT_EQ(trial.separated, 0U) << trial.a;
  SimplifyOptions alone = options;
  alone.aAuto = false;
  alone.a = best.a;
  EXPECT_EQ(simplifySettled(mesh, classes, perception, alone).simplified.mesh.triangles,
            best.simplified.mesh.triangles);
}

TEST(Settled, HoldsEvenWhenItGivesUpTrying) {
  for (const int rounds : {0, 1}) {
    const ComponentMesh blocks = leaningBlocks();
    const Classification classes = classify(blocks);
    const Simplified together =
        simplifySettled(blocks, classes, everythingSlight(blocks),
                        {.method = SimplifyMethod::Combined, .rate = 1, .stage = 3}, {}, rounds)
            .simplified;
    for (const ContactReport& contact : followContacts(blocks, classes, together))
      EXPECT_EQ(contact.fate, ContactFate::Kept);
    const ComponentMesh sunk = sunkBlock();
    const Perception perception = look(sunk);
    const SimplifyOptions options{
        .method = SimplifyMethod::Perception, .rate = 1, .stage = 1, .unseen = true};
    EXPECT_EQ(broughtToLight(sunk, perception,
                             simplifySettled(sunk, {}, perception, options, {}, rounds).simplified),
              0U);
  }
}

TEST(Settled, NamesWhatIsLeftByTheTrianglesOfTheOriginal) {
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
