// What becomes of a project as files are opened over it or added to it.
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <fstream>

#include "gui/city/objects_panel.h"
#include "gui/dialogs/folder_dialog.h"
#include "gui/workspace/jobs.h"
#include "tests/gui/project_support.h"
#include "tests/gui/scene_support.h"

namespace lodestone {
namespace {

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

class ProjectFilesTest : public ProjectWindow {
  Q_OBJECT

 private Q_SLOTS:
  void init() { open(); }
  void cleanup() { window_.reset(); }

  void filesAreAddedToTheProject();
  void aFileThatCannotBeReadIsNotAdded();
  void whatChangesWhileFilesAreAddedStays();
  void filesWithOtherSettingsAreNotAdded();
  void openingInsteadAsksToSave();
  void undoComesBackToTheProjectBefore();
  void aFolderStandsForItsFiles();
  void aFolderOfSeveralKindsIsAskedAbout();
  void problemsBelongToTheirCity();
  void problemsOfAFailedImportBelongToNoCity();
};

void ProjectFilesTest::filesAreAddedToTheProject() {
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

void ProjectFilesTest::aFileThatCannotBeReadIsNotAdded() {
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

void ProjectFilesTest::whatChangesWhileFilesAreAddedStays() {
  const QTemporaryDir folder;
  const QString west = writeBlocks(folder, QStringLiteral("west.geojson"), 0, 3);
  const QString east = writeBlocks(folder, QStringLiteral("east.geojson"), 100, 2);
  workspace().import({west}, {});
  waitForTasks();
  workspace().addToModel({east}, {});
  CutOptions options = workspace().state().chainOptions.cut;
  options.epsilon = 77;
  workspace().setCutOptions(options, QStringLiteral("Tolerance"));
  workspace().setBarriers(sampleStreets());
  waitForTasks();
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{5});
  QCOMPARE(workspace().state().chainOptions.cut.epsilon, 77.0);
  QCOMPARE(workspace().state().barriers, toStrings(sampleStreets()));

  // Added to a city that is gone by then, they are not added to the one before.
  workspace().session().undo();
  workspace().addToModel({east}, {});
  while (workspace().session().canUndo()) workspace().session().undo();
  waitForTasks();
  QVERIFY(!workspace().state().city);
  QVERIFY(said(*window_, Code::Cancelled));
}

void ProjectFilesTest::filesWithOtherSettingsAreNotAdded() {
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
  QVERIFY2(refusal.contains(QStringLiteral("heights: the usual fields")), qPrintable(refusal));
  QVERIFY2(refusal.contains(QStringLiteral("lodestone-cli convert plain.geojson")), qPrintable(refusal));

  refusal.clear();
  asOneHeight = false;  // the settings of the open model
  window_->openFiles({plain});
  waitForTasks();
  QCOMPARE(refusal, QString());
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{4});
}

void ProjectFilesTest::openingInsteadAsksToSave() {
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

void ProjectFilesTest::undoComesBackToTheProjectBefore() {
  openSample();
  const QTemporaryDir folder;
  const QString town = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(town, QStringLiteral("{}")));
  workspace().markSaved(town);
  const auto city = workspace().state().city;
  workspace().import({writeBlocks(folder, QStringLiteral("west.geojson"), 0, 3)}, {});
  waitForTasks();
  QVERIFY(workspace().projectPath().isEmpty());
  workspace().session().undo();
  waitForTasks();
  QCOMPARE(workspace().state().city, city);
  QCOMPARE(workspace().projectPath(), town);
  QVERIFY(!workspace().hasUnsavedWork());
  QVERIFY(window_->windowTitle().startsWith(QStringLiteral("town")));
  // And there again: each has its own place, and its own saved state.
  workspace().session().redo();
  QVERIFY(workspace().projectPath().isEmpty());
  const QString west = folder.filePath(QStringLiteral("west.lodestone"));
  QVERIFY(workspace().saveProject(west, QStringLiteral("{}")));
  workspace().markSaved(west);
  workspace().session().undo();
  QCOMPARE(workspace().projectPath(), town);
  QVERIFY(!workspace().session().modified());
  workspace().setCutChoice({CutMode::Weight, 700});
  QVERIFY(workspace().hasUnsavedWork());
  waitForTasks();
}

void ProjectFilesTest::aFolderStandsForItsFiles() {
  const QTemporaryDir folder;
  QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("tiles/east")));
  writeBlocks(folder, QStringLiteral("tiles/west.geojson"), 0, 3);
  writeBlocks(folder, QStringLiteral("tiles/east/east.geojson"), 100, 2);
  std::ofstream(folder.filePath(QStringLiteral("tiles/readme.txt")).toStdString()) << "tiles";
  std::ofstream(folder.filePath(QStringLiteral("tiles/odd.json")).toStdString()) << "{}";
  window_->openFiles({folder.filePath(QStringLiteral("tiles"))});
  waitForTasks();
  QVERIFY(workspace().state().city);
  QCOMPARE(workspace().state().city->buildings.size(), std::size_t{5});
  QCOMPARE(workspace().state().sources.size(), std::size_t{2});
  const auto city = workspace().state().city;
  QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("empty")));
  window_->openFiles({folder.filePath(QStringLiteral("empty"))});
  waitForTasks();
  QCOMPARE(workspace().state().city, city);
  const std::string& text = window_->messages().messages().back().text;
  QVERIFY2(text.find("nothing in the folder") != std::string::npos && text.find(".gml") != std::string::npos,
           text.c_str());
}

void ProjectFilesTest::aFolderOfSeveralKindsIsAskedAbout() {
  const QTemporaryDir folder;
  for (const char* name : {"west.geojson", "east.geojson"})
    writeBlocks(folder, QString::fromLatin1(name), name[0] == 'w' ? 0 : 100, 2);
  QVERIFY(QFile::copy(samplePath(), folder.filePath(QStringLiteral("town.city.json"))));
  const std::vector<FileKind> kinds = readableFiles(folder.path());
  QCOMPARE(kinds.size(), std::size_t{2});
  QCOMPARE(kinds.front().paths.size(), 2);
  {
    const NextDialog cancel(QStringLiteral("Cancel"));
    window_->openFiles({folder.path()});
    QVERIFY(cancel.came());
    waitForTasks();
    QVERIFY(!workspace().state().city);
  }
  FolderDialog dialog(folder.path(), kinds);
  dialog.show();
  if (const QString to = qEnvironmentVariable("LODESTONE_SCREENSHOTS"); !to.isEmpty())
    dialog.grab().save(QDir(to).filePath(QStringLiteral("folder.png")));
  auto* list = dialog.findChild<QListWidget*>(QStringLiteral("fileKinds"));
  QCOMPARE(dialog.paths(), kinds.front().paths);
  list->item(0)->setCheckState(Qt::Unchecked);
  QVERIFY(dialog.paths().isEmpty());
  list->item(1)->setCheckState(Qt::Checked);
  QCOMPARE(dialog.paths(), QStringList{folder.filePath(QStringLiteral("town.city.json"))});
}

void ProjectFilesTest::problemsBelongToTheirCity() {
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

void ProjectFilesTest::problemsOfAFailedImportBelongToNoCity() {
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

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::ProjectFilesTest>(argc, argv);
}
#include "project_files_test.moc"
