// The 3D view moved by mouse and keys.
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <random>

#include "tests/gui/viewport_support.h"

namespace lodestone::test {

class ViewportCameraTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void fitShowsEverything();
  void planViewLooksStraightDown();
  void orbitKeepsUpAndStaysAboveGround();
  void panKeepsThePointUnderTheCursor();
  void wheelKeepsThePointUnderTheCursor();
  void doubleClickCentres();
  void keysMoveTheCamera();
};

void ViewportCameraTest::fitShowsEverything() {
  Town town;
  const CityScene& scene = town.view.scene();
  Box2 seen;
  for (NodeId node = 0; node < 25; ++node) {
    const Box3 box = scene.boundsOf(node);
    for (const Vec3& corner : {box.min, box.max}) {
      const auto at = scene.project(corner);
      QVERIFY(at && at->x() >= 0 && at->y() >= 0 && at->x() <= scene.camera().width &&
              at->y() <= scene.camera().height);
    }
  }
  scene.forEachTriangle([&](const std::array<Vec3, 3>& triangle, NodeId) {
    for (const Vec3& corner : triangle) seen.add(*scene.project(corner));
  });
  const Vec2 share = seen.size().cwiseQuotient(Vec2(scene.camera().width, scene.camera().height));
  QVERIFY2(share.maxCoeff() > 0.85, "the picture is used");
  town.view.fitTo(scene.boundsOf(7));
  const auto picked = scene.pick(scene.camera().width / 2.0, scene.camera().height / 2.0);
  QVERIFY(picked && picked->node == 7);
}

void ViewportCameraTest::planViewLooksStraightDown() {
  Town town;
  CityScene& scene = town.view.scene();
  QSignalSpy told(&town.view, &Viewport::planViewChanged);
  const Vec3 before = frameOf(town.view.camera()).forward;
  town.view.setPlanView(true);
  QCOMPARE(told.count(), 1);
  QVERIFY((frameOf(town.view.camera()).forward - Vec3(0, 0, -1)).norm() < 1e-9);
  const Vec2 low = *scene.project(Vec3(40, 40, 0));
  const Vec2 high = *scene.project(Vec3(40, 40, 30));
  QVERIFY((low - high).norm() < 1e-6);
  QVERIFY(scene.project(Vec3(40, 90, 0))->y() < low.y());
  keepPicture(town.view.grabImage(), QStringLiteral("plan"));
  town.view.setPlanView(false);
  QVERIFY((frameOf(town.view.camera()).forward - before).norm() < 1e-9);
}

void ViewportCameraTest::orbitKeepsUpAndStaysAboveGround() {
  Town town;
  CityScene& scene = town.view.scene();
  QSignalSpy moved(&town.view, &Viewport::cameraChanged);
  std::mt19937 random(5);
  Navigator navigator(scene);
  for (int i = 0; i < 60; ++i) {
    const Camera before = scene.camera();
    const double x = scene.camera().width * 0.5;
    const double y = scene.camera().height * 0.6;
    const auto pivot = scene.groundPoint(x, y);
    navigator.beginDrag(DragKind::Orbit, x, y);
    const double dx = static_cast<double>(random() % 400) - 200;
    const double dy = static_cast<double>(random() % 400) - 200;
    navigator.drag(x + dx, y + dy);
    navigator.endDrag();
    const Camera& now = scene.camera();
    QVERIFY(std::abs(frameOf(now).right.z()) < 1e-9);
    QVERIFY(frameOf(now).up.z() >= -1e-9);
    QVERIFY(now.eye.z() >= scene.groundHeight() + 1);
    if (pivot)
      QVERIFY(std::abs((now.eye - *pivot).norm() - (before.eye - *pivot).norm()) <
              1e-6 * (before.eye - *pivot).norm());
  }
  QVERIFY(moved.count() > 30);
}

void ViewportCameraTest::panKeepsThePointUnderTheCursor() {
  for (const bool plan : {false, true}) {
    Town town;
    CityScene& scene = town.view.scene();
    town.view.setPlanView(plan);
    Navigator navigator(scene);
    const Vec2 from(scene.camera().width * 0.5, scene.camera().height * 0.55);
    const Vec3 grabbed = *scene.groundPoint(from.x(), from.y());
    navigator.beginDrag(DragKind::Pan, from.x(), from.y());
    for (const Vec2& to :
         {Vec2(from + Vec2(17, 5)), Vec2(from + Vec2(-40, 31)), Vec2(from + Vec2(60, -12))}) {
      const double height = scene.camera().eye.z();
      navigator.drag(to.x(), to.y());
      QVERIFY((*scene.project(grabbed) - to).norm() < 1e-6);
      QVERIFY(std::abs(scene.camera().eye.z() - height) < 1e-9);
    }
  }
}

void ViewportCameraTest::wheelKeepsThePointUnderTheCursor() {
  for (const bool plan : {false, true}) {
    Town town;
    CityScene& scene = town.view.scene();
    town.view.setPlanView(plan);
    const QPointF at(town.view.width() * 0.6, town.view.height() * 0.55);
    const double ratio = town.view.devicePixelRatioF();
    const Vec2 pixel(at.x() * ratio, at.y() * ratio);
    const Vec3 point = *scene.groundPoint(pixel.x(), pixel.y());
    QWidget* target = town.view.childAt(at.toPoint());
    for (const int turn : {120, 240, -120, -600}) {
      const double before = parallelScale(scene.camera());
      QWheelEvent wheel(at, target->mapToGlobal(at), QPoint(), QPoint(0, turn), Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(target, &wheel);
      QVERIFY(turn > 0 ? parallelScale(scene.camera()) < before : parallelScale(scene.camera()) > before);
      QVERIFY((*scene.project(point) - pixel).norm() < 1e-6);
    }
  }
}

void ViewportCameraTest::doubleClickCentres() {
  Town town;
  CityScene& scene = town.view.scene();
  const QPoint at(town.view.width() / 2 + 60, town.view.height() / 2 + 20);
  const double ratio = town.view.devicePixelRatioF();
  const Vec3 point = *scene.groundPoint(at.x() * ratio, at.y() * ratio);
  QTest::mouseDClick(town.view.childAt(at), Qt::LeftButton, {}, at);
  QVERIFY((*scene.project(point) - Vec2(scene.camera().width / 2.0, scene.camera().height / 2.0)).norm() <
          1e-6);
}

void ViewportCameraTest::keysMoveTheCamera() {
  Town town;
  const CityScene& scene = town.view.scene();
  for (const int key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Plus, Qt::Key_Minus,
                        Qt::Key_P, Qt::Key_P}) {
    const Camera before = scene.camera();
    QTest::keyClick(&town.view, static_cast<Qt::Key>(key));
    QVERIFY(!(scene.camera() == before));
  }
  const Camera before = scene.camera();
  QTest::keyClick(&town.view, Qt::Key_Right, Qt::ShiftModifier);
  QVERIFY(std::abs(scene.camera().eye.z() - before.eye.z()) < 1e-9);
  QVERIFY((scene.camera().eye - before.eye).norm() > 1);
  QTest::keyClick(&town.view, Qt::Key_F);
  fitShowsEverything();
}

}  // namespace lodestone::test

int main(int argc, char** argv) {
  return lodestone::test::runViewportTest<lodestone::test::ViewportCameraTest>(argc, argv);
}
#include "viewport_camera_test.moc"
