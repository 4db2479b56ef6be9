// What becomes of a project as steps are made and taken back, and as it is saved and opened.
#include <QDockWidget>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>

#include "gui/city/objects_panel.h"
#include "tests/gui/project_support.h"

namespace lodestone {

class ProjectTest : public ProjectWindow {
  Q_OBJECT

 private Q_SLOTS:
  void init() { open(); }
  void cleanup() { window_.reset(); }

  void settingsThatWereChangedAreWork();
  void anOpenedProjectIsUnmodified();
  void undoReachesExactlyWhatWasSaved();
  void aTreeThatWasDroppedIsMadeAgain();
  void everyStepOfAnOpenedProjectHasItsTree();
  void panelsGoBeforeTheWorkspace();
};

void ProjectTest::settingsThatWereChangedAreWork() {
  openSample();
  QVERIFY(!workspace().hasUnsavedWork());  // it can be made again
  ClusterOptions options = workspace().state().clusterOptions;
  options.neighbours = 20;
  workspace().setClusterOptions(options, QStringLiteral("Neighbours"));
  QVERIFY(workspace().hasUnsavedWork());
}

void ProjectTest::anOpenedProjectIsUnmodified() {
  openSample();
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(path, QStringLiteral("{}")));
  workspace().close();
  window_->openFiles({path});
  QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
  waitForTasks();
  QVERIFY(!workspace().session().modified());
  QVERIFY(!window_->isWindowModified());
  QVERIFY(!workspace().session().canUndo());
  QVERIFY(!workspace().hasUnsavedWork());
}

void ProjectTest::undoReachesExactlyWhatWasSaved() {
  openSample();
  const auto epsilon = [this](double value) {
    CutOptions options = workspace().state().chainOptions.cut;
    options.epsilon = value;
    workspace().setCutOptions(options, QStringLiteral("Tolerance"));
  };
  epsilon(40);
  epsilon(50);
  workspace().session().markSaved();
  epsilon(60);
  epsilon(70);
  QVERIFY(workspace().session().modified());
  workspace().session().undo();
  QCOMPARE(workspace().state().chainOptions.cut.epsilon, 50.0);
  QVERIFY(!workspace().session().modified());
}

void ProjectTest::aTreeThatWasDroppedIsMadeAgain() {
  ProjectState state;
  state.city = smallCity(300);
  workspace().session().commit(std::move(state), "test");
  std::vector<std::weak_ptr<const ClusterTree>> trees;
  std::vector<std::size_t> hulls;
  for (int i = 0; i < 6; ++i) {
    cluster(i);
    trees.push_back(workspace().state().tree);
    hulls.push_back(workspace().state().tree->hullVertices.size());
  }
  const auto alive = [&] {
    return std::count_if(trees.begin(), trees.end(), [](const auto& tree) { return !tree.expired(); });
  };
  QVERIFY2(alive() <= static_cast<std::ptrdiff_t>(Session::kKeptTrees), qPrintable(QString::number(alive())));
  for (int i = 0; i < 10; ++i) workspace().session().undo();  // to the first tree: two steps each
  waitForTasks();
  QVERIFY(workspace().state().tree != nullptr);
  QVERIFY(!workspace().state().droppedTree);
  QCOMPARE(workspace().state().tree->hullVertices.size(), hulls.front());
  QCOMPARE(workspace().state().tree->dendrogram->options.barrierFactor, 0.0);
  QVERIFY2(workspace().session().canRedo(), "making it again is no step");
}

void ProjectTest::everyStepOfAnOpenedProjectHasItsTree() {
  openSample();
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(path, QStringLiteral("{}")));
  workspace().close();
  QSignalSpy imported(&workspace(), &Workspace::imported);
  workspace().openProject(path);
  QTRY_COMPARE_WITH_TIMEOUT(imported.count(), 1, kLong);
  QVERIFY(!workspace().state().tree);
  CutOptions options = workspace().state().chainOptions.cut;
  options.epsilon = 33;
  workspace().setCutOptions(options, QStringLiteral("Tolerance"));
  waitForTasks();
  const auto tree = workspace().state().tree;
  QVERIFY(tree != nullptr);
  workspace().session().undo();
  QCOMPARE(workspace().state().tree, tree);
  QVERIFY(!workspace().tasks().busy());
}

void ProjectTest::panelsGoBeforeTheWorkspace() {
  openSample();
  bool workspaceGone = false;
  int late = 0;
  connect(&workspace(), &QObject::destroyed, this, [&] { workspaceGone = true; });
  std::vector<QObject*> watched{&window_->viewport(), &window_->objects().model(), window_->statusBar()};
  for (auto* dock : window_->findChildren<QDockWidget*>()) watched.push_back(dock);
  for (QObject* object : watched) {
    connect(object, &QObject::destroyed, this, [&] { late += workspaceGone ? 1 : 0; });
  }
  window_.reset();
  QVERIFY(workspaceGone);
  QCOMPARE(late, 0);
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::ProjectTest>(argc, argv);
}
#include "project_test.moc"
