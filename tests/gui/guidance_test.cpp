// What panels and dialogs say: what to do first, what chose the picture, and labels as people read them.
#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <fstream>

#include "gui/city/chain_panel.h"
#include "gui/city/dendrogram_view.h"
#include "gui/city/layers_panel.h"
#include "gui/city/method_panel.h"
#include "gui/city/scene_legend.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/dialogs/import_dialog.h"
#include "gui/window/stage_window.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/field_slider.h"
#include "tests/gui/project_support.h"

namespace lodestone {
namespace {

/// Labels that show a "&" which nobody resolves: Qt does where a label has a buddy. Rich text is no such
/// label, and "&&" no mnemonic.
QStringList rawMnemonics(const QWidget& dialog) {
  QStringList raw;
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    const bool rich = label->textFormat() == Qt::RichText ||
                      (label->textFormat() == Qt::AutoText && Qt::mightBeRichText(label->text()));
    if (!rich && !label->buddy() && label->text().contains(QLatin1Char('&'))) raw << label->text();
  }
  return raw;
}

}  // namespace

class GuidanceTest : public ProjectWindow {
  Q_OBJECT

 private Q_SLOTS:
  void init() { open(); }
  void cleanup() { window_.reset(); }

  void dialogsShowNoRawMnemonics();
  void anAmpersandInANameIsNoMnemonic();
  void theChainSaysWhatToDoFirst();
  void whatChoseTheCutIsSaid();
  void theWayBackFromTheDendrogram();
  void anOldFreezeDoesNotComeBack();
  void linesOverTheCityAreExplained_data();
  void linesOverTheCityAreExplained();

 private:
  template <class Widget>
  Widget* find(const char* name) {
    return window_->findChild<Widget*>(QString::fromLatin1(name));
  }
  [[nodiscard]] QString source() { return find<QLabel>("cutSource")->text(); }
  void click(const char* button) {
    QTest::mouseClick(find<QAbstractButton>(button), Qt::LeftButton);
    QCoreApplication::processEvents();
  }
};

void GuidanceTest::dialogsShowNoRawMnemonics() {
  openSample();
  ExportDialog chain(workspace());
  ExportDialog building(workspace(), window_->stage().stage());
  const QTemporaryDir folder;
  const std::string path = folder.filePath(QStringLiteral("plots.geojson")).toStdString();
  std::ofstream(path) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"n":1},
    "geometry":{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]]]}}]})";
  const QStringList files{QString::fromStdString(path)};
  auto questions = ImportDialog::questionsFor(files);
  QVERIFY(questions);
  ImportDialog import(files, std::move(*questions), {});
  for (QDialog* dialog :
       {static_cast<QDialog*>(&chain), static_cast<QDialog*>(&building), static_cast<QDialog*>(&import)}) {
    QCOMPARE(rawMnemonics(*dialog), QStringList());
  }
  chain.show();
  if (const QString to = qEnvironmentVariable("LODESTONE_SCREENSHOTS"); !to.isEmpty())
    chain.grab().save(QDir(to).filePath(QStringLiteral("guidance-export.png")));
}

void GuidanceTest::anAmpersandInANameIsNoMnemonic() {
  QSettings().setValue(QStringLiteral("recent"), QStringList{QStringLiteral("/tmp/Park & Ride.gml")});
  QMenu* recent = nullptr;
  for (QMenu* menu : window_->findChildren<QMenu*>()) {
    if (menu->title().contains(QStringLiteral("recent"))) recent = menu;
  }
  QVERIFY(recent);
  Q_EMIT recent->aboutToShow();
  QVERIFY(recent->actions().front()->text().contains(QStringLiteral("Park && Ride")));
  ProjectState state = workspace().state();
  state.city = smallCity(20);
  workspace().session().commit(state, "Import Park & Ride.gml");
  QAction* undo = nullptr;
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (action->text().startsWith(QStringLiteral("&Undo"))) undo = action;
  }
  QVERIFY(undo);
  QCOMPARE(undo->text(), QStringLiteral("&Undo Import Park && Ride.gml"));
}

void GuidanceTest::theChainSaysWhatToDoFirst() {
  const auto* said = find<QLabel>("noLevels");
  const auto* measure = find<QPushButton>("measureLevels");
  QVERIFY(!measure->isEnabled());
  QVERIFY(said->text().contains(QStringLiteral("Open a city model")));
  ProjectState state = workspace().state();
  state.city = smallCity(300);
  workspace().session().commit(state, "test");
  QVERIFY(!measure->isEnabled());
  QVERIFY(said->text().contains(QStringLiteral("Press “Cluster” first")));
  QVERIFY(measure->toolTip().contains(QStringLiteral("Press “Cluster” first")));
  workspace().cluster();
  QVERIFY(said->text().contains(QStringLiteral("Clustering")));
  waitForTasks();
  QVERIFY(measure->isEnabled());
  QVERIFY(said->text().contains(QStringLiteral("Press “Measure levels”")));
}

void GuidanceTest::whatChoseTheCutIsSaid() {
  QVERIFY(!find<QLabel>("cutSource")->isVisible());
  openSample();
  QVERIFY(source().contains(QStringLiteral("from this camera")));
  workspace().setCutChoice({CutMode::Tolerance, 10});
  QVERIFY(source().contains(QStringLiteral("Level of 10 m")));
  workspace().setCutChoice({CutMode::Original, 0});
  QVERIFY(source().contains(QStringLiteral("original")));
  workspace().chooseByCamera(true);
  QVERIFY(source().contains(QStringLiteral("Frozen")));
}

void GuidanceTest::theWayBackFromTheDendrogram() {
  openSample();
  const std::size_t followed = workspace().cut()->drawn.size();
  QTest::keyClick(&window_->dendrogram(), Qt::Key_Down);
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Weight);
  QVERIFY(!workspace().cameraFrozen());
  QVERIFY(source().contains(QStringLiteral("weight")) && source().contains(QStringLiteral("Follow camera")));
  keepPicture(*window_, QStringLiteral("guidance-dendrogram"));
  for (const char* name : {"followCamera", "freezeCamera"}) {
    QVERIFY(find<QToolButton>(name)->isEnabled());
    QVERIFY(!find<QToolButton>(name)->isChecked());
  }
  click("freezeCamera");
  QVERIFY(workspace().cameraFrozen());
  QCOMPARE(workspace().cut()->drawn.size(), followed);
  QVERIFY(find<QToolButton>("freezeCamera")->isChecked());
  QVERIFY2(!find<QToolButton>("followCamera")->isChecked(), "one of them chooses");
  keepPicture(*window_, QStringLiteral("guidance-frozen"));
  click("followCamera");
  QVERIFY(!workspace().cameraFrozen());
  QVERIFY(find<QToolButton>("followCamera")->isChecked());
  click("followCamera");
  QVERIFY2(find<QToolButton>("followCamera")->isChecked(), "a second click changes nothing");
}

void GuidanceTest::anOldFreezeDoesNotComeBack() {
  openSample();
  workspace().chooseByCamera(true);
  workspace().setCutChoice({CutMode::Original, 0});
  QVERIFY(!workspace().cameraFrozen());
  workspace().session().undo();
  QVERIFY2(workspace().cameraFrozen(), "undo takes back the whole step");
  workspace().session().redo();
  window_->method().epsilon().slider().setValue(500);
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Camera);
  QVERIFY(!workspace().cameraFrozen());
}

void GuidanceTest::linesOverTheCityAreExplained_data() {
  QTest::addColumn<int>("appearance");
  QTest::newRow("light") << static_cast<int>(Appearance::Light);
  QTest::newRow("dark") << static_cast<int>(Appearance::Dark);
}

void GuidanceTest::linesOverTheCityAreExplained() {
  QFETCH(int, appearance);
  const QPalette before = QApplication::palette();
  QApplication::setPalette(paletteOf(static_cast<Appearance>(appearance)));
  openSample();
  const SceneLegend& legend = window_->viewport().legend();
  QVERIFY(!window_->viewport().grabImage().isNull());
  QVERIFY2(legend.entries().empty() && !legend.isVisible(), "nothing that asks for a legend");
  window_->layers().setShown(Overlay::NegativeSpace, true);
  QTRY_VERIFY_WITH_TIMEOUT(legend.isVisible(), kLong);
  const auto has = [&legend](LegendEntry::Sign sign, const Rgb& colour) {
    const QColor wanted = QColor::fromRgbF(colour[0], colour[1], colour[2]);
    return std::any_of(legend.entries().begin(), legend.entries().end(),
                       [&](const LegendEntry& e) { return e.sign == sign && e.colour == wanted; });
  };
  const Palette& palette = appearance == static_cast<int>(Appearance::Dark) ? darkPalette() : lightPalette();
  QVERIFY(has(LegendEntry::Sign::Box, palette.boxLine));
  QVERIFY(!has(LegendEntry::Sign::Hull, palette.hullLine));
  QVERIFY(has(LegendEntry::Sign::Block, palette.landmark));
  window_->layers().setShown(Overlay::Hulls, true);
  QVERIFY(!window_->viewport().picture().isNull());
  QVERIFY(has(LegendEntry::Sign::Hull, palette.hullLine));
  QVERIFY(window_->viewport().rect().contains(legend.geometry()));
  keepPicture(*window_, QStringLiteral("legend-%1").arg(appearance));
  // It is part of the picture that is saved.
  const QImage with = window_->viewport().picture();
  const QPoint inside =
      (QPointF(legend.geometry().topLeft() + QPoint(20, 3)) * with.devicePixelRatio()).toPoint();
  QVERIFY(with.pixelColor(inside) != window_->viewport().grabImage().pixelColor(inside));
  window_->layers().setShown(Overlay::Hulls, false);
  window_->layers().setShown(Overlay::NegativeSpace, false);
  QTRY_VERIFY_WITH_TIMEOUT(!legend.isVisible(), kLong);
  QApplication::setPalette(before);
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::GuidanceTest>(argc, argv);
}
#include "guidance_test.moc"
