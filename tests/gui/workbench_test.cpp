// The real window, driven by mouse and keys: import, cluster, move the cut, select, undo, cancel.
#include <QCommandLinkButton>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTableView>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <set>

#include "algorithms/merging/cutting.h"
#include "algorithms/synthesis/synthesis.h"
#include "gui/city/dendrogram_view.h"
#include "gui/city/method_panel.h"
#include "gui/city/objects_panel.h"
#include "gui/widgets/field_slider.h"
#include "gui/workspace/jobs.h"
#include "model/io/format.h"
#include "tests/gui/sample_support.h"

namespace lodestone {
namespace {

/// Share of pixels that differ by more than `tolerance` in any channel.
double difference(const QImage& a, const QImage& b, int tolerance = 12) {
  if (a.size() != b.size() || a.isNull()) return 1;
  std::size_t differ = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int most = std::max(
          {std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
      if (most > tolerance) ++differ;
    }
  }
  return static_cast<double>(differ) / (static_cast<double>(a.width()) * a.height());
}

std::size_t coloursIn(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 3) {
    for (int x = 0; x < image.width(); x += 3) colours.insert(image.pixel(x, y) & 0xf8f8f8U);
  }
  return colours.size();
}

/// QTest::mouseMove() on a widget sets the cursor, which stops at the edge of the screen; a window may be
/// larger than that.
void moveMouse(QWidget& widget, const QPoint& to) {
  QWidget* window = widget.window();
  QTest::mouseMove(window->windowHandle(), widget.mapTo(window, to));
  QCoreApplication::processEvents();
}

}  // namespace

class WorkbenchTest : public WorkbenchFixture {
  Q_OBJECT

 private Q_SLOTS:
  void init() { window_ = makeWindow(); }
  void cleanup() { window_.reset(); }
  void opensTheSampleFromTheStartPage();
  void pixelsAreThoseOfTheToolkit();
  void slidersChangeWhatIsDrawn();
  void theLineOfTheDendrogramCuts();
  void selectionGoesBothWays();
  void filtersAndSortsObjects();
  void idsOfObjectsDiffer();
  void startPageNamesWhatCanBeOpened();
  void hoverIsLinked();
  void undoTakesStepsBack();
  void clusteringCanBeCancelled();
  void keyboardReachesTheMainJob();
  void changedBarriersOutdateTheTree();
};

void WorkbenchTest::opensTheSampleFromTheStartPage() {
  auto* button = find<QPushButton>("sampleButton");
  QVERIFY(button && button->isVisible());
  QTest::mouseClick(button, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
  const std::size_t buildings = workspace().state().city->buildings.size();
  QVERIFY(buildings >= 300);
  QCOMPARE(window_->objects().model().rowCount(), static_cast<int>(buildings));
  QVERIFY(window_->viewport().isVisible());
  QVERIFY2(window_->viewport().isValid(), qPrintable(window_->viewport().problem()));
  QVERIFY(coloursIn(window_->viewport().grabImage()) > 20);
  QVERIFY(find<QLabel>("polygonCount")->text() != QStringLiteral("–"));
}

// ε and α are pixels of the toolkit: a display with more of its own draws the same, only finer.
void WorkbenchTest::pixelsAreThoseOfTheToolkit() {
  openSample();
  const Camera& camera = workspace().camera();
  QCOMPARE(QSize(camera.width, camera.height), window_->viewport().size());
  QVERIFY(workspace().cut()->drawn == makeCut(*workspace().state().tree, {}, camera).drawn);
  const QImage picture = window_->viewport().grabImage();
  QCOMPARE(picture.width(), qRound(camera.width * window_->devicePixelRatioF()));
}

void WorkbenchTest::slidersChangeWhatIsDrawn() {
  openSample();
  QSlider& slider = window_->method().epsilon().slider();
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_Home);
  const QImage fine = window_->viewport().grabImage();
  const std::uint64_t many = workspace().facesDrawn().polygons;
  QTest::keyClick(&slider, Qt::Key_End);
  const QImage coarse = window_->viewport().grabImage();
  QVERIFY(workspace().facesDrawn().polygons < many);
  QVERIFY(difference(fine, coarse) > 0.005);
  QSlider& alpha = window_->method().alpha().slider();
  alpha.setFocus();
  QTest::keyClick(&alpha, Qt::Key_End);
  const std::size_t noLandmarks = workspace().cut()->drawn.size();
  QTest::keyClick(&alpha, Qt::Key_Home);
  QVERIFY(workspace().cut()->drawn.size() > noLandmarks);
}

void WorkbenchTest::theLineOfTheDendrogramCuts() {
  openSample();
  DendrogramView& view = window_->dendrogram();
  const QPoint line = view.linePosition();
  QTest::mousePress(&view, Qt::LeftButton, {}, line);
  QTest::mouseMove(&view, line + QPoint(0, 25));
  QTest::mouseRelease(&view, Qt::LeftButton, {}, line + QPoint(0, 25));
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Weight);
  const ClusterTree& tree = *workspace().state().tree;
  const std::vector<NodeId> expected = nodesAtWeight(tree, workspace().state().cutChoice.value);
  QCOMPARE(workspace().cut()->drawn.size(), expected.size());
  const QImage low = window_->viewport().grabImage();
  const QImage treeLow = view.grab().toImage();
  const QPoint lower = view.linePosition();
  QTest::mousePress(&view, Qt::LeftButton, {}, lower);
  QTest::mouseMove(&view, QPoint(lower.x(), 12));
  QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(lower.x(), 12));
  QVERIFY(workspace().cut()->drawn.size() < expected.size());
  QVERIFY(difference(low, window_->viewport().grabImage()) > 0.005);
  QVERIFY(difference(treeLow, view.grab().toImage()) > 0.005);
  workspace().session().undo();
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Camera);
  workspace().session().redo();
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Weight);
}

void WorkbenchTest::selectionGoesBothWays() {
  openSample();
  workspace().setCutChoice({CutMode::Original, 0});
  const QImage before = window_->viewport().grabImage();
  QTableView& table = window_->objects().table();
  table.selectRow(10);
  QCOMPARE(workspace().selection(), std::vector<NodeId>{window_->objects().model().buildingAt(10)});
  QCOMPARE(window_->viewport().scene().selection(), workspace().selection());
  const QImage after = window_->viewport().grabImage();
  QVERIFY(difference(before, after) > 0);
  workspace().flyTo(workspace().selection().front());
  QVERIFY(difference(after, window_->viewport().grabImage()) > 0.05);
  // The building flown to is in the middle: a click there picks it, and its row is the selected one.
  workspace().select({});
  QVERIFY(table.selectionModel()->selectedRows().isEmpty());
  QTest::mouseClick(window_->viewport().childAt(window_->viewport().rect().center())
                        ? window_->viewport().childAt(window_->viewport().rect().center())
                        : &window_->viewport(),
                    Qt::LeftButton, {}, window_->viewport().rect().center());
  QTRY_COMPARE(workspace().selection().size(), std::size_t{1});
  QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
  QCOMPARE(window_->objects().model().buildingAt(table.selectionModel()->selectedRows().front().row()),
           workspace().selection().front());
}

void WorkbenchTest::filtersAndSortsObjects() {
  openSample();
  BuildingTable& model = window_->objects().model();
  const int all = model.rowCount();
  model.sort(BuildingTable::Height, Qt::DescendingOrder);
  const auto& buildings = workspace().state().city->buildings;
  for (int row = 1; row < all; ++row)
    QVERIFY(buildings[model.buildingAt(row - 1)].height >= buildings[model.buildingAt(row)].height);
  const std::string id = buildings[model.buildingAt(3)].object.id;
  model.setFilter(QString::fromStdString(id).toUpper());
  QVERIFY(model.rowCount() >= 1 && model.rowCount() < all);
  for (int row = 0; row < model.rowCount(); ++row) QCOMPARE(model.rowOf(model.buildingAt(row)), row);
  model.setFilter({});
  QCOMPARE(model.rowCount(), all);
}

void WorkbenchTest::idsOfObjectsDiffer() {
  const auto* table = find<QTableView>("objectTable");
  const auto shown = [&](const QString& id) {
    return table->fontMetrics().elidedText(id, table->textElideMode(),
                                           table->columnWidth(BuildingTable::Id) - 6);
  };
  QVERIFY(shown(QStringLiteral("BLDG_0003000b0017d5dc")) != shown(QStringLiteral("BLDG_0003000b0017d5e1")));
  openSample();
  const BuildingTable& model = window_->objects().model();
  QCOMPARE(model.data(model.index(0, BuildingTable::Id), Qt::ToolTipRole),
           model.data(model.index(0, BuildingTable::Id), Qt::DisplayRole));
}

void WorkbenchTest::startPageNamesWhatCanBeOpened() {
  static const QRegularExpression notLetters(QStringLiteral("[^A-Za-z]+"));
  const QStringList words =
      find<QCommandLinkButton>("openButton")->description().split(notLetters, Qt::SkipEmptyParts);
  for (const Format& format : formats()) {
    const QString title = QString::fromUtf8(format.title.data(), static_cast<qsizetype>(format.title.size()));
    const bool named = std::any_of(words.begin(), words.end(), [&](const QString& word) {
      return title.contains(word, Qt::CaseInsensitive);
    });
    QVERIFY2(named || !format.read, qPrintable(title));
  }
}

void WorkbenchTest::hoverIsLinked() {
  openSample();
  DendrogramView& view = window_->dendrogram();
  const NodeId root = workspace().state().tree->dendrogram->root();
  moveMouse(view, view.positionOf(root) + QPoint(0, 4));
  QVERIFY(workspace().hover() != kNoNode);
  QCOMPARE(window_->viewport().scene().hover(), workspace().hover());
}

void WorkbenchTest::undoTakesStepsBack() {
  openSample();
  QVERIFY(workspace().session().canUndo());
  workspace().session().undo();
  QVERIFY(!workspace().state().tree);
  QVERIFY(workspace().state().city);
  workspace().session().undo();
  QVERIFY(!workspace().state().city);
  QVERIFY(!window_->viewport().isVisible());
  workspace().session().redo();
  workspace().session().redo();
  QVERIFY(workspace().state().tree);
  QVERIFY(workspace().cut());
}

void WorkbenchTest::clusteringCanBeCancelled() {
  SynthOptions options;
  options.preset = CityPreset::Charlotte;
  options.buildings = 40000;
  ProjectState state;
  state.city = std::make_shared<const CityModel>(synthesiseCity(options));
  workspace().session().commit(std::move(state), "test");
  QPushButton& run = window_->method().runButton();
  QTest::mouseClick(&run, Qt::LeftButton);
  QVERIFY(workspace().tasks().busy(Workspace::clusterTask()));
  auto* cancel = find<QToolButton>("cancel");
  QVERIFY(cancel->isVisible());
  QTest::mouseClick(cancel, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);
  QVERIFY(!workspace().state().tree);
  QVERIFY(said(*window_, Code::Cancelled));
  QVERIFY(!cancel->isVisible());
}

void WorkbenchTest::keyboardReachesTheMainJob() {
  openSample();
  workspace().session().undo();
  QVERIFY(!workspace().state().tree);
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));  // a window that is not active hears no shortcuts
  QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
  QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!workspace().state().tree);
  DendrogramView& view = window_->dendrogram();
  workspace().session().redo();
  const double weight = view.lineWeight();
  view.setFocus();
  QTest::keyClick(&view, Qt::Key_Up);
  QVERIFY(view.lineWeight() > weight);
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Weight);
  // Tool bar and dock titles repeat what the menus hold; every other button must take the focus by itself.
  for (const QPushButton* button : window_->findChildren<QPushButton*>()) {
    QVERIFY2(button->focusPolicy() & Qt::TabFocus, qPrintable(button->text()));
  }
}

void WorkbenchTest::changedBarriersOutdateTheTree() {
  openSample();
  QVERIFY(!workspace().treeOutdated());
  workspace().setBarriers({});
  QVERIFY(workspace().treeOutdated());
  workspace().cluster();
  QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);
  QVERIFY(!workspace().treeOutdated());
  workspace().session().undo();
  QVERIFY(workspace().treeOutdated());
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::WorkbenchTest>(argc, argv);
}
#include "workbench_test.moc"
