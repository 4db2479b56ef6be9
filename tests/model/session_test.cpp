#include "model/session.h"

#include <gmock/gmock.h>

namespace lodestone {
namespace {

ProjectState withEpsilon(const Session& session, double epsilon) {
  ProjectState state = session.state();
  state.cutOptions.epsilon = epsilon;
  return state;
}

TEST(Session, UndoAndRedoMoveThroughTheStates) {
  Session session;
  session.commit(withEpsilon(session, 1), "one");
  session.commit(withEpsilon(session, 2), "two");
  EXPECT_EQ(session.undoText(), "two");
  session.undo();
  EXPECT_EQ(session.state().cutOptions.epsilon, 1);
  EXPECT_EQ(session.redoText(), "two");
  session.undo();
  EXPECT_FALSE(session.canUndo());
  EXPECT_EQ(session.state().cutOptions.epsilon, CutOptions{}.epsilon);
  session.redo();
  session.redo();
  EXPECT_EQ(session.state().cutOptions.epsilon, 2);
  EXPECT_FALSE(session.canRedo());
}

TEST(Session, ACommitForgetsWhatWasUndone) {
  Session session;
  session.commit(withEpsilon(session, 1), "one");
  session.undo();
  session.commit(withEpsilon(session, 3), "three");
  EXPECT_FALSE(session.canRedo());
  session.undo();
  EXPECT_EQ(session.state().cutOptions.epsilon, CutOptions{}.epsilon);
}

TEST(Session, ADraggedSliderIsOneStep) {
  Session session;
  for (int i = 1; i <= 10; ++i) session.commit(withEpsilon(session, i), "ε", "epsilon");
  session.undo();
  EXPECT_EQ(session.state().cutOptions.epsilon, CutOptions{}.epsilon);
  EXPECT_FALSE(session.canUndo());
}

TEST(Session, AmendReplacesWithoutAStep) {
  Session session;
  session.commit(withEpsilon(session, 1), "one");
  session.amend(withEpsilon(session, 5));
  EXPECT_EQ(session.state().cutOptions.epsilon, 5);
  session.undo();
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

TEST(Session, HistoryIsBoundedAndKeepsTheLatest) {
  Session session;
  for (int i = 1; i <= 1000; ++i) session.commit(withEpsilon(session, i), "step");
  EXPECT_EQ(session.state().cutOptions.epsilon, 1000);
  int steps = 0;
  while (session.canUndo()) {
    session.undo();
    ++steps;
  }
  EXPECT_LT(steps, 1000);
  EXPECT_EQ(session.state().cutOptions.epsilon, 1000 - steps);
}

TEST(Session, ListenersSeeBeforeAndAfter) {
  Session session;
  double before = 0;
  double after = 0;
  session.listen([&](const ProjectState& b, const ProjectState& a) {
    before = b.cutOptions.epsilon;
    after = a.cutOptions.epsilon;
  });
  session.commit(withEpsilon(session, 7), "seven");
  EXPECT_EQ(before, CutOptions{}.epsilon);
  EXPECT_EQ(after, 7);
  session.undo();
  EXPECT_EQ(before, 7);
}

}  // namespace
}  // namespace lodestone
