#include "model/session.h"

#include <gmock/gmock.h>

namespace lodestone {
namespace {

ProjectState withEpsilon(const Session& session, double epsilon) {
  ProjectState state = session.state();
  state.chainOptions.cut.epsilon = epsilon;
  return state;
}

TEST(Session, UndoAndRedoMoveThroughTheStates) {
  Session session;
  session.commit(withEpsilon(session, 1), "one");
  session.commit(withEpsilon(session, 2), "two");
  EXPECT_EQ(session.undoText(), "two");
  session.undo();
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, 1);
  EXPECT_EQ(session.redoText(), "two");
  session.undo();
  EXPECT_FALSE(session.canUndo());
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, CutOptions{}.epsilon);
  session.redo();
  session.redo();
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, 2);
  EXPECT_FALSE(session.canRedo());
}

TEST(Session, ACommitForgetsWhatWasUndone) {
  Session session;
  session.commit(withEpsilon(session, 1), "one");
  session.undo();
  session.commit(withEpsilon(session, 3), "three");
  EXPECT_FALSE(session.canRedo());
  session.undo();
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, CutOptions{}.epsilon);
}

TEST(Session, ADraggedSliderIsOneStep) {
  Session session;
  for (int i = 1; i <= 10; ++i) session.commit(withEpsilon(session, i), "ε", "epsilon");
  session.undo();
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, CutOptions{}.epsilon);
  EXPECT_FALSE(session.canUndo());
}

TEST(Session, KnowsWhetherItIsSaved) {
  Session session;
  EXPECT_FALSE(session.modified());
  session.commit(withEpsilon(session, 1), "one");
  EXPECT_TRUE(session.modified());
  session.markSaved();
  EXPECT_FALSE(session.modified());
  session.undo();
  EXPECT_TRUE(session.modified());
  session.redo();
  EXPECT_FALSE(session.modified());
  session.undo();
  session.commit(withEpsilon(session, 2), "another way");
  session.commit(withEpsilon(session, 3), "as long as the saved one");
  EXPECT_TRUE(session.modified());
}

TEST(Session, EachProjectHasItsSavedState) {
  Session session;
  session.commit(withEpsilon(session, 1), "one");
  session.markSaved();
  ProjectState other = withEpsilon(session, 2);
  other.project = 7;
  session.commit(other, "open instead", "key");
  EXPECT_TRUE(session.modified());
  session.markSaved();
  EXPECT_FALSE(session.modified());
  session.undo();
  EXPECT_FALSE(session.modified());
  session.undo();
  EXPECT_TRUE(session.modified());
  session.markSaved();
  session.redo();
  EXPECT_TRUE(session.modified());
}

TEST(Session, HistoryIsBoundedAndKeepsTheLatest) {
  Session session;
  for (int i = 1; i <= 1000; ++i) session.commit(withEpsilon(session, i), "step");
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, 1000);
  int steps = 0;
  while (session.canUndo()) {
    session.undo();
    ++steps;
  }
  EXPECT_LT(steps, 1000);
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, 1000 - steps);
}

TEST(Session, ListenersSeeBeforeAndAfter) {
  Session session;
  double before = 0;
  double after = 0;
  session.listen([&](const ProjectState& b, const ProjectState& a) {
    before = b.chainOptions.cut.epsilon;
    after = a.chainOptions.cut.epsilon;
  });
  session.commit(withEpsilon(session, 7), "seven");
  EXPECT_EQ(before, CutOptions{}.epsilon);
  EXPECT_EQ(after, 7);
  session.undo();
  EXPECT_EQ(before, 7);
}

TEST(Session, TheSavedStateStaysAStep) {
  Session session;
  session.commit(withEpsilon(session, 1), "ε", "epsilon");
  session.markSaved();
  session.commit(withEpsilon(session, 2), "ε", "epsilon");
  session.commit(withEpsilon(session, 3), "ε", "epsilon");
  session.undo();
  EXPECT_EQ(session.state().chainOptions.cut.epsilon, 1);
  EXPECT_FALSE(session.modified());
}

ProjectState withTree(const Session& session, const std::string& barrier) {
  auto tree = std::make_shared<ClusterTree>();
  tree->dendrogram = std::make_shared<const Dendrogram>();
  ProjectState state = session.state();
  state.tree = std::move(tree);
  state.treeBarriers = {barrier};
  state.droppedTree.reset();
  return state;
}

TEST(Session, TreesFarFromThePresentAreDroppedForTheirRecipes) {
  Session session;
  std::vector<std::weak_ptr<const ClusterTree>> trees;
  for (int i = 0; i < 50; ++i) {
    session.commit(withTree(session, std::to_string(i)), "cluster");
    trees.push_back(session.state().tree);
    session.commit(withEpsilon(session, i), "ε");
    session.commit(withEpsilon(session, i + 0.5), "ε");
  }
  const auto alive = [&] {
    return std::count_if(trees.begin(), trees.end(), [](const auto& tree) { return !tree.expired(); });
  };
  EXPECT_EQ(static_cast<std::size_t>(alive()), Session::kKeptTrees);
  EXPECT_NE(session.state().tree, nullptr);
  while (session.state().treeBarriers != std::vector<std::string>{"20"}) session.undo();
  EXPECT_EQ(session.state().tree, nullptr);
  ASSERT_TRUE(session.state().droppedTree);
  EXPECT_EQ(session.state().droppedTree->barriers, std::vector<std::string>{"20"});
  // A tree that is made again pushes out the one farthest away.
  const ProjectState again = withTree(session, "20");
  session.giveTree(session.state().city, *session.state().droppedTree, again.tree);
  EXPECT_EQ(session.state().tree, again.tree);
  EXPECT_LE(static_cast<std::size_t>(alive()) + 1, Session::kKeptTrees);
  EXPECT_TRUE(session.canRedo());
  // It is there for every step that had it, and for no other.
  for (int steps = 0; steps < 2; ++steps) {
    session.undo();
    EXPECT_EQ(session.state().tree, again.tree);
    EXPECT_FALSE(session.state().droppedTree);
    EXPECT_EQ(session.state().treeBarriers, std::vector<std::string>{"20"});
  }
  session.undo();
  EXPECT_NE(session.state().tree, again.tree);
}

TEST(Session, ATreeThatCannotBeMadeAgainIsForgotten) {
  Session session;
  ProjectState state;
  state.city = std::make_shared<const CityModel>();
  state.droppedTree = TreeRecipe{};
  session.reset(state);
  TreeRecipe other;
  other.barriers = {"other"};
  session.giveTree(state.city, other, nullptr);
  EXPECT_TRUE(session.state().droppedTree);
  session.giveTree(nullptr, TreeRecipe{}, nullptr);
  EXPECT_TRUE(session.state().droppedTree);
  session.giveTree(state.city, TreeRecipe{}, nullptr);
  EXPECT_FALSE(session.state().droppedTree);
  EXPECT_FALSE(session.canUndo());
}

TEST(Session, OldCitiesAreForgottenWithTheirSteps) {
  Session session;
  std::vector<std::weak_ptr<const CityModel>> cities;
  for (int i = 0; i < 10; ++i) {
    ProjectState state;
    state.city = std::make_shared<const CityModel>();
    cities.push_back(state.city);
    session.commit(std::move(state), "import");
    session.commit(withEpsilon(session, i), "ε");
  }
  EXPECT_EQ(static_cast<std::size_t>(std::count_if(cities.begin(), cities.end(),
                                                   [](const auto& city) { return !city.expired(); })),
            Session::kKeptCities);
  while (session.canUndo()) session.undo();
  EXPECT_EQ(session.state().city, cities[10 - Session::kKeptCities].lock());
}

}  // namespace
}  // namespace lodestone
