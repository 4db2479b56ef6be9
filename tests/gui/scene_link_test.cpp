// The view follows the project without the window waiting for it.
#include <QElapsedTimer>
#include <QSignalSpy>

#include "gui/city/layers_panel.h"
#include "tests/gui/project_support.h"

namespace lodestone {

class SceneLinkTest : public ProjectWindow {
  Q_OBJECT

 private Q_SLOTS:
  void init() { open(); }
  void cleanup() { window_.reset(); }

  void theWindowDoesNotWaitForTheMesh();
  void onlyTheLastCityIsShown();
  void aCutOfATreeThatIsNotThereYetIsNotDrawn();
  void cancelLeavesTheCityInView();
  void barriersAreDrawnWhicheverComesFirst();

 private:
  [[nodiscard]] CityScene& scene() { return window_->viewport().scene(); }
  void show(const std::shared_ptr<const CityModel>& city) {
    ProjectState state;
    state.city = city;
    workspace().session().commit(std::move(state), "test");
  }
};

void SceneLinkTest::theWindowDoesNotWaitForTheMesh() {
  const auto city = smallCity(2000);
  show(city);
  QVERIFY2(scene().city() != city, "it is meshed on another thread");
  QVERIFY(workspace().tasks().busy());
  waitForTasks();
  QCOMPARE(scene().city(), city);
  QCOMPARE(scene().drawn().size(), std::size_t{2000});
  QVERIFY(!scene().bounds().empty());
  // It is looked at as a whole, and the cut is chosen from there.
  QVERIFY(workspace().camera() == window_->viewport().camera());
  QVERIFY(scene().project(scene().bounds().center()).has_value());
  workspace().cluster();
  waitForTasks();
  QCOMPARE(scene().tree(), workspace().state().tree);
  QCOMPARE(scene().drawn().size(), workspace().cut()->drawn.size());
}

void SceneLinkTest::onlyTheLastCityIsShown() {
  const auto first = smallCity(4000);
  const auto last = smallCity(30);
  show(first);
  show(last);
  waitForTasks();
  QCOMPARE(scene().city(), last);
  QCOMPARE(scene().drawn().size(), std::size_t{30});
  workspace().session().undo();
  workspace().session().undo();
  QVERIFY2(!scene().city(), "no city is there at once");
  waitForTasks();
  QVERIFY(!scene().city());
}

void SceneLinkTest::aCutOfATreeThatIsNotThereYetIsNotDrawn() {
  show(smallCity(500));
  cluster(1);
  const auto before = scene().tree();
  QVERIFY(before);
  // Another tree: its numbers mean other clusters, which must not be looked up in the old one.
  ProjectState state = workspace().state();
  auto other = std::make_shared<ClusterTree>(*state.tree);
  state.tree = other;
  workspace().session().commit(state, "test");
  const std::size_t drawn = scene().drawn().size();
  workspace().setCutChoice({CutMode::Original, 0});
  QCOMPARE(scene().tree(), before);
  QCOMPARE(scene().drawn().size(), drawn);
  Q_EMIT window_->viewport().picked(3, false);
  QVERIFY2(workspace().selection().empty(), "nor is anything picked in it");
  waitForTasks();
  QCOMPARE(scene().tree(), state.tree);
  QCOMPARE(scene().drawn().size(), std::size_t{500});
  Q_EMIT window_->viewport().picked(3, false);
  QCOMPARE(workspace().selection(), std::vector<NodeId>{3});
}

void SceneLinkTest::cancelLeavesTheCityInView() {
  const auto city = smallCity(3000);
  show(city);
  workspace().tasks().cancelAll();
  waitForTasks();
  QCOMPARE(scene().city(), city);
  QVERIFY(!said(*window_, Code::Cancelled));
}

void SceneLinkTest::barriersAreDrawnWhicheverComesFirst() {
  openSample();
  QVERIFY(!workspace().barrierLines().empty());
  QVERIFY(!window_->layers().shownLines().empty());
  const QImage with = window_->viewport().grabImage();
  scene().setOverlay(Overlay::Streets, false);
  QVERIFY(with != window_->viewport().grabImage());
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::SceneLinkTest>(argc, argv);
}
#include "scene_link_test.moc"
