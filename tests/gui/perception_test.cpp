// The Perception dock in the real window: what it shows is what the algorithms by themselves say.
#include <QDockWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>

#include "gui/perception/difference_plot.h"
#include "gui/perception/picture_grid.h"
#include "gui/perception/sensitivity_plot.h"
#include "gui/perception/viewpoint_strip.h"
#include "gui/simplification/stage_legend.h"
#include "gui/widgets/parameter_panel.h"
#include "gui/widgets/picture_image.h"
#include "tests/gui/perception_support.h"

namespace lodestone {

class PerceptionTest : public PerceptionFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { writePavilion(); }
  void init() { openWindow(); }
  void cleanup() { closeWindow(); }
  void saysWhatIsMissing();
  void buildingWithoutSurfacesHasNothingToSee();
  void nobodyLooksUnlessAsked();
  void looksWhenShown();
  void showsThePicturesOfTheChosenViewpoint();
  void takesTheCameraAsOneMoreViewpoint();
  void saysWhatLargePicturesCost();
  void cancelledKeepsWhatWasSeen();
  void looksAtTheNextBuildingToo();
  void forgetsWithTheBuilding();
  void leavesOtherDocksTheirWidth();
  void isUsableInBothSizesAndThemes();
};

void PerceptionTest::saysWhatIsMissing() {
  action().trigger();
  QVERIFY2(panel().state().contains(QStringLiteral("No building")), qPrintable(panel().state()));
  QVERIFY(!panel().lookButton().isEnabled());
  QVERIFY(!panel().addButton().isEnabled());
  QVERIFY(panel().pictures().pictures().empty());
  QVERIFY(panel().classes().plot().isEmpty());
}

void PerceptionTest::buildingWithoutSurfacesHasNothingToSee() {
  const QString path = folder_.filePath(QStringLiteral("bare.city.json"));
  std::ofstream(path.toStdString()) << R"({"type": "CityJSON", "version": "2.0",
    "transform": {"scale": [0.01, 0.01, 0.01], "translate": [0, 0, 0]},
    "CityObjects": {"bare": {"type": "Building", "geometry": []}, "block": {"type": "Building", "geometry": [
      {"type": "MultiSurface", "lod": "0", "boundaries": [[[0, 1, 2, 3]]]}]}},
    "vertices": [[0, 0, 0], [1000, 0, 0], [1000, 1000, 0], [0, 1000, 0]]})";
  window_->openFiles({path}, false);
  QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().state().city && !window_->workspace().tasks().busy(), kLong);
  window_->workspace().select(window_->workspace().buildingsOf({"bare"}));
  window_->findChild<QAction*>(QStringLiteral("simplifyBuilding"))->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
  action().trigger();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  QCOMPARE(stage().staged()->mesh->triangleCount(), 0U);
  QVERIFY2(panel().state().contains(QStringLiteral("no surfaces")), qPrintable(panel().state()));
  QCOMPARE(panel().strip().viewCount(), std::size_t{0});
  QVERIFY(!panel().lookButton().isEnabled());
  stageWindow().legend().details().setChecked(true);
  (void)image();
  keepPicture(*window_, QStringLiteral("perception-bare"));
}

void PerceptionTest::nobodyLooksUnlessAsked() {
  openPavilion();
  QTest::qWait(600);
  QVERIFY(!perceiving().looked());
  QVERIFY(!perceiving().isLooking());
}

void PerceptionTest::looksWhenShown() {
  showDock();
  const Perception expected = reference();
  const Perception& seen = *perceiving().looked()->perception;
  QCOMPARE(panel().strip().viewCount(), std::size_t{8});
  QCOMPARE(seen.histogram, expected.histogram);
  QCOMPARE(seen.classes, expected.classes);
  QCOMPARE(seen.pixels, expected.pixels);
  QCOMPARE(seen.glimpsed, expected.glimpsed);
  QCOMPARE(stage().perception().get(), &seen);
  for (int number = 1; number <= 3; ++number) {
    std::size_t count = 0;
    std::size_t withUnseen = 0;
    for (const bool admitted : admittedTriangles(expected, number, false)) count += admitted ? 1 : 0;
    for (const bool admitted : admittedTriangles(expected, number, true)) withUnseen += admitted ? 1 : 0;
    QCOMPARE(cell(number - 1, 1), QLocale().toString(static_cast<qulonglong>(count)));
    QCOMPARE(cell(number - 1, 2), QLocale().toString(static_cast<qulonglong>(withUnseen)));
  }
  QVERIFY(!panel().classes().plot().isEmpty());
  QCOMPARE(panel().classes().plot().cuts(), expected.differences.cuts);
  QVERIFY2(panel().state().contains(QStringLiteral("8 viewpoints")), qPrintable(panel().state()));
  keepPicture(*window_, QStringLiteral("perception"));
}

void PerceptionTest::showsThePicturesOfTheChosenViewpoint() {
  showDock();
  panel().strip().setFocus();
  QTest::keyClick(&panel().strip(), Qt::Key_Right);
  QTest::keyClick(&panel().strip(), Qt::Key_Right);
  QCOMPARE(perceiving().view(), std::size_t{2});
  settle();
  const Looked& looked = *perceiving().looked();
  const PerceivedView view =
      perceiveView(*looked.renderer, looked.perception->cameras[2], looked.perception->options);
  const DifferenceClasses& classes = looked.perception->differences;
  const Picture expected[] = {view.rendered.picture, greyPicture(view.filtered),
                              differencePicture(view.difference, classes),
                              classPicture(view.difference, classes)};
  const auto& shown = panel().pictures().pictures();
  QCOMPARE(shown.size(), std::size_t{4});
  for (std::size_t i = 0; i < 4; ++i)
    QCOMPARE(shown[i].picture->image(), toImage(expected[i]).convertToFormat(QImage::Format_RGB32));
  // A pixel that shows the model says so, and a click selects its component.
  QPoint pixel(-1, -1);
  for (int y = 0; y < 96 && pixel.x() < 0; ++y) {
    for (int x = 0; x < 96; ++x) {
      if (view.rendered.triangle[static_cast<std::size_t>(y) * 96 + static_cast<std::size_t>(x)] !=
          kNoTriangle)
        pixel = QPoint(x, y);
    }
  }
  QVERIFY(pixel.x() >= 0);
  const std::uint32_t triangle =
      view.rendered.triangle[static_cast<std::size_t>(pixel.y()) * 96 + static_cast<std::size_t>(pixel.x())];
  QTest::mouseMove(&panel().pictures(),
                   panel().pictures().placeOf(0, QPointF(pixel) + QPointF(0.5, 0.5)).toPoint());
  Q_EMIT panel().pictures().picked(pixel);
  QCOMPARE(stage().selection(),
           std::vector<std::uint32_t>{componentOfTriangle(*stage().staged()->mesh, triangle)});
}

void PerceptionTest::takesTheCameraAsOneMoreViewpoint() {
  showDock();
  panel().addButton().click();
  settle();
  QCOMPARE(panel().strip().viewCount(), std::size_t{9});
  QCOMPARE(perceiving().view(), std::size_t{8});
  const Camera& added = perceiving().looked()->perception->cameras.back();
  QCOMPARE(added.eye, scene().camera().eye);
  QCOMPARE(added.width, 96);
  QCOMPARE(added.height, 96);
  auto* remove = window_->findChild<QToolButton*>(QStringLiteral("removeViewpoint"));
  QVERIFY(remove->isEnabled());
  remove->click();
  settle();
  QCOMPARE(panel().strip().viewCount(), std::size_t{8});
  QVERIFY(!remove->isEnabled());
}

void PerceptionTest::saysWhatLargePicturesCost() {
  showDock();
  const auto before = perceiving().looked();
  qobject_cast<QSpinBox*>(panel().fields().editor("size"))->setValue(8192);
  QTest::qWait(800);
  QVERIFY(!perceiving().isLooking());
  QVERIFY(perceiving().isOutdated());
  QCOMPARE(perceiving().looked(), before);
  QVERIFY2(panel().state().contains(QStringLiteral("GiB")), qPrintable(panel().state()));
  QVERIFY(panel().lookButton().isEnabled());
  keepPicture(*window_, QStringLiteral("perception-large"));
}

void PerceptionTest::cancelledKeepsWhatWasSeen() {
  showDock();
  const auto before = perceiving().looked();
  PerceiveOptions options = perceiving().options();
  options.size = 1024;
  options.views = 20;
  perceiving().setOptions(options, QStringLiteral("test"));
  QTRY_VERIFY(perceiving().isLooking());
  panel().lookButton().click();
  QTRY_VERIFY_WITH_TIMEOUT(!perceiving().isLooking(), kLong);
  QCOMPARE(perceiving().looked(), before);
  QVERIFY(perceiving().isOutdated());
  QTest::qWait(600);
  QVERIFY(!perceiving().isLooking());  // not again by itself
  QVERIFY2(panel().state().contains(QStringLiteral("of before")), qPrintable(panel().state()));
}

void PerceptionTest::looksAtTheNextBuildingToo() {
  showDock();
  PerceiveOptions options = perceiving().options();
  options.size = 512;
  options.views = 12;
  perceiving().setOptions(options, QStringLiteral("test"));
  QTRY_VERIFY(perceiving().isLooking());
  stage().open(stage().building());
  QTRY_VERIFY_WITH_TIMEOUT(perceiving().looked() && !perceiving().isOutdated(), kLong);
}

void PerceptionTest::forgetsWithTheBuilding() {
  showDock();
  stage().close();
  QVERIFY(!perceiving().looked());
  QVERIFY(!stage().perception());
  QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  QVERIFY(panel().pictures().pictures().empty());
}

void PerceptionTest::leavesOtherDocksTheirWidth() {
  openPavilion();
  setSmall();
  const auto* components = window_->findChild<QDockWidget*>(QStringLiteral("componentsDock"));
  const auto* method = window_->findChild<QDockWidget*>(QStringLiteral("simplifyDock"));
  const int left = components->width();
  const int right = method->width();
  action().trigger();
  settle();
  QVERIFY2(std::abs(components->width() - left) <= 4, qPrintable(QString::number(components->width())));
  QVERIFY2(std::abs(method->width() - right) <= 4, qPrintable(QString::number(method->width())));
}

void PerceptionTest::isUsableInBothSizesAndThemes() {
  showDock();
  for (const QSize& size : {QSize(1440, 900), QSize(1280, 800)}) {
    for (const Appearance appearance : {Appearance::Light, Appearance::Dark}) {
      window_->resize(size);
      QApplication::setPalette(paletteOf(appearance));
      QTest::qWait(50);
      QVERIFY(panel().pictures().cell(0).width() > 100);
      QVERIFY(panel().pictures().cell(0).height() > 100);
      QVERIFY(panel().classes().plot().height() > 80);
      panel().sides().setCurrentIndex(1);
      QVERIFY(panel().sensitivity().width() > 200);
      QVERIFY(panel().pictures().cell(0).width() > 100);
      keepPicture(*window_, QStringLiteral("perception-display-%1").arg(size.width()));
      panel().sides().setCurrentIndex(0);
      keepPicture(*window_, QStringLiteral("perception-%1-%2")
                                .arg(size.width())
                                .arg(appearance == Appearance::Dark ? "dark" : "light"));
    }
  }
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::PerceptionTest>(argc, argv);
}
#include "perception_test.moc"
