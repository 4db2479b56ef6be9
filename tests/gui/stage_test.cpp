// The stage of one building in the real window: components, classes, live simplification, comparison. What is
// drawn is looked at pixel by pixel.
#include <QAction>
#include <QGroupBox>
#include <QHeaderView>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>
#include <cmath>

#include "gui/city/objects_panel.h"
#include "gui/simplification/components_panel.h"
#include "gui/simplification/simplify_form.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_legend.h"
#include "gui/widgets/field_slider.h"
#include "tests/gui/stage_support.h"

namespace lodestone {

class StageTest : public StageFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { writePavilion(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void meshOpensOnTheStageByItself();
  void meshIsDrawnInTheCityToo();
  void showsComponentsInTheirColours();
  void selectsBothWays();
  void isolatesAndGhosts();
  void switchesEachClassOfVertices();
  void sidesShareTheCamera();
  void chosenCameraStaysWhenPanesChange();
  void wipesBetweenOriginalAndSimplified();
  void slidersSimplifyLive();
  void nothingFlashesOrMovesWhileASliderIsDragged();
  void optionsAreUndone();
  void comparesTwoMethods();
  void opensFromTheCity();
  void lastGoodResultStays();
  void closes();
  void real_data();
  void real();
};

void StageTest::meshOpensOnTheStageByItself() {
  openPavilion();
  QVERIFY(window_->showsStage());
  auto* tabs = window_->findChild<QTabBar*>(QStringLiteral("centreTabs"));
  QVERIFY(tabs->isVisible());
  QVERIFY2(tabs->tabText(1).contains(QStringLiteral("pavilion")), qPrintable(tabs->tabText(1)));
  QCOMPARE(stage().staged()->mesh->components.size(), 4U);
  QCOMPARE(stage().staged()->classes->contacts.size(), 2U);
  QCOMPARE(stageWindow().components().model().rowCount(), 4);
  keepPicture(*window_, QStringLiteral("stage-pavilion"));
}

void StageTest::meshIsDrawnInTheCityToo() {
  openPavilion();
  window_->findChild<QTabBar*>(QStringLiteral("centreTabs"))->setCurrentIndex(0);
  QVERIFY(!window_->showsStage());
  const Building& building = window_->workspace().state().city->buildings.front();
  QVERIFY(!building.footprint.empty());
  QCOMPARE(building.height, 9.0);
  const QImage with = window_->viewport().grabImage();
  window_->viewport().scene().setLayerStyle(SceneLayer::Buildings, {.visible = false});
  QVERIFY(difference(with, window_->viewport().grabImage()) > 0.02);
}

void StageTest::showsComponentsInTheirColours() {
  openPavilion();
  stageWindow().legend().glyphs(VertexClass::Boundary).setChecked(false);
  const QImage picture = image();
  const auto& colours = scene().look().colours;
  for (std::uint32_t c = 0; c < 4; ++c) {
    const auto at = pixelOf(c);
    QVERIFY2(at, qPrintable(QString::number(c)));
    // Light changes how bright a colour is, much less its hue.
    const QColor seen = picture.pixelColor(*at + QPoint(2, 2));
    const QColor given = QColor::fromRgbF(colours[c][0], colours[c][1], colours[c][2]);
    const int turn = std::abs(seen.hsvHue() - given.hsvHue());
    QVERIFY2(std::min(turn, 360 - turn) < 30, qPrintable(seen.name() + given.name()));
    for (std::uint32_t other = 0; other < c; ++other) QVERIFY(colours[c] != colours[other]);
  }
}

void StageTest::selectsBothWays() {
  openPavilion();
  const auto at = pixelOf(2);
  QVERIFY(at);
  const double ratio = window_->devicePixelRatioF();
  QWidget* surface = stageWindow().view().view().childAt(5, 5);
  QTest::mouseClick(surface, Qt::LeftButton, Qt::NoModifier, (QPointF(*at + QPoint(2, 2)) / ratio).toPoint());
  QCOMPARE(stage().selection(), std::vector<std::uint32_t>{2});
  auto* table = window_->findChild<QTableView*>(QStringLiteral("componentTable"));
  QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
  QCOMPARE(stageWindow().components().model().componentAt(table->currentIndex().row()), 2U);
  const QImage one = image();
  table->selectRow(3);
  QCOMPARE(stage().selection(), std::vector<std::uint32_t>{3});
  QVERIFY(difference(one, image()) > 0.002);
}

void StageTest::isolatesAndGhosts() {
  openPavilion();
  stage().select({1});
  stageWindow().components().isolateButton().click();
  QVERIFY(pixelOf(1));
  QVERIFY(!pixelOf(0));  // ghosts are not picked
  const QImage ghosts = image();
  keepPicture(*window_, QStringLiteral("stage-isolated"));
  BuildingLook look = scene().look();
  look.ghosts = false;
  scene().setLook(look);
  const double lines = difference(ghosts, image());
  QVERIFY2(lines > 0.0005 && lines < 0.2, qPrintable(QString::number(lines)));
  stageWindow().components().isolateButton().click();
  QVERIFY(pixelOf(0));
}

void StageTest::switchesEachClassOfVertices() {
  openPavilion();
  StageLegend& legend = stageWindow().legend();
  for (const VertexClass c : {VertexClass::Boundary, VertexClass::Ordinary}) {
    legend.glyphs(c).setChecked(false);
    const QImage without = image();
    legend.glyphs(c).setChecked(true);
    QVERIFY2(difference(without, image()) > 0.0002, toString(c));
  }
  legend.angles().setChecked(false);
  const QImage without = image();
  legend.angles().setChecked(true);
  QVERIFY(difference(without, image()) > 0.0002);
  QVERIFY(legend.glyphs(VertexClass::Boundary).text().contains(QRegularExpression(QStringLiteral("[1-9]"))));
}

void StageTest::sidesShareTheCamera() {
  openPavilion();
  const QImage picture = image();
  const Vec3 corner(16, 2, 4);
  const auto left = scene().project(0, corner);
  const auto right = scene().project(1, corner);
  QVERIFY(left && right);
  QVERIFY(std::abs(right->x() - left->x() - picture.width() / 2.0) <= 1);
  QVERIFY(std::abs(right->y() - left->y()) < 1e-6);
  Camera camera = stageWindow().view().view().camera();
  camera.eye += Vec3(3, -4, 2);
  stageWindow().view().view().setCamera(camera);
  const auto movedLeft = scene().project(0, corner);
  const auto movedRight = scene().project(1, corner);
  QVERIFY(movedLeft && movedRight && (*movedLeft - *left).norm() > 2);
  QVERIFY(std::abs(movedRight->x() - movedLeft->x() - picture.width() / 2.0) <= 1);
}

void StageTest::chosenCameraStaysWhenPanesChange() {
  openPavilion();
  StageScene& view = stageWindow().view().view();
  const auto corners = [this] {
    std::size_t inside = 0;
    const auto [left, right] = scene().spanOf(scene().panes().front());
    for (const Vec3& corner : {Vec3(0, 0, 1), Vec3(12, 0, 1), Vec3(0, 12, 1), Vec3(20, 6, 4)}) {
      const auto at = scene().project(scene().panes().front(), corner);
      inside += at && at->x() > left && at->x() < right ? 1U : 0U;
    }
    return inside;
  };
  QGroupBox& compare = stageWindow().method().compareBox();
  compare.setChecked(true);
  QCOMPARE(corners(), std::size_t{4});  // nobody chose a view yet: all of it stays in sight
  compare.setChecked(false);

  Camera chosen = view.camera();
  chosen.eye += Vec3(3, -4, 2);
  view.setCamera(chosen);
  const auto stays = [&] { return view.camera().eye == chosen.eye && view.camera().target == chosen.target; };
  compare.setChecked(true);
  QVERIFY(stays());
  for (const int layout : {0, 2, 1}) {
    stageWindow().layoutAction(layout)->trigger();
    QVERIFY(stays());
  }
  compare.setChecked(false);
  QVERIFY(stays());
}

void StageTest::wipesBetweenOriginalAndSimplified() {
  openPavilion();
  stageWindow().layoutAction(0)->trigger();
  const QImage original = image();
  stageWindow().layoutAction(2)->trigger();
  auto* line = window_->findChild<QWidget*>(QStringLiteral("wipeLine"));
  QVERIFY(line->isVisible());
  const QImage wiped = image();
  const int middle = wiped.width() / 2;
  const QRect left(0, 0, middle - 4, wiped.height());
  QVERIFY(difference(original.copy(left), wiped.copy(left)) < 0.002);  // the same picture, parted
  keepPicture(*window_, QStringLiteral("stage-wipe"));
  QTest::keyClick(line, Qt::Key_Right);
  QVERIFY(scene().wipe() > 0.5);
  stageWindow().view().setWipe(0.98);
  const QRect most(0, 0, static_cast<int>(0.95 * wiped.width()), wiped.height());
  QVERIFY(difference(original.copy(most), image().copy(most)) < 0.002);
}

void StageTest::slidersSimplifyLive() {
  openPavilion();
  const std::uint32_t all = stage().staged()->mesh->triangleCount();
  QSlider& rate = stageWindow().method().form(Stage::A).rate().slider();
  for (const int position : {60, 160}) {
    rate.setValue(position);
    const double wanted = rate.value() / 200.0;
    QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A)->options.rate == wanted, kLong);
    const double removed = all - stage().level(Stage::A)->simplified->mesh.triangleCount();
    QVERIFY2(removed >= wanted * all - 1e-9, qPrintable(QString::number(removed)));
    QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A)->report.has_value(), kLong);
  }
  const auto* measures = window_->findChild<QTableWidget*>(QStringLiteral("measures"));
  QCOMPARE(measures->item(0, 0)->text(), QLocale().toString(all));
  QCOMPARE(measures->item(0, 1)->text(),
           QLocale().toString(stage().level(Stage::A)->simplified->mesh.triangleCount()));
}

void StageTest::nothingFlashesOrMovesWhileASliderIsDragged() {
  struct Shows : QObject {
    int count = 0;
    bool eventFilter(QObject*, QEvent* event) override {
      count += event->type() == QEvent::Show ? 1 : 0;
      return false;
    }
  } shows;
  openPavilion();
  SimplifyPanel& panel = stageWindow().method();
  panel.runButton().installEventFilter(&shows);
  panel.compareBox().setChecked(true);
  QSlider& rate = panel.form(Stage::A).rate().slider();
  for (int position = 20; position < 180; position += 8) {
    rate.setValue(position);
    QTest::qWait(position % 3 == 0 ? 150 : 10);  // stopping now and then, as people do
  }
  QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::B) && stage().level(Stage::B)->report, kLong);
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A), kLong);
  QCOMPARE(shows.count, 0);

  // Somebody who stops it needs the button; it comes without moving anything.
  const QPoint before = rate.mapTo(&panel, QPoint());
  rate.setValue(30);
  stage().compute();
  stage().cancel();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  QVERIFY(panel.runButton().isVisible());
  QTest::qWait(20);
  QCOMPARE(rate.mapTo(&panel, QPoint()), before);
}

void StageTest::optionsAreUndone() {
  openPavilion();
  const SimplifyOptions before = stage().options(Stage::A);
  stageWindow().method().form(Stage::A).a().slider().setValue(150);
  QVERIFY(stage().options(Stage::A).a != before.a);
  window_->workspace().session().undo();
  QCOMPARE(stage().options(Stage::A).a, before.a);
  QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A)->options == before, kLong);
  QVERIFY(stage().isOpen());
}

void StageTest::comparesTwoMethods() {
  openPavilion();
  stageWindow().method().compareBox().setChecked(true);
  QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::B) && stage().level(Stage::B)->report, kLong);
  QCOMPARE(stage().level(Stage::B)->options.method, SimplifyMethod::Qem);
  QCOMPARE(scene().panes().size(), 3U);
  const auto* measures = window_->findChild<QTableWidget*>(QStringLiteral("measures"));
  QVERIFY(!measures->isColumnHidden(2));
  QVERIFY(measures->item(0, 2));
  QVERIFY(pixelOf(0, 2));
  keepPicture(*window_, QStringLiteral("stage-compared"));
  stageWindow().layoutAction(2)->trigger();
  QCOMPARE(scene().panes(), (std::vector<std::size_t>{1, 2}));
}

void StageTest::opensFromTheCity() {
  window_->workspace().openSample();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy() && window_->workspace().state().tree, kLong);
  QVERIFY(!window_->showsStage());
  auto* simplify = window_->findChild<QAction*>(QStringLiteral("simplifyBuilding"));
  simplify->trigger();
  QVERIFY(!window_->showsStage());
  QVERIFY2(window_->statusBar()->currentMessage().contains(QStringLiteral("Select a building")),
           "what to do first");
  window_->workspace().select({7});
  QVERIFY(window_->objects().table().actions().contains(simplify));
  simplify->trigger();
  QVERIFY(window_->showsStage());
  QCOMPARE(window_->statusBar()->currentMessage(), QString());
  QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
  const auto& buildings = stage().staged()->buildings;
  QVERIFY(std::find(buildings.begin(), buildings.end(), 7U) != buildings.end());
}

void StageTest::lastGoodResultStays() {
  openPavilion();
  const auto before = stage().level(Stage::A)->simplified;
  SimplifyOptions options = stage().options(Stage::A);
  options.rate = 0.25;
  stage().setOptions(Stage::A, options, QStringLiteral("test"));
  stage().compute();
  stage().cancel();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  QCOMPARE(stage().level(Stage::A)->simplified, before);
  QVERIFY(stage().isOutdated(Stage::A));
  QVERIFY(stageWindow().method().runButton().isVisible());
  stageWindow().method().runButton().click();
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isOutdated(Stage::A), kLong);
}

void StageTest::closes() {
  openPavilion();
  auto* tabs = window_->findChild<QTabBar*>(QStringLiteral("centreTabs"));
  qobject_cast<QToolButton*>(tabs->tabButton(1, QTabBar::RightSide))->click();
  QVERIFY(!window_->showsStage());
  QVERIFY(!tabs->isVisible());
  QVERIFY(window_->objects().isVisible());  // the docks came back
  window_->workspace().close();
  openPavilion();
  window_->workspace().close();
  QVERIFY(!stage().isOpen());
  QVERIFY(!window_->showsStage());
}

void StageTest::real_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<std::size_t>("components");
  const auto row = [](const char* name, const char* file, std::size_t components) {
    QTest::newRow(name) << QString::fromLatin1(file) << components;
  };
  row("temple", "han_china_0ad/meshes/structural/han_temple.dae", 91);
  row("apartment", "gazebo_buildings/apartment/meshes/apartment.dae", 339);
  if (!qEnvironmentVariableIsSet("LODESTONE_LONG")) return;
  row("fzk", "ifc_to_obj_derived/AC14-FZK-Haus.obj", 382);
  row("duplex", "ifc_to_obj_derived/Ifc2x3_Duplex_Architecture.obj", 531);
}

void StageTest::real() {
  QFETCH(QString, file);
  QFETCH(std::size_t, components);
  const QString given = qEnvironmentVariable("LODESTONE_SHARED");
  const QString root = given.isEmpty() ? QStringLiteral(LODESTONE_SHARED_DATA) : given;
  const QString path = QDir(root).filePath(QStringLiteral("data/D_meshes/") + file);
  if (!QFile::exists(path)) QSKIP("the shared data is not here");
  open(path);
  QCOMPARE(stage().staged()->mesh->components.size(), components);
  QVERIFY(stage().staged()->classes->contacts.size() > components / 2);
  keepPicture(*window_, QStringLiteral("stage-") + QString::fromLatin1(QTest::currentDataTag()));
  const auto* table = window_->findChild<QTableView*>(QStringLiteral("componentTable"));
  QVERIFY(table->horizontalHeader()->length() <= table->viewport()->width());
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::StageTest>(argc, argv);
}

#include "stage_test.moc"
