// What happens to a project as files are opened over it, steps are taken back and things are written side by
// side.
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTimer>
#include <fstream>

#include "algorithms/synthesis.h"
#include "gui/jobs.h"
#include "gui/objects_panel.h"
#include "gui/same_clusters.h"
#include "model/io/format.h"
#include "tests/gui/scene_support.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {
namespace {

std::shared_ptr<const CityModel> smallCity(int buildings) {
  SynthOptions options;
  options.preset = CityPreset::Charlotte;
  options.buildings = buildings;
  return std::make_shared<const CityModel>(synthesiseCity(options));
}

/// A few boxes in a row, as GeoJSON in metres.
QString writeBlocks(const QTemporaryDir& folder, const QString& name, double x, int count) {
  const QString path = folder.filePath(name);
  std::ofstream file(path.toStdString());
  file
      << R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:25832"}},"features":[)";
  for (int i = 0; i < count; ++i) {
    const double left = 500000 + x + 20 * i;
    const double right = left + 10;
    file << (i ? "," : "") << R"({"type":"Feature","properties":{"height":)" << 5 + i
         << R"(},"geometry":{"type":"Polygon","coordinates":[[[)" << left << ",5000000],[" << right
         << ",5000000],[" << right << ",5000010],[" << left << ",5000010],[" << left << ",5000000]]]}}";
  }
  file << "]}";
  return path;
}

/// Presses a button of the next dialog whose text holds `text`; false when none came up.
class NextDialog {
 public:
  explicit NextDialog(const QString& text) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, text] {
      QWidget* dialog = QApplication::activeModalWidget();
      if (!dialog) return;
      for (QPushButton* button : dialog->findChildren<QPushButton*>()) {
        if (!button->text().remove(QLatin1Char('&')).contains(text)) continue;
        timer_.stop();
        came_ = true;
        button->click();
        return;
      }
    });
    timer_.start(20);
  }
  [[nodiscard]] bool came() const { return came_; }

 private:
  QTimer timer_;
  bool came_ = false;
};

}  // namespace

class ProjectTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { useTestSettings(); }
  void init() { window_ = makeWindow(); }
  void cleanup() { window_.reset(); }

  void exportsRunOneAfterTheOther();
  void aWaitingExportCanBeCancelled();
  void aClusterStaysSelectedByItsBuildings();
  void clustersAreComparedByTheirBuildings();
  void anOpenedProjectIsUnmodified();
  void undoReachesExactlyWhatWasSaved();
  void aTreeThatWasDroppedIsMadeAgain();
  void everyStepOfAnOpenedProjectHasItsTree();
  void anExportWaitsForItsTree();
  void filesAreAddedToTheProject();
  void aFileThatCannotBeReadIsNotAdded();
  void whatChangesWhileFilesAreAddedStays();
  void filesWithOtherSettingsAreNotAdded();
  void openingInsteadAsksToSave();
  void problemsBelongToTheirCity();
  void problemsOfAFailedImportBelongToNoCity();
  void largeClustersAreComparedBySizeFirst();
  void panelsGoBeforeTheWorkspace();

 private:
  [[nodiscard]] Workspace& workspace() { return window_->workspace(); }
  void waitForTasks() { QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong); }
  void openSample() {
    workspace().openSample();
    QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
    waitForTasks();
  }
  void cluster(double factor) {
    ClusterOptions options = workspace().state().clusterOptions;
    options.barrierFactor = factor;
    workspace().setClusterOptions(options, QString::number(factor));
    workspace().cluster();
    waitForTasks();
  }

  std::unique_ptr<MainWindow> window_;
};

void ProjectTest::exportsRunOneAfterTheOther() {
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

void ProjectTest::aWaitingExportCanBeCancelled() {
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

void ProjectTest::aClusterStaysSelectedByItsBuildings() {
  openSample();
  const auto tree = workspace().state().tree;
  const NodeId pair = workspace().state().tree->dendrogram->leafCount;  // the first merge
  const NodeId root = tree->dendrogram->root();
  workspace().select({3, pair, root});
  ClusterOptions options = workspace().state().clusterOptions;
  options.linkage = Linkage::Complete;
  workspace().setClusterOptions(options, QStringLiteral("linkage"));
  workspace().cluster();
  waitForTasks();
  const auto after = workspace().state().tree;
  QVERIFY(after != tree);
  QCOMPARE(workspace().selection(), sameClusters(tree.get(), after.get(), {3, pair, root}));
  QCOMPARE(workspace().selection().front(), NodeId{3});
  QCOMPARE(workspace().selection().back(), after->dendrogram->root());
  QCOMPARE(window_->viewport().scene().selection(), workspace().selection());
  workspace().session().undo();
  workspace().session().undo();
  workspace().session().undo();
  QVERIFY(!workspace().state().tree);
  QCOMPARE(workspace().selection(), std::vector<NodeId>{3});
}

void ProjectTest::clustersAreComparedByTheirBuildings() {
  const auto city = test::smallTown(4);
  const auto one = test::handMadeTree(*city);
  // The same buildings joined in another order: node numbers differ, some sets of buildings do not.
  auto other = std::make_shared<ClusterTree>(*one);
  std::swap(other->nodes[16].a, other->nodes[17].a);
  std::swap(other->nodes[16].b, other->nodes[17].b);
  for (const NodeId node : {NodeId{16}, NodeId{17}}) {
    other->nodes[other->nodes[node].a].parent = node;
    other->nodes[other->nodes[node].b].parent = node;
  }
  QCOMPARE(sameClusters(one.get(), other.get(), {16, 17, 5, 18}), (std::vector<NodeId>{17, 16, 5, 18}));
  std::swap(other->nodes[18].b, other->nodes[19].b);
  for (const NodeId node : {NodeId{18}, NodeId{19}}) other->nodes[other->nodes[node].b].parent = node;
  QCOMPARE(sameClusters(one.get(), other.get(), {18, 19}), std::vector<NodeId>{});
  QCOMPARE(sameClusters(one.get(), nullptr, {1, 20, 2}), (std::vector<NodeId>{1, 2}));
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
    CutOptions options = workspace().state().cutOptions;
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
  QCOMPARE(workspace().state().cutOptions.epsilon, 50.0);
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
  CutOptions options = workspace().state().cutOptions;
  options.epsilon = 33;
  workspace().setCutOptions(options, QStringLiteral("Tolerance"));
  waitForTasks();
  const auto tree = workspace().state().tree;
  QVERIFY(tree != nullptr);
  workspace().session().undo();
  QCOMPARE(workspace().state().tree, tree);
  QVERIFY(!workspace().tasks().busy());
}

void ProjectTest::anExportWaitsForItsTree() {
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

void ProjectTest::filesAreAddedToTheProject() {
  const QTemporaryDir folder;
  const QString west = writeBlocks(folder, QStringLiteral("west.geojson"), 0, 3);
  const QString east = writeBlocks(folder, QStringLiteral("east.geojson"), 100, 2);
  ImportOptions options;
  workspace().import({west}, options, true);
  waitForTasks();
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{3});
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(path, QStringLiteral("{}")));
  workspace().markSaved(path);
  workspace().addToModel({east, west}, options);  // what is there already is not there twice
  waitForTasks();
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{5});
  QCOMPARE(workspace().projectPath(), path);
  QVERIFY(workspace().session().modified());
  QVERIFY(workspace().state().tree != nullptr);

  // The same through the window: it asks what the file is to be.
  workspace().session().undo();
  workspace().session().undo();
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{3});
  QVERIFY(!workspace().session().modified());
  const NextDialog add(QStringLiteral("Add"));
  window_->openFiles({samplePath()});
  QVERIFY(add.came());
  waitForTasks();
  QCOMPARE(workspace().projectPath(), path);
  QCOMPARE(workspace().state().sources.size(), std::size_t{2});
}

void ProjectTest::aFileThatCannotBeReadIsNotAdded() {
  const QTemporaryDir folder;
  const QString west = writeBlocks(folder, QStringLiteral("west.geojson"), 0, 3);
  const QString east = writeBlocks(folder, QStringLiteral("east.geojson"), 100, 2);
  const QString broken = folder.filePath(QStringLiteral("broken.geojson"));
  std::ofstream(broken.toStdString()) << R"({"type":"FeatureCollection","features":[{)";
  workspace().import({west}, {}, true);
  waitForTasks();
  const auto city = workspace().state().city;
  const auto tree = workspace().state().tree;
  const std::string undo = workspace().session().undoText();
  workspace().addToModel({east, broken}, {});
  waitForTasks();
  QCOMPARE(workspace().state().city, city);
  QCOMPARE(workspace().state().tree, tree);
  QCOMPARE(workspace().state().sources.size(), std::size_t{1});
  QCOMPARE(workspace().session().undoText(), undo);
  QVERIFY(said(*window_, Code::InputLeftOut));
}

void ProjectTest::whatChangesWhileFilesAreAddedStays() {
  const QTemporaryDir folder;
  const QString west = writeBlocks(folder, QStringLiteral("west.geojson"), 0, 3);
  const QString east = writeBlocks(folder, QStringLiteral("east.geojson"), 100, 2);
  workspace().import({west}, {});
  waitForTasks();
  workspace().addToModel({east}, {});
  CutOptions options = workspace().state().cutOptions;
  options.epsilon = 77;
  workspace().setCutOptions(options, QStringLiteral("Tolerance"));
  workspace().setBarriers(sampleStreets());
  waitForTasks();
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{5});
  QCOMPARE(workspace().state().cutOptions.epsilon, 77.0);
  QCOMPARE(workspace().state().barriers, toStrings(sampleStreets()));

  // Added to a city that is gone by then, they are not added to the one before.
  workspace().session().undo();
  workspace().addToModel({east}, {});
  while (workspace().session().canUndo()) workspace().session().undo();
  waitForTasks();
  QVERIFY(!workspace().state().city);
  QVERIFY(said(*window_, Code::Cancelled));
}

void ProjectTest::filesWithOtherSettingsAreNotAdded() {
  const QTemporaryDir folder;
  const QString west = writeBlocks(folder, QStringLiteral("west.geojson"), 0, 3);
  const QString plain = folder.filePath(QStringLiteral("plain.geojson"));
  std::ofstream(plain.toStdString())
      << R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:25832"}},"features":[)"
      << R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)"
      << R"([[[500100,5000000],[500110,5000000],[500110,5000010],[500100,5000000]]]}}]})";
  workspace().import({west}, {});
  waitForTasks();
  const auto city = workspace().state().city;
  bool asOneHeight = true;
  QString refusal;
  QTimer person;
  connect(&person, &QTimer::timeout, &person, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    if (auto* heights = dialog->findChild<QComboBox*>(QStringLiteral("height"))) {
      heights->setCurrentIndex(asOneHeight ? heights->count() - 1 : 0);
      dialog->accept();
    } else if (dialog->objectName() == QStringLiteral("cannotAdd")) {
      refusal = qobject_cast<QMessageBox*>(dialog)->informativeText();
      dialog->accept();
    } else {
      for (QPushButton* button : dialog->findChildren<QPushButton*>()) {
        if (button->text().contains(QStringLiteral("Add"))) button->click();
      }
    }
  });
  person.start(20);
  window_->openFiles({plain});
  waitForTasks();
  QCOMPARE(workspace().state().city, city);
  QVERIFY2(refusal.contains(QStringLiteral("heights")), qPrintable(refusal));

  refusal.clear();
  asOneHeight = false;  // the settings of the open model
  window_->openFiles({plain});
  waitForTasks();
  QCOMPARE(refusal, QString());
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{4});
}

void ProjectTest::openingInsteadAsksToSave() {
  openSample();
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(path, QStringLiteral("{}")));
  workspace().markSaved(path);
  workspace().setCutChoice({CutMode::Weight, 700});
  const auto city = workspace().state().city;
  {
    const NextDialog instead(QStringLiteral("instead"));
    std::unique_ptr<NextDialog> stay;
    QTimer::singleShot(300, this, [&] { stay = std::make_unique<NextDialog>(QStringLiteral("Cancel")); });
    window_->openFiles({samplePath()});
    QVERIFY(instead.came() && stay && stay->came());
  }
  waitForTasks();
  QCOMPARE(workspace().state().city, city);
  QCOMPARE(workspace().projectPath(), path);
  workspace().session().markSaved();
  const NextDialog instead(QStringLiteral("instead"));
  window_->openFiles({samplePath()});
  waitForTasks();
  QVERIFY(workspace().state().city != city);
  QVERIFY(workspace().projectPath().isEmpty());
}

void ProjectTest::problemsBelongToTheirCity() {
  ProjectState first;
  first.city = test::smallTown(3);
  workspace().session().commit(std::move(first), "first");
  BuildingTable& table = window_->objects().model();
  const auto problems = [&] { return table.index(4, BuildingTable::Problems).data().toString(); };
  Q_EMIT workspace().diagnosed({diagnose(Code::RingTooShort, "", "b4")});
  QCOMPARE(problems(), QStringLiteral("1"));
  ProjectState second;
  second.city = test::smallTown(3);
  workspace().session().commit(std::move(second), "second");
  QCOMPARE(problems(), QString());
  workspace().session().undo();
  QCOMPARE(problems(), QStringLiteral("1"));
}

void ProjectTest::problemsOfAFailedImportBelongToNoCity() {
  const QTemporaryDir folder;
  openSample();
  const QString id = QString::fromStdString(workspace().state().city->buildings[0].object.id);
  const QString broken = folder.filePath(QStringLiteral("same.city.json"));
  std::ofstream(broken.toStdString())
      << R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},)"
      << R"("vertices":[],"CityObjects":{")" << id.toStdString()
      << R"(":{"type":"Building","geometry":[{"type":"Solid","lod":"1","boundaries":[[[[0,1,2]]]]}]}}})";
  BuildingTable& table = window_->objects().model();
  const QString before = table.index(table.rowOf(0), BuildingTable::Problems).data().toString();
  int told = 0;
  connect(&workspace(), &Workspace::importRejected, this, [&] { ++told; });
  const QString missing = folder.filePath(QStringLiteral("missing.city.json"));
  workspace().addToModel({broken, missing}, {});
  waitForTasks();
  const Diagnostics& messages = window_->messages().messages();
  QVERIFY(std::any_of(messages.begin(), messages.end(),
                      [&](const Diagnostic& d) { return d.object == id.toStdString(); }));
  QCOMPARE(told, 1);
  QCOMPARE(table.index(table.rowOf(0), BuildingTable::Problems).data().toString(), before);
}

/// A tree that joins its buildings in pairs, or one after the other.
ClusterTree treeOf(std::uint32_t leaves, bool inPairs) {
  ClusterTree tree;
  tree.nodes.resize(2 * static_cast<std::size_t>(leaves) - 1);
  for (NodeId next = leaves; next < tree.nodes.size(); ++next) {
    const NodeId merge = next - leaves;
    const NodeId a = inPairs ? 2 * merge : merge == 0 ? 0 : next - 1;
    const NodeId b = inPairs ? 2 * merge + 1 : merge + 1;
    tree.nodes[next].a = a;
    tree.nodes[next].b = b;
    tree.nodes[next].size = tree.nodes[a].size + tree.nodes[b].size;
    tree.nodes[a].parent = tree.nodes[b].parent = next;
  }
  return tree;
}

void ProjectTest::largeClustersAreComparedBySizeFirst() {
  const std::uint32_t leaves = 1U << 16;
  const ClusterTree chain = treeOf(leaves, false);
  const ClusterTree pairs = treeOf(leaves, true);
  std::vector<NodeId> all;
  for (NodeId node = leaves; node < chain.nodes.size(); ++node) all.push_back(node);
  QElapsedTimer timer;
  timer.start();
  QCOMPARE(sameClusters(&chain, &pairs, all).size(), std::size_t{16});  // those of 2, 4, 8, … buildings
  // All their buildings listed would be 2·10⁹ of them: minutes. By size it is a fraction of a second.
  QVERIFY2(timer.elapsed() < 5000, qPrintable(QString::number(timer.elapsed())));
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
