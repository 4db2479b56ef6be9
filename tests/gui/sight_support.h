// A street like the paper's figure 17 in the real window, for tests of visibility.
#pragma once

#include <QAction>
#include <QGroupBox>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <fstream>

#include <nlohmann/json.hpp>

#include "gui/simplification/sight.h"
#include "gui/simplification/sight_panel.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_view.h"
#include "gui/window/stage_window.h"
#include "tests/gui/workbench_support.h"
#include "tests/support/blocked_view.h"

namespace lodestone {

/// A CityJSON file: buildings of parts, in millimetres.
class CityFile {
  using Json = nlohmann::json;

 public:
  void add(const std::string& id, const std::vector<Faces>& parts) {
    Json children = Json::array();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string part = id + "-" + std::to_string(i);
      children.push_back(part);
      objects_[part] = {{"type", "BuildingPart"}, {"parents", {id}}, {"geometry", {surfaces(parts[i])}}};
    }
    objects_[id] = {{"type", "Building"}, {"children", children}};
  }
  void write(const QString& path) const {
    std::ofstream(path.toStdString())
        << Json{{"type", "CityJSON"},
                {"version", "2.0"},
                {"transform", {{"scale", {1e-6, 1e-6, 1e-6}}, {"translate", {0, 0, 0}}}},
                {"CityObjects", objects_},
                {"vertices", vertices_}};
  }

 private:
  Json surfaces(const Faces& faces) {
    Json boundaries = Json::array();
    for (const auto& face : faces) {
      Json ring = Json::array();
      for (const Vec3& p : face) {
        ring.push_back(vertices_.size());
        vertices_.push_back(
            {std::llround(p.x() * 1e6), std::llround(p.y() * 1e6), std::llround(p.z() * 1e6)});
      }
      boundaries.push_back({ring});
    }
    return {{"type", "MultiSurface"}, {"lod", "3"}, {"boundaries", boundaries}};
  }

  Json objects_ = Json::object();
  Json vertices_ = Json::array();
};

/// The block of figure 17 with a box for each panel.
inline std::vector<Faces> plainBlock() {
  std::vector<Faces> parts;
  for (const Faces& panel : panelledBlock()) {
    Box3 box;
    for (const auto& face : panel) {
      for (const Vec3& p : face) box.add(p);
    }
    parts.push_back(boxFaces(box.min, box.max));
  }
  return parts;
}

inline std::vector<std::uint32_t> seenIn(const Sighting& sighting) {
  std::vector<std::uint32_t> seen;
  for (std::uint32_t t = 0; t < sighting.pixels.size(); ++t) {
    if (sighting.sees(t)) seen.push_back(t);
  }
  return seen;
}

/// The block on the stage, the targets around it, and a viewpoint before them.
class SightFixture : public QObject {
 protected:
  void writeStreets() {
    CityFile city;
    city.add("block", panelledBlock());
    for (std::uint32_t i = 0; i < kTargets; ++i) city.add("target " + std::to_string(i), {targetFaces(i)});
    city.write(folder_.filePath(QStringLiteral("street.city.json")));
    CityFile plain;  // the same of fewer triangles, for what does not depend on them
    plain.add("block", plainBlock());
    for (std::uint32_t i = 0; i < kTargets; ++i) plain.add("target " + std::to_string(i), {targetFaces(i)});
    plain.write(folder_.filePath(QStringLiteral("plain.city.json")));
    CityFile lonely;
    lonely.add("block",
               {boxFaces(Vec3(0, 0, 0), Vec3(10, 10, 10)), boxFaces(Vec3(0, 0, 10), Vec3(10, 10, 12))});
    lonely.write(folder_.filePath(QStringLiteral("lonely.city.json")));
  }

  void openWindow() {
    window_ = makeWindow();
    window_->useDefaultLayout();
  }

  [[nodiscard]] StageWindow& stageWindow() { return window_->stage(); }
  [[nodiscard]] Stage& stage() { return stageWindow().stage(); }
  [[nodiscard]] Sight& sight() { return stageWindow().sight(); }
  [[nodiscard]] SightPanel& panel() { return stageWindow().visibility(); }
  [[nodiscard]] BuildingScene& scene() { return stageWindow().view().scene(); }
  [[nodiscard]] QImage image() { return stageWindow().view().view().grabImage(); }
  [[nodiscard]] QWidget* surface() { return stageWindow().view().view().childAt(5, 5); }

  void settle() {
    QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A) && stage().level(Stage::A)->report, kLong);
    QTRY_VERIFY_WITH_TIMEOUT(!sight().isOutdated() && !window_->workspace().tasks().busy(), kLong);
  }

  void openBlock(const QString& file = QStringLiteral("plain.city.json")) {
    window_->openFiles({folder_.filePath(file)}, false);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().state().city && !window_->workspace().tasks().busy(),
                             kLong);
    const NodeId block = window_->workspace().buildingsOf({"block"}).front();
    QVERIFY(block != kNoNode);
    window_->workspace().select({block});
    window_->findChild<QAction*>(QStringLiteral("simplifyBuilding"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
    QCOMPARE(stage().staged()->buildings.size(), 1U);
    window_->findChild<QAction*>(QStringLiteral("showVisibility"))->trigger();
    settle();
  }

  /// The viewpoint of the algorithm's own test.
  void standBeforeTheBlock() {
    const Box3 box = scene().bounds();  // the slab begins at (−0.5, −0.4, −0.15)
    const Vec3 origin = box.min - Vec3(-0.5, -0.4, -0.15);
    SightOptions options = sight().options();
    options.standAt(origin + Vec3(16, -25, 0));
    options.lookAlong(Vec3(0, 1, 0.1));
    options.angle = 70;
    options.distance = 90;
    sight().setOptions(options, QStringLiteral("test"));
  }

  void compareMethods() {
    SimplifyOptions a;
    a.rate = 0.8;
    a.a = 8;
    SimplifyOptions b;
    b.method = SimplifyMethod::Qem;
    b.rate = 0.8;
    stage().setOptions(Stage::A, a, QStringLiteral("test"));
    stage().setOptions(Stage::B, b, QStringLiteral("test"));
    stageWindow().method().compareBox().setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(!stage().isOutdated(Stage::A) && !stage().isOutdated(Stage::B), kLong);
    settle();
  }

  /// Fits once, and once more where that shows the building alone.
  void showEverything() {
    SceneWidget& view = stageWindow().view().view();
    view.fit();
    const auto end = scene().project(0, handlePoint(sight().options(), SightHandle::Far));
    const auto feet = scene().project(0, sight().options().foot());
    if (!end || !feet || end->y() < 0 || feet->y() >= image().height()) view.fit();
    (void)image();
  }

  /// Where a point of the first pane is in the widget.
  [[nodiscard]] QPoint widgetPoint(const Vec3& point) {
    const auto pixel = scene().project(0, point);
    return pixel ? (QPointF(pixel->x(), pixel->y()) / window_->devicePixelRatioF()).toPoint()
                 : QPoint(-1, -1);
  }

  void drag(const Vec3& from, const Vec3& to) {
    const QPoint begin = widgetPoint(from);
    const QPoint end = widgetPoint(to);
    QTest::mousePress(surface(), Qt::LeftButton, Qt::NoModifier, begin);
    for (const double share : {0.3, 0.6, 1.0}) {
      const QPointF at = QPointF(begin) + share * QPointF(end - begin);
      QMouseEvent move(QEvent::MouseMove, at, surface()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       Qt::NoModifier);
      QApplication::sendEvent(surface(), &move);
    }
    QTest::mouseRelease(surface(), Qt::LeftButton, Qt::NoModifier, end);
  }

  /// What the algorithm sees past a model, by building of the city.
  [[nodiscard]] std::vector<std::uint32_t> reference(const ComponentMesh& model) {
    const CityModel& city = *window_->workspace().state().city;
    OwnedTriangles triangles;
    addBuildings(
        city, [](std::uint32_t building) { return building; }, triangles);
    OwnedTriangles targets;
    targets.vertices = triangles.vertices;
    for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
      if (triangles.owner[t] == stage().building()) continue;
      targets.triangles.push_back(triangles.triangles[t]);
      targets.owner.push_back(triangles.owner[t]);
    }
    addMesh(model, kBlocked, targets);
    const SightOptions& options = sight().options();
    const Viewpoint from{options.eye(), options.direction(), options.angle, options.distance, 1024, 512};
    return seenIn(lookFrom(from, targets, static_cast<std::uint32_t>(city.buildings.size())));
  }

  [[nodiscard]] std::vector<std::uint32_t> shown(Past past) {
    std::vector<std::uint32_t> buildings;
    for (const std::uint32_t target : seenIn(*sight().sighting(past)))
      buildings.push_back(sight().seen()->around->buildings[target]);
    return buildings;
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace lodestone
