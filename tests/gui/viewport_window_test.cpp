// The 3D view as a widget: sizes, docks, and what it does while nothing moves.
#include <QDockWidget>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <set>

#include "gui/surfaces/picture_average.h"
#include "tests/gui/viewport_support.h"

namespace lodestone::test {

class ViewportWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void resizes();
  void survivesFloatingAndDocking();
  void restingViewGrowsSmooth();
};

void ViewportWindowTest::resizes() {
  Town town;
  for (const QSize size : {QSize(300, 500), QSize(701, 333)}) {
    town.view.resize(size);
    const QImage picture = town.view.grabImage();
    const QSize pixels(qRound(size.width() * town.view.devicePixelRatioF()),
                       qRound(size.height() * town.view.devicePixelRatioF()));
    QCOMPARE(picture.size(), pixels);
    QCOMPARE(town.view.scene().camera().width, pixels.width());
    QCOMPARE(town.view.scene().camera().height, pixels.height());
    QCOMPARE(QSize(town.view.camera().width, town.view.camera().height), size);  // in pixels of the toolkit
    town.view.fit();
    const CityScene& scene = town.view.scene();
    const Vec2 middle(scene.camera().width * 0.5, scene.camera().height * 0.5);
    const auto seen = slowPick(scene, rayThrough(scene.camera(), false, middle.x(), middle.y()));
    const auto picked = scene.pick(middle.x(), middle.y());
    QVERIFY(picked.has_value() == seen.has_value() && (!seen || picked->node == seen->node));
    keepPicture(picture, QStringLiteral("resized-%1").arg(size.width()));
  }
}

void ViewportWindowTest::survivesFloatingAndDocking() {
  QMainWindow window;
  auto* dock = new QDockWidget(&window);
  auto* view = new Viewport(dock);
  const auto city = smallTown(4);
  dock->setWidget(view);
  window.addDockWidget(Qt::RightDockWidgetArea, dock);
  window.resize(700, 500);
  view->scene().setCity(city);
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  view->fit();
  QVERIFY(!view->grabImage().isNull());
  for (const bool floating : {true, false, true}) {
    QSignalSpy frames(view, &Viewport::frameRendered);
    dock->setFloating(floating);
    view->requestRender();
    QTRY_VERIFY_WITH_TIMEOUT(frames.count() > 0, 5000);
    const QImage full = view->grabImage();
    QCOMPARE(full.size(), (QSizeF(view->size()) * view->devicePixelRatioF()).toSize());
    view->scene().setLayerStyle(SceneLayer::Buildings, {.visible = false});
    const QImage empty = view->grabImage();
    view->scene().setLayerStyle(SceneLayer::Buildings, {});
    QVERIFY2(changedPixels(full, empty) > static_cast<std::size_t>(full.width() * full.height() / 20),
             floating ? "floating" : "docked");
  }
}

void ViewportWindowTest::restingViewGrowsSmooth() {
  Town town;
  const QImage rough = town.view.grabImage();
  const QImage smooth = town.view.grabImage(8);
  QCOMPARE(smooth.size(), rough.size());
  const auto shades = [](const QImage& picture) {
    std::set<QRgb> seen;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) seen.insert(picture.pixel(x, y));
    }
    return seen.size();
  };
  QVERIFY(shades(smooth) > 2 * shades(rough));
  PictureAverage average;
  QImage grey(3, 2, QImage::Format_RGB32);
  for (const int value : {10, 20, 33}) {
    grey.fill(QColor(value, value, value));
    average.add(grey);
  }
  QCOMPARE(qRed(average.mean().pixel(1, 1)), 21);
}

}  // namespace lodestone::test

int main(int argc, char** argv) {
  return lodestone::test::runViewportTest<lodestone::test::ViewportWindowTest>(argc, argv);
}
#include "viewport_window_test.moc"
