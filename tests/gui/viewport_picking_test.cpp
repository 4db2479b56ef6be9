// What stands under the cursor of the 3D view, against rays cast the slow way.
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <random>
#include <set>

#include "tests/gui/viewport_support.h"

namespace lodestone::test {
namespace {

constexpr int kBorder = 4;  // pixels beside a silhouette that ink, halo and outline may change

/// Whether a node has a triangle at this very point.
inline bool touches(const CityScene& scene, NodeId node, const Vec3& point) {
  bool found = false;
  scene.forEachTriangle([&](const std::array<Vec3, 3>& t, NodeId owner) {
    if (owner != node || found) return;
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    found = std::abs(normal.dot(point - t[0])) < 1e-4;
  });
  return found;
}

}  // namespace

class ViewportPickingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void picksWhatTheSlowWayPicks_data();
  void picksWhatTheSlowWayPicks();
  void hoverColoursExactlyThePickedNode();
  void clickAndHoverTell();
};

void ViewportPickingTest::picksWhatTheSlowWayPicks_data() {
  addViews();
}

void ViewportPickingTest::picksWhatTheSlowWayPicks() {
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

void ViewportPickingTest::hoverColoursExactlyThePickedNode() {
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

void ViewportPickingTest::clickAndHoverTell() {
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

}  // namespace lodestone::test

int main(int argc, char** argv) {
  return lodestone::test::runViewportTest<lodestone::test::ViewportPickingTest>(argc, argv);
}
#include "viewport_picking_test.moc"
