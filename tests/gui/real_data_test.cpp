// The main job on real data in the real window: open, count, cluster, move the cut, look at the picture. Runs
// where the shared data is. LODESTONE_SCREENSHOTS names a folder in which the pictures are left; with
// LODESTONE_LONG the large ones run too.
#include <QDir>
#include <QSignalSpy>
#include <QSlider>
#include <QTreeWidget>

#include "gui/city/layers_panel.h"
#include "gui/city/method_panel.h"
#include "gui/city/objects_panel.h"
#include "gui/widgets/field_slider.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {
namespace {

QString sharedData(const QString& path) {
  const QString given = qEnvironmentVariable("LODESTONE_SHARED");
  const QString root = given.isEmpty() ? QStringLiteral(LODESTONE_SHARED_DATA) : given;
  return QDir(root).filePath(QStringLiteral("data/") + path);
}

/// All files that a pattern in the last part of a path names.
QStringList filesOf(const QString& pattern) {
  const QString path = sharedData(pattern);
  const QDir folder(QFileInfo(path).path());
  QStringList files;
  for (const QString& name : folder.entryList({QFileInfo(path).fileName()}, QDir::Files, QDir::Name))
    files << folder.filePath(name);
  return files;
}

/// Share of a picture's pixels that another one has in a different colour.
double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return 1;
  std::size_t differ = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) differ += a.pixel(x, y) != b.pixel(x, y) ? 1U : 0U;
  }
  return static_cast<double>(differ) / (static_cast<double>(a.width()) * a.height());
}

}  // namespace

class RealDataTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    window_ = makeWindow();
    window_->useDefaultLayout();
  }
  void cleanup() { window_.reset(); }
  void doesTheMainJob_data();
  void doesTheMainJob();

 private:
  [[nodiscard]] Workspace& workspace() { return window_->workspace(); }
  void waitForTasks() { QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), 120'000); }
  void opens(const QStringList& files, int buildings);
  void drawsTheCity(const QString& name);
  void movesTheCut(const QString& name);

  std::unique_ptr<MainWindow> window_;
};

/// Counts are those of the data's README less what the reader says it left out.
void RealDataTest::doesTheMainJob_data() {
  QTest::addColumn<QString>("files");
  QTest::addColumn<int>("buildings");
  QTest::addColumn<QString>("barriers");
  QTest::addColumn<int>("lines");
  const auto row = [](const char* name, const char* files, int buildings, const char* barriers = "",
                      int lines = 0) {
    QTest::newRow(name) << QString::fromLatin1(files) << buildings << QString::fromLatin1(barriers) << lines;
  };
  row("berlin", "A_citygml/berlin_lod2_argis/Berlin1b/*.gml", 137);
  row("nrw", "A_citygml/nrw_lod2/*.gml", 83);
  row("plateau", "A_citygml/plateau_builder/gml/13100_tokyo23-ku_2022_citygml_1_3_op/udx/bldg/*.gml", 9);
  row("potsdam", "A_citygml/potsdam_berlin_3dcitydb/Potsdam/CityGML/Potsdam_LoD1/*.gml", 97);
  row("fzk-haus", "A_citygml/fzkhaus_all_lods/*.zip", 1);
  row("denhaag", "B_cityjson/denhaag_zip_dtcc/*.zip", 844);
  row("geoclimate", "C_footprints/geoclimate_heights_roads/BUILDING.geojson", 2506,
      "C_footprints/geoclimate_heights_roads/ROAD.geojson", 873);
  row("helsinki", "C_footprints/osm_with_streets/Helsinki.osm.pbf", 482,  // 18 cannot be repaired
      "C_footprints/osm_with_streets/Helsinki.osm.pbf", 0);
  row("monaco", "C_footprints/osm_with_streets/monaco-latest.osm.pbf", 1207);
  if (!qEnvironmentVariableIsSet("LODESTONE_LONG")) return;
  row("hancock", "C_footprints/hancock_ms_41k_shp/tiled_footprints.zip", 41023);
  row("allegheny", "C_footprints/allegheny_547k_osm/*.osm.gz", 122648);  // one is said not to be repairable
}

void RealDataTest::opens(const QStringList& files, int buildings) {
  window_->openFiles(files, false);
  waitForTasks();
  QVERIFY(workspace().state().city != nullptr);
  QCOMPARE(window_->objects().model().rowCount(), buildings);
  const auto* tree = window_->findChild<QTreeWidget*>(QStringLiteral("layerTree"));
  QVERIFY2(tree->topLevelItem(0)->text(0).contains(QLocale().toString(buildings)),
           qPrintable(tree->topLevelItem(0)->text(0)));
}

void RealDataTest::drawsTheCity(const QString& name) {
  Viewport& view = window_->viewport();
  const QImage with = view.grabImage();
  keepPicture(*window_, name + QStringLiteral("-open"));
  view.scene().setLayerStyle(SceneLayer::Buildings, {.visible = false});
  const double share = difference(with, view.grabImage());
  view.scene().setLayerStyle(SceneLayer::Buildings, {});
  QVERIFY2(share > 0.02, qPrintable(QString::number(share)));
}

void RealDataTest::movesTheCut(const QString& name) {
  const auto tree = workspace().state().tree;  // a copy: steps move states
  QVERIFY(tree != nullptr);
  QCOMPARE(tree->dendrogram->leafCount, workspace().state().city->buildings.size());
  QSlider& slider = window_->method().epsilon().slider();
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Home);
  const std::size_t fine = workspace().cut()->drawn.size();
  const QImage finePicture = window_->viewport().grabImage();
  QTest::keyClick(&slider, Qt::Key_End);
  keepPicture(*window_, name + QStringLiteral("-coarse"));
  QCOMPARE(window_->viewport().scene().drawn().size(), workspace().cut()->drawn.size());
  if (tree->dendrogram->leafCount == 1) return;
  QVERIFY(workspace().cut()->drawn.size() < fine);
  QVERIFY(difference(finePicture, window_->viewport().grabImage()) > 0.005);
  CutOptions usual;
  workspace().setCutOptions(usual, QStringLiteral("test"));
  keepPicture(*window_, name + QStringLiteral("-clustered"));
}

void RealDataTest::doesTheMainJob() {
  QFETCH(QString, files);
  QFETCH(int, buildings);
  QFETCH(QString, barriers);
  QFETCH(int, lines);
  const QStringList paths = filesOf(files);
  if (paths.isEmpty()) QSKIP("the shared data is not here");
  opens(paths, buildings);
  if (QTest::currentTestFailed()) return;
  const QString name = QString::fromLatin1(QTest::currentDataTag());
  drawsTheCity(name);
  if (!barriers.isEmpty()) {
    workspace().setBarriers(filesOf(barriers));
    waitForTasks();
    std::size_t found = 0;
    for (const LineLayer& layer : workspace().barrierLines()) found += layer.lines.size();
    QVERIFY2(lines == 0 ? found > 0 : found == static_cast<std::size_t>(lines),
             qPrintable(QString::number(found)));
  }
  workspace().cluster();
  waitForTasks();
  movesTheCut(name);
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::RealDataTest>(argc, argv);
}
#include "real_data_test.moc"
