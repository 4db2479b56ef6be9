// Layers as a person styles them, and what a fit of the view looks at.
#include <QAction>
#include <QComboBox>
#include <QJsonObject>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <functional>

#include "gui/city/layer_style_row.h"
#include "gui/city/layers_panel.h"
#include "gui/workspace/jobs.h"
#include "tests/gui/scene_support.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {
namespace {

using test::boxBuilding;
using test::smallTown;

/// A square of terrain, far larger than the town on it.
CityObject terrain(double side) {
  CityObject object;
  object.id = "terrain";
  object.type = ObjectType::Relief;
  Geometry geometry;
  geometry.lod = "1";
  geometry.addRing(
      {Vec3(-side, -side, -1), Vec3(side, -side, -1), Vec3(side, side, -1), Vec3(-side, side, -1)});
  geometry.finishSurface();
  object.geometries.push_back(std::move(geometry));
  return object;
}

}  // namespace

class LayersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { window_ = makeWindow(); }
  void cleanup() { window_.reset(); }

  void opacityLetsTheGroundThrough();
  void colourIsThatOfTheBuildings();
  void linesHaveAStyleOfTheirOwn();
  void aFitLeavesStraysAsideAtFirst();
  void oneBuildingIsOne();
  void stylesBelongToTheirProject();
  void looksAreStepsOfTheProject();
  void draggedOpacityIsOneStep();
  void anyTextIsAView();
  void looksLeaveTheCutAlone();

 private:
  [[nodiscard]] Workspace& workspace() { return window_->workspace(); }
  [[nodiscard]] CityScene& scene() { return window_->viewport().scene(); }
  void openTown(std::shared_ptr<CityModel> city) {
    ProjectState state;
    state.city = std::move(city);
    workspace().session().commit(std::move(state), "test");
    QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);  // it is meshed on another thread
  }
  /// The pixel in the middle of a building's roof.
  [[nodiscard]] QColor roof(NodeId node) {
    const QImage picture = window_->viewport().grabImage();
    const Box3 box = scene().boundsOf(node);
    const auto at = scene().project(Vec3(box.center().x(), box.center().y(), box.max.z()));
    return picture.pixelColor(static_cast<int>(at->x()), static_cast<int>(at->y()));
  }
  [[nodiscard]] QTreeWidget& tree() { return *window_->findChild<QTreeWidget*>(QStringLiteral("layerTree")); }
  [[nodiscard]] LayerStyleRow& row() { return *window_->layers().findChild<LayerStyleRow*>(); }

  std::unique_ptr<MainWindow> window_;
};

void LayersTest::opacityLetsTheGroundThrough() {
  openTown(smallTown(3));
  const QColor full = roof(0);
  auto* slider = window_->findChild<QSlider*>(QStringLiteral("layerOpacity"));
  QVERIFY(slider->isEnabled());  // the city is the chosen layer from the start
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Home);
  QCOMPARE(scene().layerStyle(SceneLayer::Buildings).opacity, 0.0F);
  const QColor none = roof(0);
  scene().setLayerStyle(SceneLayer::Buildings, {.visible = false});
  const QColor ground = roof(0);
  QVERIFY2(std::abs(none.red() - ground.red()) < 8, qPrintable(none.name() + ground.name()));
  QVERIFY2(std::abs(full.red() - ground.red()) > 8, qPrintable(full.name() + ground.name()));
  QTest::keyClick(slider, Qt::Key_End);
  QCOMPARE(roof(0), full);
}

void LayersTest::colourIsThatOfTheBuildings() {
  openTown(smallTown(3));
  const QColor before = roof(0);
  row().setColour(Rgb{1, 0, 0});
  const QColor after = roof(0);
  QVERIFY2(after.red() > 2 * after.green() && after.red() > 2 * after.blue(), qPrintable(after.name()));
  row().setColour({});
  QCOMPARE(roof(0), before);
  tree().topLevelItem(0)->setCheckState(0, Qt::Unchecked);
  QVERIFY(!scene().layerStyle(SceneLayer::Buildings).visible);
  QVERIFY(!scene().pick(scene().camera().width / 2.0, scene().camera().height / 2.0));
}

void LayersTest::linesHaveAStyleOfTheirOwn() {
  workspace().openSample();
  QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
  QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);
  QTreeWidgetItem* lines = nullptr;
  for (int i = 0; i < tree().topLevelItemCount(); ++i) {
    if (tree().topLevelItem(i)->text(0) == QStringLiteral("Lines")) lines = tree().topLevelItem(i);
  }
  QVERIFY(lines && !lines->isHidden());
  tree().setCurrentItem(lines->child(0));
  const QImage before = window_->viewport().grabImage();
  row().setColour(Rgb{1, 0, 0});
  const QImage red = window_->viewport().grabImage();
  int reds = 0;
  for (int y = 0; y < red.height(); ++y) {
    for (int x = 0; x < red.width(); ++x) {
      const QColor c = red.pixelColor(x, y);
      reds += c.red() > 150 && c.red() > 1.5 * c.green() && c.red() > 1.5 * c.blue() ? 1 : 0;
    }
  }
  QVERIFY2(reds > 50, qPrintable(QString::number(reds)));
  QVERIFY(!scene().layerStyle(SceneLayer::Buildings).colour);
  row().setColour({});
  QCOMPARE(window_->viewport().grabImage(), before);
}

void LayersTest::aFitLeavesStraysAsideAtFirst() {
  auto city = smallTown(6);
  city->buildings.push_back(boxBuilding("stray", 20'000, 3'000, 20, 20, 10));
  city->others.push_back(terrain(5000));
  openTown(city);
  const auto share = [&] {
    Box2 seen;
    for (NodeId node = 0; node < 36; ++node) {
      const Box3 box = scene().boundsOf(node);
      for (const Vec3& corner : {box.min, box.max}) seen.add(*scene().project(corner));
    }
    return seen.size().x() / scene().camera().width;
  };
  QVERIFY2(share() > 0.5, qPrintable(QString::number(share())));
  window_->viewport().fit();
  QVERIFY2(share() < 0.05, "fitted again, it looks at everything");
  const auto stray = scene().project(scene().boundsOf(36).center());
  QVERIFY(stray && stray->x() > 0 && stray->x() < scene().camera().width);
  window_->viewport().fit();
  QVERIFY2(share() > 0.5, "and then at the town again");
}

void LayersTest::oneBuildingIsOne() {
  auto city = std::make_shared<CityModel>();
  city->buildings.push_back(boxBuilding("alone", 0, 0, 10, 10, 5));
  openTown(std::move(city));
  QCOMPARE(tree().topLevelItem(0)->text(0), QStringLiteral("City model, 1 building"));
}

void LayersTest::stylesBelongToTheirProject() {
  const auto waitForTasks = [&] { QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong); };
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  workspace().openSample();
  waitForTasks();
  const QJsonObject first = window_->layers().view();
  row().setColour(Rgb{1, 0, 0});
  auto* opacity = window_->findChild<QSlider*>(QStringLiteral("layerOpacity"));
  opacity->setValue(40);
  tree().topLevelItem(2)->setCheckState(0, Qt::Unchecked);
  window_->layers().setShown(Overlay::Hulls, true);
  window_->layers().setShown(Overlay::Edges, false);
  auto* colours = window_->findChild<QComboBox*>(QStringLiteral("sceneColours"));
  colours->setCurrentIndex(1);
  const QJsonObject styled = window_->layers().view();
  const LayerStyle buildings = scene().layerStyle(SceneLayer::Buildings);
  workspace().markSaved(path);
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (action->shortcut() == QKeySequence(QKeySequence::Save)) action->trigger();
  }

  workspace().close();
  QCOMPARE(window_->layers().view(), first);
  QVERIFY(scene().layerStyle(SceneLayer::Buildings) == LayerStyle{});
  QVERIFY(scene().overlay(Overlay::Edges) && !scene().overlay(Overlay::Hulls));
  QCOMPARE(opacity->value(), 100);

  workspace().openProject(path);
  waitForTasks();
  QCOMPARE(window_->layers().view(), styled);
  QVERIFY(scene().layerStyle(SceneLayer::Buildings) == buildings);
  QVERIFY(!scene().layerStyle(SceneLayer::Lines).visible);
  QVERIFY(!scene().overlay(Overlay::Edges) && scene().overlay(Overlay::Hulls));
  QCOMPARE(scene().colours(), SceneColours::ByCluster);
  QCOMPARE(opacity->value(), 40);

  workspace().openSample();  // a city of its own
  waitForTasks();
  QCOMPARE(window_->layers().view(), first);
}

void LayersTest::looksAreStepsOfTheProject() {
  openTown(smallTown(3));
  Session& session = workspace().session();
  const QJsonObject first = window_->layers().view();
  auto* colours = window_->findChild<QComboBox*>(QStringLiteral("sceneColours"));
  const std::vector<std::function<void()>> edits{
      [&] {
        row().setColour(Rgb{1, 0, 0});
      },
      [&] { window_->findChild<QSlider*>(QStringLiteral("layerOpacity"))->setValue(40); },
      [&] { tree().topLevelItem(0)->setCheckState(0, Qt::Unchecked); },
      [&] { window_->layers().setShown(Overlay::Hulls, true); }, [&] { colours->setCurrentIndex(1); }};
  std::vector<QJsonObject> views{first};
  for (const auto& edit : edits) {
    session.markSaved();
    QVERIFY(!window_->isWindowModified() || !session.modified());
    edit();
    QVERIFY2(session.modified(), session.undoText().c_str());
    QVERIFY(window_->isWindowModified());
    QVERIFY(window_->layers().view() != views.back());
    views.push_back(window_->layers().view());
  }
  QCOMPARE(QString::fromStdString(session.undoText()), QStringLiteral("Change colours"));
  for (std::size_t i = edits.size(); i-- > 0;) {
    session.undo();
    QCOMPARE(window_->layers().view(), views[i]);
  }
  QVERIFY(scene().layerStyle(SceneLayer::Buildings) == LayerStyle{});
  QVERIFY(!scene().overlay(Overlay::Hulls));
  QCOMPARE(scene().colours(), SceneColours::ByRole);
  for (std::size_t i = 1; i <= edits.size(); ++i) {
    session.redo();
    QCOMPARE(window_->layers().view(), views[i]);
  }
  QVERIFY(!session.canRedo());
  QVERIFY(!scene().layerStyle(SceneLayer::Buildings).visible);
}

void LayersTest::draggedOpacityIsOneStep() {
  openTown(smallTown(3));
  auto* slider = window_->findChild<QSlider*>(QStringLiteral("layerOpacity"));
  for (int percent = 99; percent >= 50; --percent) slider->setValue(percent);
  workspace().session().undo();
  QCOMPARE(slider->value(), 100);
  QCOMPARE(scene().layerStyle(SceneLayer::Buildings).opacity, 1.0F);
}

void LayersTest::looksLeaveTheCutAlone() {
  openTown(smallTown(3));
  QSignalSpy cuts(&workspace(), &Workspace::cutChanged);
  row().setColour(Rgb{1, 0, 0});
  QCOMPARE(cuts.count(), 0);
}

void LayersTest::anyTextIsAView() {
  const QJsonObject first = window_->layers().view();
  const QJsonObject nonsense{
      {QStringLiteral("buildings"),
       QJsonObject{{QStringLiteral("opacity"), 7}, {QStringLiteral("colour"), QStringLiteral("no colour")}}},
      {QStringLiteral("lines"), 3},
      {QStringLiteral("edges"), QStringLiteral("x")}};
  window_->layers().setView(nonsense);
  QCOMPARE(window_->layers().view(), first);
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::LayersTest>(argc, argv);
}
#include "layers_test.moc"
