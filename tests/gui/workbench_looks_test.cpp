// The real window as people find it: docks, sizes, what can be told apart.
#include <QDockWidget>
#include <QSettings>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

#include "gui/widgets/colours.h"
#include "tests/gui/sample_support.h"

namespace lodestone {
namespace {

/// WCAG's relative luminance.
double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a) + 0.05;
  const double lb = luminance(b) + 0.05;
  return std::max(la, lb) / std::min(la, lb);
}

}  // namespace

class WorkbenchLooksTest : public WorkbenchFixture {
  Q_OBJECT

 private Q_SLOTS:
  void init() { window_ = makeWindow(); }
  void cleanup() { window_.reset(); }
  void docksComeBack();
  void firstWindowFitsTheScreen();
  void emptyCheckBoxesAreVisible_data();
  void emptyCheckBoxesAreVisible();
  void chosenToolButtonsAreVisible_data() { emptyCheckBoxesAreVisible_data(); }
  void chosenToolButtonsAreVisible();
};

void WorkbenchLooksTest::docksComeBack() {
  auto* dock = find<QDockWidget>("selectionDock");
  QVERIFY(dock->isVisible());
  dock->close();
  window_->close();
  window_ = std::make_unique<MainWindow>();
  window_->show();
  QVERIFY(!find<QDockWidget>("selectionDock")->isVisible());
  QVERIFY(find<QDockWidget>("methodDock")->isVisible());
  QSettings().clear();
}

void WorkbenchLooksTest::firstWindowFitsTheScreen() {
  MainWindow first;
  const QSize room = first.screen()->availableSize();
  QVERIFY(first.width() <= room.width() && first.height() < room.height());  // with a title above it
  QVERIFY(first.minimumWidth() <= first.width() && first.minimumHeight() <= first.height());
}

void WorkbenchLooksTest::emptyCheckBoxesAreVisible_data() {
  QTest::addColumn<int>("appearance");
  QTest::newRow("light") << static_cast<int>(Appearance::Light);
  QTest::newRow("dark") << static_cast<int>(Appearance::Dark);
}

void WorkbenchLooksTest::emptyCheckBoxesAreVisible() {
  QFETCH(int, appearance);
  QTreeWidget tree;
  tree.setPalette(paletteOf(static_cast<Appearance>(appearance)));
  auto* item = new QTreeWidgetItem(&tree);
  item->setCheckState(0, Qt::Unchecked);
  tree.resize(120, 80);
  const QImage picture = tree.viewport()->grab().toImage();
  const QColor base = tree.palette().color(QPalette::Base);
  std::size_t outline = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x)
      outline += contrast(picture.pixelColor(x, y), base) >= 3 ? 1U : 0U;
  }
  QVERIFY2(outline >= 30, qPrintable(QString::number(outline)));
}

void WorkbenchLooksTest::chosenToolButtonsAreVisible() {
  QFETCH(int, appearance);
  QToolButton button;
  button.setPalette(paletteOf(static_cast<Appearance>(appearance)));
  button.setCheckable(true);
  button.resize(60, 30);
  const QColor off = button.grab().toImage().pixelColor(15, 8);
  button.setChecked(true);
  const QColor on = button.grab().toImage().pixelColor(15, 8);
  QVERIFY2(contrast(off, on) > 1.4, qPrintable(off.name() + on.name()));
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::WorkbenchLooksTest>(argc, argv);
}
#include "workbench_looks_test.moc"
