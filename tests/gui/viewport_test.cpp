// The 3D view on both backends: what it draws is looked at pixel by pixel and compared with rays cast the
// slow way.
#include "gui/viewport.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <random>
#include <set>

#include "algorithms/synthesis.h"
#include "gui/picture_average.h"
#include "tests/gui/scene_support.h"

namespace lodestone::test {

namespace {

constexpr int kBorder = 4;  // pixels beside a silhouette that ink, halo and outline may change

int difference(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
}

std::size_t changedPixels(const QImage& a, const QImage& b) {
  std::size_t count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += difference(a.pixel(x, y), b.pixel(x, y)) > 6;
  }
  return count;
}

/// Whether a node has a triangle at this very point.
bool touches(const CityScene& scene, NodeId node, const Vec3& point) {
  bool found = false;
  scene.forEachTriangle([&](const std::array<Vec3, 3>& t, NodeId owner) {
    if (owner != node || found) return;
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    found = std::abs(normal.dot(point - t[0])) < 1e-4;
  });
  return found;
}

/// A pointer move as the window system sends it; QTest's own goes through the real cursor.
void sendMove(Viewport& view, const QPoint& at, Qt::MouseButtons buttons = Qt::NoButton) {
  QWidget* target = view.childAt(view.rect().center());
  QMouseEvent move(QEvent::MouseMove, at, target->mapToGlobal(QPointF(at)), Qt::NoButton, buttons,
                   Qt::NoModifier);
  QApplication::sendEvent(target, &move);
}

/// A viewport with a small town, seen whole.
struct Town {
  std::shared_ptr<CityModel> city = smallTown(6);
  std::shared_ptr<ClusterTree> tree = handMadeTree(*city);
  Viewport view;
  explicit Town(QSize size = {480, 320}) {
    view.resize(size);
    view.scene().setCity(city, tree);
    view.show();
    [[maybe_unused]] const bool shown = QTest::qWaitForWindowExposed(&view);
    view.fit();
  }
};

void keepPicture(const QImage& picture, const QString& name) {
  // LODESTONE_SCREENSHOTS names a folder in which people find what the tests saw.
  const QString folder = qEnvironmentVariable("LODESTONE_SCREENSHOTS");
  if (!folder.isEmpty() && QDir().mkpath(folder)) {
    picture.save(QDir(folder).filePath(QGuiApplication::platformName() + QLatin1Char('-') + name +
                                       QLatin1String(".png")));
  }
}

}  // namespace

class ViewportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hasContext();
  void drawsBuildingsWhereTheCameraProjectsThem_data();
  void drawsBuildingsWhereTheCameraProjectsThem();
  void picksWhatTheSlowWayPicks_data();
  void picksWhatTheSlowWayPicks();
  void hoverColoursExactlyThePickedNode();
  void cutChangesThePicture();
  void selectionMarksDrawnAncestorsAndDescendants();
  void overlaysChangeThePicture_data();
  void overlaysChangeThePicture();
  void themeChangesThePicture();
  void sameSceneGivesSamePixels();
  void resizes();
  void survivesFloatingAndDocking();
  void fitShowsEverything();
  void planViewLooksStraightDown();
  void orbitKeepsUpAndStaysAboveGround();
  void panKeepsThePointUnderTheCursor();
  void wheelKeepsThePointUnderTheCursor();
  void doubleClickCentres();
  void keysMoveTheCamera();
  void clickAndHoverTell();
  void oddCities_data();
  void oddCities();
  void farFromTheOrigin();
  void restingViewGrowsSmooth();
  void treeComesLater();
  void sampleTown();
};

void ViewportTest::hasContext() {
  Town town;
  QVERIFY2(town.view.isValid(), qPrintable(town.view.problem()));
  QVERIFY(!town.view.grabImage().isNull());
  QVERIFY(town.view.graphicsInfo().startsWith(QLatin1String("OpenGL ")));
}

void ViewportTest::drawsBuildingsWhereTheCameraProjectsThem_data() {
  QTest::addColumn<bool>("plan");
  QTest::addColumn<bool>("cut");
  QTest::newRow("perspective, buildings") << false << false;
  QTest::newRow("perspective, cut") << false << true;
  QTest::newRow("plan, buildings") << true << false;
  QTest::newRow("plan, cut") << true << true;
}

void ViewportTest::drawsBuildingsWhereTheCameraProjectsThem() {
  QFETCH(bool, plan);
  QFETCH(bool, cut);
  Town town;
  CityScene& scene = town.view.scene();
  town.view.setPlanView(plan);
  town.view.fit();
  if (cut) scene.showCut(handMadeCut(*town.tree));
  const QImage with = town.view.grabImage();
  scene.setLayerStyle(SceneLayer::Buildings, {.visible = false});
  const QImage without = town.view.grabImage();
  QCOMPARE(with.size(), without.size());
  const int step = 2;
  const int columns = with.width() / step;
  const int rows = with.height() / step;
  std::vector<char> hit(static_cast<std::size_t>(columns * rows));
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Ray ray = rayThrough(scene.camera(), plan, c * step + 0.5, r * step + 0.5);
      hit[static_cast<std::size_t>(r * columns + c)] = slowPick(scene, ray).has_value();
    }
  }
  int looked = 0;
  const int border = kBorder * qCeil(town.view.devicePixelRatioF()) / step;
  for (int r = border; r + border < rows; ++r) {
    for (int c = border; c + border < columns; ++c) {
      bool inner = true;
      const char here = hit[static_cast<std::size_t>(r * columns + c)];
      for (int dr = -border; dr <= border; ++dr) {
        for (int dc = -border; dc <= border; ++dc) {
          inner = inner && hit[static_cast<std::size_t>((r + dr) * columns + c + dc)] == here;
        }
      }
      if (!inner) continue;
      ++looked;
      const bool drawn = difference(with.pixel(c * step, r * step), without.pixel(c * step, r * step)) > 6;
      QVERIFY2(drawn == (here != 0), qPrintable(QStringLiteral("pixel %1, %2").arg(c * step).arg(r * step)));
    }
  }
  QVERIFY(looked > columns * rows / 4);
}

void ViewportTest::picksWhatTheSlowWayPicks_data() {
  drawsBuildingsWhereTheCameraProjectsThem_data();
}

void ViewportTest::picksWhatTheSlowWayPicks() {
  QFETCH(bool, plan);
  QFETCH(bool, cut);
  Town town;
  CityScene& scene = town.view.scene();
  town.view.setPlanView(plan);
  town.view.fit();
  if (cut) scene.showCut(handMadeCut(*town.tree));
  std::mt19937 random(3);
  const Camera& camera = scene.camera();
  std::set<NodeId> seen;
  for (int i = 0; i < 1500; ++i) {
    const double x = camera.width * std::generate_canonical<double, 32>(random);
    const double y = camera.height * std::generate_canonical<double, 32>(random);
    const auto slow = slowPick(scene, rayThrough(camera, plan, x, y));
    const auto fast = scene.pick(x, y);
    QCOMPARE(fast.has_value(), slow.has_value());
    if (!slow) continue;
    QVERIFY(std::abs(fast->distance - slow->distance) < 1e-6 * slow->distance);
    // Where a landmark's wall lies in its cluster's both are first; so do the walls of overlapping clusters.
    if (fast->node != slow->node) QVERIFY(touches(scene, slow->node, fast->point));
    seen.insert(fast->node);
    const auto back = scene.project(fast->point);
    QVERIFY(back && (*back - Vec2(x, y)).norm() < 1e-6);
    const auto drawn = std::find_if(scene.drawn().begin(), scene.drawn().end(),
                                    [&](const DrawnNode& item) { return item.node == fast->node; });
    QVERIFY(drawn != scene.drawn().end());
    QVERIFY(drawn->role == fast->role && drawn->of == fast->of);
  }
  QVERIFY(seen.size() > 10);
}

void ViewportTest::hoverColoursExactlyThePickedNode() {
  Town town;
  CityScene& scene = town.view.scene();
  scene.showCut(handMadeCut(*town.tree));
  const QImage plain = town.view.grabImage();
  std::vector<NodeId> owners(static_cast<std::size_t>(plain.width() * plain.height()), kNoNode);
  const auto at = [&](int x, int y) -> NodeId& {
    return owners[static_cast<std::size_t>(y * plain.width() + x)];
  };
  for (int y = 0; y < plain.height(); ++y) {
    for (int x = 0; x < plain.width(); ++x) {
      if (const auto picked = scene.pick(x + 0.5, y + 0.5)) at(x, y) = picked->node;
    }
  }
  const int border = kBorder * qCeil(town.view.devicePixelRatioF());
  int looked = 0;
  for (const DrawnNode& item : scene.drawn()) {
    scene.setHover(item.node);
    const QImage hovered = town.view.grabImage();
    for (int y = border; y + border < plain.height(); y += 3) {
      for (int x = border; x + border < plain.width(); x += 3) {
        bool inner = true;
        for (int d = -border; d <= border; ++d) {
          inner = inner && at(x + d, y) == at(x, y) && at(x, y + d) == at(x, y);
        }
        if (!inner) continue;
        const bool changed = difference(plain.pixel(x, y), hovered.pixel(x, y)) > 6;
        const NodeId owner = at(x, y);
        const bool below =
            owner != kNoNode && town.tree->nodes[owner].parent == item.node;  // a landmark of this cluster
        QCOMPARE(changed, owner == item.node || below);
        looked += changed;
      }
    }
  }
  QVERIFY(looked > 500);
}

void ViewportTest::cutChangesThePicture() {
  Town town;
  CityScene& scene = town.view.scene();
  const QImage all = town.view.grabImage();
  const std::size_t buildings = scene.drawn().size();
  const Cut cut = handMadeCut(*town.tree);
  scene.showCut(cut);
  QCOMPARE(scene.drawn().size(), cut.drawn.size());
  const QImage coarse = town.view.grabImage();
  QVERIFY(changedPixels(all, coarse) > 1000);
  keepPicture(coarse, QStringLiteral("cut"));
  scene.showAllBuildings();
  QCOMPARE(scene.drawn().size(), buildings);
  QCOMPARE(town.view.grabImage(), all);
}

void ViewportTest::selectionMarksDrawnAncestorsAndDescendants() {
  Town town;
  CityScene& scene = town.view.scene();
  const QImage plain = town.view.grabImage();
  const NodeId pair = town.tree->dendrogram->leafCount;
  const std::array<NodeId, 2> buildings{town.tree->nodes[pair].a, town.tree->nodes[pair].b};
  scene.setSelection(std::span(&pair, 1));
  const QImage byCluster = town.view.grabImage();
  QVERIFY(changedPixels(plain, byCluster) > 50);
  scene.setSelection(buildings);
  QCOMPARE(town.view.grabImage(), byCluster);
  Cut root;
  root.drawn.push_back({static_cast<NodeId>(town.tree->nodes.size() - 1), DrawRole::Cluster});
  scene.showCut(root);
  const QImage part = town.view.grabImage();
  scene.setSelection({});
  const QImage none = town.view.grabImage();
  QVERIFY(changedPixels(part, none) > 1000);
  scene.setSelection(std::span(&root.drawn[0].node, 1));
  QVERIFY(changedPixels(part, town.view.grabImage()) > 1000);
}

void ViewportTest::overlaysChangeThePicture_data() {
  QTest::addColumn<int>("overlay");
  QTest::newRow("hulls") << static_cast<int>(Overlay::Hulls);
  QTest::newRow("negative space") << static_cast<int>(Overlay::NegativeSpace);
  QTest::newRow("landmarks") << static_cast<int>(Overlay::Landmarks);
  QTest::newRow("streets") << static_cast<int>(Overlay::Streets);
  QTest::newRow("ground") << static_cast<int>(Overlay::Ground);
  QTest::newRow("edges") << static_cast<int>(Overlay::Edges);
}

void ViewportTest::overlaysChangeThePicture() {
  QFETCH(int, overlay);
  Town town;
  CityScene& scene = town.view.scene();
  scene.setLines({LineLayer{
      "streets", {{Vec2(-20, 25), Vec2(160, 25)}, {Vec2(25, -20), Vec2(25, 160)}}, {"residential", "rail"}}});
  scene.showCut(handMadeCut(*town.tree));
  scene.setOverlay(static_cast<Overlay>(overlay), true);
  QVERIFY(scene.overlay(static_cast<Overlay>(overlay)));
  const QImage on = town.view.grabImage();
  keepPicture(on, QStringLiteral("overlay-%1").arg(overlay));
  scene.setOverlay(static_cast<Overlay>(overlay), false);
  QVERIFY(changedPixels(on, town.view.grabImage()) > 40);
}

void ViewportTest::themeChangesThePicture() {
  Town town;
  const QImage light = town.view.grabImage();
  town.view.scene().setTheme(SceneTheme::Dark);
  const QImage dark = town.view.grabImage();
  QVERIFY(qGray(light.pixel(3, 3)) > 150);
  QVERIFY(qGray(dark.pixel(3, 3)) < 100);
}

void ViewportTest::sameSceneGivesSamePixels() {
  Town town;
  Town other;
  QCOMPARE(town.view.grabImage(), other.view.grabImage());
}

void ViewportTest::resizes() {
  Town town;
  for (const QSize size : {QSize(300, 500), QSize(701, 333)}) {
    town.view.resize(size);
    const QImage picture = town.view.grabImage();
    const QSize pixels(qRound(size.width() * town.view.devicePixelRatioF()),
                       qRound(size.height() * town.view.devicePixelRatioF()));
    QCOMPARE(picture.size(), pixels);
    QCOMPARE(town.view.camera().width, pixels.width());
    QCOMPARE(town.view.camera().height, pixels.height());
    town.view.fit();
    const CityScene& scene = town.view.scene();
    const Vec2 middle(scene.camera().width * 0.5, scene.camera().height * 0.5);
    const auto seen = slowPick(scene, rayThrough(scene.camera(), false, middle.x(), middle.y()));
    const auto picked = scene.pick(middle.x(), middle.y());
    QVERIFY(picked.has_value() == seen.has_value() && (!seen || picked->node == seen->node));
    keepPicture(picture, QStringLiteral("resized-%1").arg(size.width()));
  }
}

void ViewportTest::survivesFloatingAndDocking() {
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

void ViewportTest::fitShowsEverything() {
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

void ViewportTest::planViewLooksStraightDown() {
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

void ViewportTest::orbitKeepsUpAndStaysAboveGround() {
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

void ViewportTest::panKeepsThePointUnderTheCursor() {
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

void ViewportTest::wheelKeepsThePointUnderTheCursor() {
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

void ViewportTest::doubleClickCentres() {
  Town town;
  CityScene& scene = town.view.scene();
  const QPoint at(town.view.width() / 2 + 60, town.view.height() / 2 + 20);
  const double ratio = town.view.devicePixelRatioF();
  const Vec3 point = *scene.groundPoint(at.x() * ratio, at.y() * ratio);
  QTest::mouseDClick(town.view.childAt(at), Qt::LeftButton, {}, at);
  QVERIFY((*scene.project(point) - Vec2(scene.camera().width / 2.0, scene.camera().height / 2.0)).norm() <
          1e-6);
}

void ViewportTest::keysMoveTheCamera() {
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

void ViewportTest::clickAndHoverTell() {
  Town town;
  const CityScene& scene = town.view.scene();
  QSignalSpy picked(&town.view, &Viewport::picked);
  QSignalSpy hovered(&town.view, &Viewport::hovered);
  const double ratio = town.view.devicePixelRatioF();
  const Box3 box = scene.boundsOf(12);
  const Vec2 roof = *scene.project(Vec3(box.min.x() + 2, box.min.y() + 2, box.max.z()));
  const QPoint at(qRound(roof.x() / ratio), qRound(roof.y() / ratio));
  sendMove(town.view, at);
  QTRY_VERIFY_WITH_TIMEOUT(hovered.count() > 0, 2000);
  QCOMPARE(hovered.last()[0].value<NodeId>(), 12U);
  QCOMPARE(scene.hover(), 12U);
  QTest::mouseClick(town.view.childAt(at), Qt::LeftButton, Qt::ControlModifier, at);
  QCOMPARE(picked.count(), 1);
  QCOMPARE(picked[0][0].value<NodeId>(), 12U);
  QCOMPARE(picked[0][1].toBool(), true);
  QTest::mouseClick(town.view.childAt(QPoint(2, 2)), Qt::LeftButton, {}, QPoint(2, 2));
  QCOMPARE(picked[1][0].value<NodeId>(), kNoNode);
  // A drag is no click.
  QTest::mousePress(town.view.childAt(at), Qt::LeftButton, {}, at);
  sendMove(town.view, at + QPoint(40, 10), Qt::LeftButton);
  QTest::mouseRelease(town.view.childAt(at), Qt::LeftButton, {}, at + QPoint(40, 10));
  QCOMPARE(picked.count(), 2);
}

void ViewportTest::oddCities_data() {
  QTest::addColumn<int>("kind");
  QTest::newRow("empty") << 0;
  QTest::newRow("one building") << 1;
  QTest::newRow("no footprint") << 2;
  QTest::newRow("no height") << 3;
  QTest::newRow("null") << 4;
}

void ViewportTest::oddCities() {
  QFETCH(int, kind);
  auto city = std::make_shared<CityModel>();
  if (kind >= 1) city->buildings.push_back(boxBuilding("b", 0, 0, 10, 10, kind == 3 ? 0 : 8));
  if (kind == 2) city->buildings[0].footprint.clear();
  Viewport view;
  view.resize(200, 150);
  view.scene().setCity(kind == 4 ? nullptr : city);
  view.fit();
  QCOMPARE(view.scene().drawn().size(), kind == 0 || kind == 4 ? 0U : 1U);
  QCOMPARE(view.grabImage().size(), (QSizeF(200, 150) * view.devicePixelRatioF()).toSize());
  const auto middle = view.scene().pick(view.camera().width / 2.0, view.camera().height / 2.0);
  QCOMPARE(middle.has_value(), kind == 1 || kind == 3);
}

void ViewportTest::farFromTheOrigin() {
  // A town 80 km from the local origin is drawn as sharply as one that stands there.
  Town here;
  auto city = smallTown(6);
  for (Building& building : city->buildings) {
    for (Polygon& polygon : building.footprint) {
      for (Vec2& p : polygon.outer) p += Vec2(80000, -40000);
      for (Ring& hole : polygon.holes) {
        for (Vec2& p : hole) p += Vec2(80000, -40000);
      }
    }
  }
  here.view.scene().setOverlay(Overlay::Ground, false);  // its grid stands still
  const QImage near = here.view.grabImage();
  here.view.scene().setCity(city);
  here.view.fit();
  const QImage far = here.view.grabImage();
  QVERIFY(changedPixels(near, far) < static_cast<std::size_t>(near.width() * near.height() / 500));
}

void ViewportTest::restingViewGrowsSmooth() {
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

void ViewportTest::treeComesLater() {
  Town town;
  CityScene& scene = town.view.scene();
  scene.setCity(nullptr);
  scene.setCity(town.city);
  const std::array<NodeId, 1> chosen{3};
  scene.setSelection(chosen);
  const QImage before = town.view.grabImage();
  scene.setCity(town.city, town.tree);
  QCOMPARE(scene.selection(), std::vector<NodeId>{3});
  QCOMPARE(town.view.grabImage(), before);
  scene.showCut(handMadeCut(*town.tree));
  QVERIFY(changedPixels(before, town.view.grabImage()) > 500);
}

void ViewportTest::sampleTown() {
  auto city = std::make_shared<CityModel>(synthesiseCity({}));
  Viewport view;
  view.resize(1100, 700);
  view.scene().setCity(city);
  view.fit();
  const QImage picture = view.grabImage(8);
  keepPicture(picture, QStringLiteral("town"));
  view.scene().setTheme(SceneTheme::Dark);
  keepPicture(view.grabImage(8), QStringLiteral("town-dark"));
  std::set<QRgb> seen;
  for (int y = 0; y < picture.height(); y += 3) {
    for (int x = 0; x < picture.width(); x += 3) seen.insert(picture.pixel(x, y));
  }
  QVERIFY(seen.size() > 200);
}

}  // namespace lodestone::test

int main(int argc, char** argv) {
  lodestone::Viewport::setDefaultSurfaceFormat();
  QApplication application(argc, argv);
  lodestone::test::ViewportTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "viewport_test.moc"
