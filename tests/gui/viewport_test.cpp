// The 3D view on both backends: what it draws is looked at pixel by pixel and compared with rays cast the
// slow way.
#include <QTest>
#include <set>

#include "algorithms/synthesis/synthesis.h"
#include "tests/gui/viewport_support.h"

namespace lodestone::test {
namespace {

constexpr int kBorder = 4;  // pixels beside a silhouette that ink, halo and outline may change

}  // namespace

class ViewportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hasContext();
  void drawsBuildingsWhereTheCameraProjectsThem_data();
  void drawsBuildingsWhereTheCameraProjectsThem();
  void cutChangesThePicture();
  void selectionMarksDrawnAncestorsAndDescendants();
  void overlaysChangeThePicture_data();
  void overlaysChangeThePicture();
  void themeChangesThePicture();
  void sameSceneGivesSamePixels();
  void oddCities_data();
  void oddCities();
  void farFromTheOrigin();
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
  addViews();
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
  const auto middle =
      view.scene().pick(view.scene().camera().width / 2.0, view.scene().camera().height / 2.0);
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
  return lodestone::test::runViewportTest<lodestone::test::ViewportTest>(argc, argv);
}
#include "viewport_test.moc"
