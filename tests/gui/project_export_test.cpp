// Exports of a project: one after the other, cancelled, and waiting for what they need.
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "tests/gui/project_support.h"

namespace lodestone {

class ProjectExportTest : public ProjectWindow {
  Q_OBJECT

 private Q_SLOTS:
  void init() { open(); }
  void cleanup() { window_.reset(); }

  void exportsRunOneAfterTheOther();
  void aWaitingExportCanBeCancelled();
  void anExportWaitsForItsTree();
};

void ProjectExportTest::exportsRunOneAfterTheOther() {
  openSample();
  const QTemporaryDir folder;
  QSignalSpy exported(&workspace(), &Workspace::exported);
  for (const char* name : {"first", "second", "third"}) {
    ExportRequest request;
    request.folder = folder.path().toStdString();
    request.name = name;
    request.formats = {"cityjson"};
    workspace().exportChain(request);
  }
  QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 3, kLong);
  for (int i = 0; i < 3; ++i) QVERIFY(!exported[i].front().toStringList().isEmpty());
  QVERIFY(exported[0].front().toStringList().front().contains(QStringLiteral("first")));
  QVERIFY(exported[2].front().toStringList().front().contains(QStringLiteral("third")));
  QVERIFY(!said(*window_, Code::Cancelled));
  waitForTasks();
}

void ProjectExportTest::aWaitingExportCanBeCancelled() {
  TaskRunner runner;
  std::atomic<bool> go = false;
  std::atomic<bool> second = false;
  QSignalSpy finished(&runner, &TaskRunner::finished);
  QSignalSpy idle(&runner, &TaskRunner::idle);
  runner.enqueue(
      QStringLiteral("k"), QStringLiteral("one"),
      [&](const Progress&) {
        while (!go) std::this_thread::yield();
        return 1;
      },
      [](int) {});
  runner.enqueue(
      QStringLiteral("k"), QStringLiteral("two"),
      [&](const Progress&) {
        second = true;
        return 2;
      },
      [](int) {});
  QVERIFY(runner.busy(QStringLiteral("k")));
  runner.cancelAll();
  go = true;
  QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, kLong);
  QCOMPARE(finished.count(), 2);
  QVERIFY(!finished[0][1].toBool() && !finished[1][1].toBool());
  QVERIFY2(!second, "what was cancelled before its turn never begins");
}

void ProjectExportTest::anExportWaitsForItsTree() {
  workspace().setCutChoice({CutMode::Weight, 700});
  ProjectState state = workspace().state();
  state.city = smallCity(300);
  workspace().session().commit(state, "test");
  cluster(1);
  state = workspace().state();
  const QTemporaryDir folder;
  QSignalSpy exported(&workspace(), &Workspace::exported);
  ExportRequest request;
  request.folder = folder.path().toStdString();
  request.formats = {"cityjson"};
  const auto written = [&](const char* name, bool drawnCut) {
    request.name = name;
    request.drawnCut = drawnCut;
    workspace().exportChain(request);
    exported.wait(kLong);
    QByteArray all;
    for (const QString& path : exported.back().front().toStringList()) {
      QFile file(path);
      if (file.open(QIODevice::ReadOnly)) all += file.readAll();
    }
    return all;
  };
  const QByteArray chain = written("with", false);
  const QByteArray cut = written("cut", true);
  QVERIFY(!chain.isEmpty() && chain != cut);
  state.tree.reset();
  state.droppedTree = TreeRecipe{state.clusterOptions, state.mergeOptions, state.barriers};
  for (const bool drawnCut : {false, true}) {
    workspace().session().commit({}, "nothing");
    workspace().session().commit(state, "dropped");
    QVERIFY(!workspace().state().tree);
    QVERIFY(drawnCut ? written("cut", true) == cut : written("with", false) == chain);
  }
  waitForTasks();
  QVERIFY(workspace().state().tree != nullptr);
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::ProjectExportTest>(argc, argv);
}
#include "project_export_test.moc"
