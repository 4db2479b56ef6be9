// The stage of one building in the real window: components, classes, live simplification, comparison,
// contacts. What is drawn is looked at pixel by pixel.
#include <QAction>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>
#include <fstream>

#include "algorithms/simplification/measured_simplification.h"
#include "algorithms/simplification/vertex_account.h"
#include "gui/city/objects_panel.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/simplification/auto_curve.h"
#include "gui/simplification/components_panel.h"
#include "gui/simplification/simplify_form.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_legend.h"
#include "gui/simplification/stage_view.h"
#include "gui/simplification/stage_window.h"
#include "gui/widgets/field_slider.h"
#include "gui/widgets/parameter_panel.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {
namespace {

/// Groups of an OBJ file, z up.
class ObjFile {
 public:
  void group(const std::string& name) { text_ += "g " + name + "\n"; }
  /// A box whose faces are `n` × `n` quads.
  void box(const Vec3& low, const Vec3& high, int n = 1) {
    for (int axis = 0; axis < 3; ++axis) {
      side(low, high, axis, false, n);
      side(low, high, axis, true, n);
    }
  }
  void write(const QString& path) const { std::ofstream(path.toStdString()) << text_; }

 private:
  void side(const Vec3& low, const Vec3& high, int axis, bool top, int n) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto at = [&](int i, int j) {
      Vec3 p = top ? high : low;
      p[u] = low[u] + (high[u] - low[u]) * i / n;
      p[v] = low[v] + (high[v] - low[v]) * j / n;
      return p;
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const std::array<Vec3, 4> face{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        for (const Vec3& p : face) {
          text_ += "v " + std::to_string(p.x()) + " " + std::to_string(p.z()) + " " + std::to_string(-p.y()) +
                   "\n";
          ++vertices_;  // the file's y is up
        }
        text_ += "f";
        for (int k = 0; k < 4; ++k) text_ += " " + std::to_string(vertices_ - (top ? 3 - k : k));
        text_ += "\n";
      }
    }
  }

  std::string text_;
  int vertices_ = 0;
};

/// Share of pixels that differ clearly.
double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return 1;
  std::size_t differ = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int far =
          std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
      differ += far > 30 ? 1U : 0U;
    }
  }
  return static_cast<double>(differ) / (static_cast<double>(a.width()) * a.height());
}

/// The texts of a column that are cut off.
QStringList cutIn(QAbstractItemView& view, int column, const QModelIndex& parent = {}) {
  QStringList cut;
  for (int row = 0; row < view.model()->rowCount(parent); ++row) {
    const QModelIndex at = view.model()->index(row, column, parent);
    view.scrollTo(at);
    if (view.sizeHintForIndex(at).width() > view.visualRect(at).width()) cut << at.data().toString();
    cut += cutIn(view, column, view.model()->index(row, 0, parent));
  }
  return cut;
}

}  // namespace

class StageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
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
  void listsAndMarksBrokenContacts();
  void findsAAndShowsWhy();
  void pickedVertexTellsWhy();
  void opensFromTheCity();
  void exportsWhatIsShown();
  void lastGoodResultStays();
  void closes();
  void windowStaysAsItIsWhenAnotherIsOpened();
  void resetLayoutLeavesNothingBehind();
  void componentsShowAllTheirColumns();
  void tablesShowWhatTheyHold_data();
  void tablesShowWhatTheyHold();
  void real_data();
  void real();

 private:
  [[nodiscard]] StageWindow& stageWindow() { return window_->stage(); }
  [[nodiscard]] Stage& stage() { return window_->stage().stage(); }
  [[nodiscard]] BuildingScene& scene() { return stageWindow().view().scene(); }
  [[nodiscard]] QImage image() { return stageWindow().view().view().grabImage(); }
  void open(const QString& path) {
    window_->openFiles({path}, false);
    QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
    QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A) && stage().level(Stage::A)->report, kLong);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  }
  void openPavilion() { open(folder_.filePath(QStringLiteral("pavilion.obj"))); }
  /// A pixel at which a component is seen in a pane.
  [[nodiscard]] std::optional<QPoint> pixelOf(std::uint32_t component, std::size_t pane = 0);

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

/// A slab, a column that stands on it, one through it, and a block that touches nothing.
void StageTest::initTestCase() {
  ObjFile pavilion;
  pavilion.group("slab");
  pavilion.box({0, 0, 0}, {12, 12, 1}, 4);
  pavilion.group("standing");
  pavilion.box({2, 2, 1}, {4, 4, 6}, 3);
  pavilion.group("through");
  pavilion.box({8, 8, -2}, {10, 10, 7}, 3);
  pavilion.group("apart");
  pavilion.box({16, 2, 0}, {20, 6, 4}, 3);
  pavilion.write(folder_.filePath(QStringLiteral("pavilion.obj")));
}

void StageTest::init() {
  window_ = makeWindow();
  window_->useDefaultLayout();
}

std::optional<QPoint> StageTest::pixelOf(std::uint32_t component, std::size_t pane) {
  const QSize size = image().size();
  for (int y = 0; y < size.height(); y += 4) {
    for (int x = 0; x < size.width(); x += 4) {
      const auto part = scene().pick(x + 0.5, y + 0.5);
      const auto beside = scene().pick(x + 3.5, y + 2.5);
      if (part && beside && part->pane == pane && part->component == component &&
          beside->component == component)
        return QPoint(x, y);
    }
  }
  return {};
}

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

void StageTest::listsAndMarksBrokenContacts() {
  openPavilion();
  SimplifyOptions options = stage().options(Stage::A);
  options.rate = 0.99;  // fewer triangles than components need
  options.method = SimplifyMethod::Qem;
  stage().setOptions(Stage::A, options, QStringLiteral("test"));
  QTRY_VERIFY_WITH_TIMEOUT(
      stage().level(Stage::A)->options == options && stage().level(Stage::A)->report.has_value(), kLong);
  const SimplifyReport& report = *stage().level(Stage::A)->report;
  const auto broken = report.count(ContactFate::Separated) + report.count(ContactFate::Lost);
  QVERIFY(broken > 0);
  auto* table = window_->findChild<QTableWidget*>(QStringLiteral("contacts"));
  QCOMPARE(table->rowCount(), static_cast<int>(broken));
  const Camera before = stageWindow().view().view().camera();
  table->selectRow(0);
  QVERIFY(stage().contact());
  QCOMPARE(stage().selection().size(), 2U);
  Q_EMIT table->itemActivated(table->item(0, 0));
  QVERIFY(!(stageWindow().view().view().camera() == before));
  const Vec3 at = report.contacts[*stage().contact()].at;
  const auto seen = scene().project(0, at);
  QVERIFY(seen);
  const auto [left, right] = scene().spanOf(0);
  QVERIFY(std::abs(seen->x() - (left + right) / 2) < (right - left) / 4);
}

void StageTest::findsAAndShowsWhy() {
  openPavilion();
  auto* curve = window_->findChild<AutoCurve*>();
  qobject_cast<QDockWidget*>(curve->parentWidget())->raise();
  const QImage hint = curve->grab().toImage();
  qobject_cast<QCheckBox*>(stageWindow().method().form(Stage::A).fields().editor("a-auto"))->click();
  QVERIFY(stage().options(Stage::A).aAuto);
  QTRY_VERIFY_WITH_TIMEOUT(!stage().level(Stage::A)->trials.empty() && stage().level(Stage::A)->report,
                           kLong);
  const std::vector<AutoTrial> trials = stage().level(Stage::A)->trials;
  QCOMPARE(stage().level(Stage::A)->a, trials[bestTrial(trials)].a);
  QVERIFY(difference(hint, curve->grab().toImage()) > 0.02);
  keepPicture(*window_, QStringLiteral("stage-auto"));
  QVERIFY(!stageWindow().method().form(Stage::A).a().isEnabled());
  QTest::mouseClick(curve, Qt::LeftButton, Qt::NoModifier, curve->placeOf(trials.back()).toPoint());
  QCOMPARE(stage().options(Stage::A).a, trials.back().a);
  QVERIFY(!stage().options(Stage::A).aAuto);
}

void StageTest::pickedVertexTellsWhy() {
  openPavilion();
  const auto& classes = stage().staged()->classes->vertices;
  const auto found = std::find(classes.begin(), classes.end(), VertexClass::Boundary);
  QVERIFY(found != classes.end());
  const auto vertex = static_cast<std::uint32_t>(found - classes.begin());
  const QImage before = image();
  stage().pickVertex(vertex);
  auto* tree = window_->findChild<QTreeWidget*>(QStringLiteral("vertexTree"));
  QVERIFY(tree->topLevelItemCount() >= 3);
  QVERIFY(tree->topLevelItem(0)->childCount() > 0);
  QVERIFY(tree->topLevelItem(1)->text(0).contains(
      QString::number(stage().staged()->classes->planeCount(vertex))));
  keepPicture(*window_, QStringLiteral("stage-vertex"));
  QVERIFY(difference(before, image()) > 0.0001);  // it is ringed, and its planes are outlined
  const auto costs = [&] {
    QStringList texts;
    const QTreeWidgetItem* moves = tree->topLevelItem(tree->topLevelItemCount() - 2);
    for (int i = 0; i < moves->childCount(); ++i) texts << moves->child(i)->text(2);
    return texts;
  };
  SimplifyOptions options = stage().options(Stage::A);
  const auto hasCost = [&](const MoveCost& move) { return move.cost > 0 && !std::isinf(move.cost); };
  for (std::uint32_t v = 0; v < classes.size(); ++v) {  // one whose costs a can change
    const StagedBuilding& staged = *stage().staged();
    const auto moves = accountOf(*staged.mesh, *staged.classes, options, v).moves;
    if (classes[v] == VertexClass::Boundary && std::any_of(moves.begin(), moves.end(), hasCost))
      stage().pickVertex(v);
  }
  const QStringList cheap = costs();
  options.a *= 2;
  stage().setOptions(Stage::A, options, QStringLiteral("a"));
  QVERIFY(!cheap.isEmpty() && costs() != cheap);
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

void StageTest::exportsWhatIsShown() {
  openPavilion();
  QSignalSpy exported(&window_->workspace(), &Workspace::exported);
  QTimer::singleShot(0, window_.get(), [this] {
    auto* dialog = window_->findChild<ExportDialog*>();
    dialog->findChild<QLineEdit*>(QStringLiteral("folder"))->setText(folder_.path());
    dialog->findChild<QLineEdit*>(QStringLiteral("name"))->setText(QStringLiteral("small"));
    auto* formats = dialog->findChild<QListWidget*>(QStringLiteral("formats"));
    for (int i = 0; i < formats->count(); ++i) {
      const bool obj = formats->item(i)->data(Qt::UserRole).toString() == QStringLiteral("obj");
      formats->item(i)->setCheckState(obj ? Qt::Checked : Qt::Unchecked);
    }
    dialog->accept();
  });
  stageWindow().method().exportButton().click();
  QTRY_COMPARE_WITH_TIMEOUT(exported.size(), 1, kLong);
  std::ifstream file(folder_.filePath(QStringLiteral("small.obj")).toStdString());
  std::uint32_t faces = 0;
  for (std::string line; std::getline(file, line);) faces += line.rfind("f ", 0) == 0 ? 1 : 0;
  QCOMPARE(faces, stage().level(Stage::A)->simplified->mesh.triangleCount());
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

void StageTest::windowStaysAsItIsWhenAnotherIsOpened() {
  const auto widths = [](const QList<QDockWidget*>& docks) {
    QList<int> all;
    for (const QDockWidget* dock : docks) all << dock->width();
    return all;
  };
  const auto* layers = window_->findChild<QDockWidget*>(QStringLiteral("layersDock"));
  const auto* method = window_->findChild<QDockWidget*>(QStringLiteral("methodDock"));
  auto* tabs = window_->findChild<QTabBar*>(QStringLiteral("centreTabs"));
  for (const QSize size : {QSize(1440, 900), QSize(1280, 800)}) {
    window_->resize(size);
    QTest::qWait(50);
    const std::pair city(layers->width(), method->width());
    openPavilion();
    QTest::qWait(50);
    QCOMPARE(window_->size(), size);
    const QList<int> before = widths(stageWindow().docks());
    for (int i = 0; i < 3; ++i) {
      openPavilion();
      QTest::qWait(50);  // sizes travel up one layout at a time
      QCOMPARE(window_->size(), size);
      QCOMPARE(widths(stageWindow().docks()), before);
      QVERIFY(
          window_->rect().contains(stageWindow().mapTo(window_.get(), stageWindow().rect().bottomRight())));
    }
    tabs->setCurrentIndex(0);
    QTest::qWait(50);
    QCOMPARE(window_->size(), size);
    QCOMPARE(std::pair(layers->width(), method->width()), city);
    window_->workspace().close();
  }
}

void StageTest::resetLayoutLeavesNothingBehind() {
  openPavilion();
  for (int i = 0; i < 3; ++i) {
    window_->resize(1280 + 80 * i, 800);
    window_->useDefaultLayout();
    QTest::qWait(50);
    int shown = 0;
    for (const QTabBar* bar : stageWindow().findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
      shown += bar->isVisible() ? 1 : 0;
    QCOMPARE(shown, 2);  // Components and Visibility, Contacts and Choice of a
  }
}

void StageTest::componentsShowAllTheirColumns() {
  const QString path = folder_.filePath(QStringLiteral("colonnade.obj"));
  ObjFile colonnade;
  for (int i = 0; i < 120; ++i) {
    colonnade.group("a column of many " + std::to_string(i));
    colonnade.box({3.0 * i, 0, 0}, {3.0 * i + 1, 1, 5}, i == 7 ? 12 : 1);
  }
  colonnade.write(path);
  open(path);
  QTest::qWait(20);
  auto* table = window_->findChild<QTableView*>(QStringLiteral("componentTable"));
  for (const int sorted :
       {-1, static_cast<int>(ComponentTable::Triangles), static_cast<int>(ComponentTable::Hole)}) {
    table->sortByColumn(sorted, Qt::DescendingOrder);
    QTest::qWait(20);
    QVERIFY(table->horizontalHeader()->length() <= table->viewport()->width());
    for (const auto column : {ComponentTable::Number, ComponentTable::Triangles, ComponentTable::Boundary,
                              ComponentTable::Hole, ComponentTable::Ordinary})
      QCOMPARE(cutIn(*table, column), QStringList());
    QVERIFY(table->columnWidth(ComponentTable::Source) >= 50);
  }
  keepPicture(*window_, QStringLiteral("stage-components"));
}

void StageTest::tablesShowWhatTheyHold_data() {
  QTest::addColumn<QSize>("size");
  QTest::newRow("1280") << QSize(1280, 800);
  QTest::newRow("1440") << QSize(1440, 900);
}

void StageTest::tablesShowWhatTheyHold() {
  QFETCH(QSize, size);
  window_->resize(size);
  openPavilion();
  SimplifyOptions options = stage().options(Stage::B);
  options.rate = 0.99;
  stage().setOptions(Stage::B, options, QStringLiteral("test"));
  stageWindow().method().compareBox().setChecked(true);
  const auto& classes = stage().staged()->classes->vertices;
  stage().pickVertex(static_cast<std::uint32_t>(
      std::find(classes.begin(), classes.end(), VertexClass::Boundary) - classes.begin()));
  QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::B) && stage().level(Stage::B)->report, kLong);
  QTest::qWait(50);
  keepPicture(*window_, QStringLiteral("stage-tables-%1").arg(size.width()));

  auto* contacts = window_->findChild<QTableWidget*>(QStringLiteral("contacts"));
  QVERIFY(contacts->rowCount() > 0);
  for (const int column : {0, 1, 2, 3}) QCOMPARE(cutIn(*contacts, column), QStringList());
  // The widest that there are, next to a scroll bar.
  contacts->item(0, 3)->setText(QStringLiteral("0.868 mm apart"));
  contacts->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  QTest::qWait(20);
  QCOMPARE(cutIn(*contacts, 3), QStringList());

  auto* vertex = window_->findChild<QTreeWidget*>(QStringLiteral("vertexTree"));
  for (const int column : {1, 2}) QCOMPARE(cutIn(*vertex, column), QStringList());
  const auto* measures = window_->findChild<QTableWidget*>(QStringLiteral("measures"));
  QVERIFY(measures->columnWidth(2) >= measures->horizontalHeader()->sectionSizeHint(2));
  const StageLegend& legend = stageWindow().legend();
  for (const QToolButton* button : legend.findChildren<QToolButton*>())
    QVERIFY2(legend.rect().contains(button->geometry()), qPrintable(button->text()));
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
