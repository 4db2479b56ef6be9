// The docks beside the stage: contacts, the choice of a, vertices, exports, and the room that they take.
#include <QCheckBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>

#include "algorithms/simplification/measured_simplification.h"
#include "algorithms/simplification/vertex_account.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/simplification/auto_curve.h"
#include "gui/simplification/components_panel.h"
#include "gui/simplification/simplify_form.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_legend.h"
#include "gui/widgets/field_slider.h"
#include "gui/widgets/parameter_panel.h"
#include "tests/gui/stage_support.h"

namespace lodestone {
namespace {

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

class StageDocksTest : public StageFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { writePavilion(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void aLargeModelSaysWhatItWaitsFor();
  void listsAndMarksBrokenContacts();
  void findsAAndShowsWhy();
  void pickedVertexTellsWhy();
  void exportsWhatIsShown();
  void windowStaysAsItIsWhenAnotherIsOpened();
  void resetLayoutLeavesNothingBehind();
  void componentsShowAllTheirColumns();
  void tablesShowWhatTheyHold_data();
  void tablesShowWhatTheyHold();
};

void StageDocksTest::aLargeModelSaysWhatItWaitsFor() {
  ObjFile block;
  block.group("block");
  block.box({0, 0, 0}, {8, 8, 8}, 70);  // 58,800 triangles
  const QString path = folder_.filePath(QStringLiteral("large.obj"));
  block.write(path);
  window_->openFiles({path}, false);
  QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen() && !window_->workspace().tasks().busy(), kLong);
  QVERIFY(!stage().isLive() && !stage().level(Stage::A));
  const auto says = [&](const QString& text) {
    const auto labels = stageWindow().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->isVisible() && label->text().contains(text);
    });
  };
  QVERIFY(says(QStringLiteral("press Simplify")));
  QVERIFY(says(QStringLiteral("Nothing is simplified yet.")));
  QVERIFY(!says(QStringLiteral("being measured")));
}

void StageDocksTest::listsAndMarksBrokenContacts() {
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

void StageDocksTest::findsAAndShowsWhy() {
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

void StageDocksTest::pickedVertexTellsWhy() {
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

void StageDocksTest::exportsWhatIsShown() {
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

void StageDocksTest::windowStaysAsItIsWhenAnotherIsOpened() {
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

void StageDocksTest::resetLayoutLeavesNothingBehind() {
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

void StageDocksTest::componentsShowAllTheirColumns() {
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

void StageDocksTest::tablesShowWhatTheyHold_data() {
  QTest::addColumn<QSize>("size");
  QTest::newRow("1280") << QSize(1280, 800);
  QTest::newRow("1440") << QSize(1440, 900);
}

void StageDocksTest::tablesShowWhatTheyHold() {
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

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::StageDocksTest>(argc, argv);
}

#include "stage_docks_test.moc"
