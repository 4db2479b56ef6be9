// Visibility analysis in the real window, on a scene like the paper's figure 17: placed, dragged and typed
// viewpoints; what is seen past each model is what the algorithm by itself says.
#include "gui/simplification/sight.h"

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <fstream>

#include <nlohmann/json.hpp>

#include "gui/simplification/sight_panel.h"
#include "gui/simplification/sight_picture.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_view.h"
#include "gui/window/stage_window.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/parameter_panel.h"
#include "model/io/places/georeference.h"
#include "tests/gui/workbench_support.h"
#include "tests/support/blocked_view.h"

namespace lodestone {
namespace {

using Json = nlohmann::json;

/// A CityJSON file: buildings of parts, in millimetres.
class CityFile {
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
std::vector<Faces> plainBlock() {
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

std::vector<std::uint32_t> seenIn(const Sighting& sighting) {
  std::vector<std::uint32_t> seen;
  for (std::uint32_t t = 0; t < sighting.pixels.size(); ++t) {
    if (sighting.sees(t)) seen.push_back(t);
  }
  return seen;
}

}  // namespace

class SightTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void saysWhatIsMissingWithoutACity();
  void placesTheViewpointWithAClick();
  void saysWhenTheEyeIsInsideABuilding();
  void figure17();
  void followsTheRate();
  void dragsTheViewpoint();
  void typesTheViewpoint();
  void goesToTheCameraAndBack();
  void rowsMarkAndFly();
  void escapesAndIsRemoved();
  void isDrawnInTheDark();

 private:
  [[nodiscard]] StageWindow& stageWindow() { return window_->stage(); }
  [[nodiscard]] Stage& stage() { return stageWindow().stage(); }
  [[nodiscard]] Sight& sight() { return stageWindow().sight(); }
  [[nodiscard]] SightPanel& panel() { return stageWindow().visibility(); }
  [[nodiscard]] BuildingScene& scene() { return stageWindow().view().scene(); }
  [[nodiscard]] QImage image() { return stageWindow().view().view().grabImage(); }
  [[nodiscard]] QWidget* surface() { return stageWindow().view().view().childAt(5, 5); }
  void openBlock(const QString& file = QStringLiteral("plain.city.json"));
  void settle();
  /// The viewpoint of the algorithm's own test.
  void standBeforeTheBlock();
  /// Fits once, and once more where that shows the building alone.
  void showEverything();
  /// Where a point of the first pane is in the widget.
  [[nodiscard]] QPoint widgetPoint(const Vec3& point);
  void drag(const Vec3& from, const Vec3& to);
  void compareMethods();
  /// What the algorithm sees past a model, by building of the city.
  [[nodiscard]] std::vector<std::uint32_t> reference(const ComponentMesh& model);
  [[nodiscard]] std::vector<std::uint32_t> shown(Past past);

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

void SightTest::initTestCase() {
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

void SightTest::init() {
  window_ = makeWindow();
  window_->useDefaultLayout();
}

void SightTest::settle() {
  QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A) && stage().level(Stage::A)->report, kLong);
  QTRY_VERIFY_WITH_TIMEOUT(!sight().isOutdated() && !window_->workspace().tasks().busy(), kLong);
}

void SightTest::openBlock(const QString& file) {
  window_->openFiles({folder_.filePath(file)}, false);
  QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().state().city && !window_->workspace().tasks().busy(), kLong);
  const NodeId block = window_->workspace().buildingsOf({"block"}).front();
  QVERIFY(block != kNoNode);
  window_->workspace().select({block});
  window_->findChild<QAction*>(QStringLiteral("simplifyBuilding"))->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
  QCOMPARE(stage().staged()->buildings.size(), 1U);
  window_->findChild<QAction*>(QStringLiteral("showVisibility"))->trigger();
  settle();
}

void SightTest::standBeforeTheBlock() {
  const Box3 box = scene().bounds();  // the slab begins at (−0.5, −0.4, −0.15)
  const Vec3 origin = box.min - Vec3(-0.5, -0.4, -0.15);
  SightOptions options = sight().options();
  options.standAt(origin + Vec3(16, -25, 0));
  options.lookAlong(Vec3(0, 1, 0.1));
  options.angle = 70;
  options.distance = 90;
  sight().setOptions(options, QStringLiteral("test"));
}

void SightTest::compareMethods() {
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

void SightTest::showEverything() {
  SceneWidget& view = stageWindow().view().view();
  view.fit();
  const auto end = scene().project(0, handlePoint(sight().options(), SightHandle::Far));
  const auto feet = scene().project(0, sight().options().foot());
  if (!end || !feet || end->y() < 0 || feet->y() >= image().height()) view.fit();
  (void)image();
}

QPoint SightTest::widgetPoint(const Vec3& point) {
  const auto pixel = scene().project(0, point);
  return pixel ? (QPointF(pixel->x(), pixel->y()) / window_->devicePixelRatioF()).toPoint() : QPoint(-1, -1);
}

void SightTest::drag(const Vec3& from, const Vec3& to) {
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

std::vector<std::uint32_t> SightTest::reference(const ComponentMesh& model) {
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

std::vector<std::uint32_t> SightTest::shown(Past past) {
  std::vector<std::uint32_t> buildings;
  for (const std::uint32_t target : seenIn(*sight().sighting(past)))
    buildings.push_back(sight().seen()->around->buildings[target]);
  return buildings;
}

void SightTest::saysWhatIsMissingWithoutACity() {
  window_->openFiles({folder_.filePath(QStringLiteral("lonely.city.json"))}, false);
  QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
  settle();
  QVERIFY(!sight().hasTargets());
  QVERIFY(!panel().placeButton().isEnabled());
  const auto* state = window_->findChild<QLabel*>(QStringLiteral("sightState"));
  QVERIFY2(state->text().contains(QStringLiteral("Add a city")), qPrintable(state->text()));
  window_->findChild<QAction*>(QStringLiteral("showVisibility"))->trigger();
  keepPicture(*window_, QStringLiteral("sight-lonely"));
}

void SightTest::placesTheViewpointWithAClick() {
  openBlock();
  QVERIFY(!scene().surroundings());
  panel().placeButton().click();
  QVERIFY(sight().isPlacing());
  settle();
  QVERIFY(scene().surroundings());  // what stands around helps to place it
  QCOMPARE(scene().surroundings()->buildings.size(), std::size_t{kTargets});
  const Vec3 centre = scene().bounds().center();
  const Vec3 ground(centre.x(), scene().bounds().min.y() - 24, scene().groundHeight());
  const Vec3 room = Vec3::Constant(26);
  stageWindow().view().view().fitTo({scene().bounds().min - room, scene().bounds().max + room});
  const Camera before = scene().camera();
  QTest::mouseClick(surface(), Qt::LeftButton, Qt::NoModifier, widgetPoint(ground));
  QVERIFY(!sight().isPlacing());
  QVERIFY(sight().options().placed);
  QVERIFY((sight().options().foot() - ground).norm() < 0.5);
  QCOMPARE(sight().options().height, 1.7);
  QVERIFY(sight().options().heading < 5 || sight().options().heading > 355);  // to the block
  QVERIFY(scene().camera() == before);
  settle();
  QCOMPARE(shown(Past::Original), reference(*stage().staged()->mesh));
  QVERIFY(!shown(Past::Original).empty());
  keepPicture(*window_, QStringLiteral("sight-placed"));
}

void SightTest::saysWhenTheEyeIsInsideABuilding() {
  openBlock();
  const auto* state = panel().findChild<QLabel*>(QStringLiteral("sightState"));
  const auto& city = *window_->workspace().state().city;
  const NodeId inside = window_->workspace().buildingsOf({"target 3"}).front();
  const Box3 box = bounds(city.buildings[inside]);
  SightOptions options = sight().options();
  for (const bool within : {true, false}) {
    Vec3 eye = box.center();
    if (!within) eye.z() = box.max.z() + 1;
    options.standAt(eye - Vec3(0, 0, options.height));
    sight().setOptions(options, QStringLiteral("test"));
    settle();
    QVERIFY(sight().seen());
    QCOMPARE(sight().seen()->enclosing.has_value(), within);
    QCOMPARE(state->text().contains(QStringLiteral("inside target 3")), within);
  }
}

void SightTest::figure17() {
  openBlock(QStringLiteral("street.city.json"));
  standBeforeTheBlock();
  compareMethods();
  QCOMPARE(shown(Past::Original), reference(*stage().staged()->mesh));
  QCOMPARE(shown(Past::A), reference(stage().level(Stage::A)->simplified->mesh));
  QCOMPARE(shown(Past::B), reference(stage().level(Stage::B)->simplified->mesh));
  const std::vector<std::uint32_t> original = shown(Past::Original);
  QVERIFY(original.size() > 4 && original.size() < 16);
  const auto count = [&](Past one, Past other) {
    return seenOnlyIn(*sight().sighting(one), *sight().sighting(other)).size();
  };
  // In the quarter of the pixels that the algorithm's own test has, ours shows what the original does.
  const std::size_t ours = count(Past::A, Past::Original);
  const std::size_t appeared = count(Past::B, Past::Original);
  const std::size_t vanished = count(Past::Original, Past::B);
  QVERIFY(ours <= 1);
  QCOMPARE(count(Past::Original, Past::A), std::size_t{0});
  QVERIFY(appeared > ours);
  QCOMPARE(panel().count(TargetFate::Seen, Past::Original).text(), QString::number(original.size()));
  QCOMPARE(panel().count(TargetFate::Appeared, Past::A).text(), QString::number(ours));
  QCOMPARE(panel().count(TargetFate::Appeared, Past::B).text(), QString::number(appeared));
  QCOMPARE(panel().count(TargetFate::Vanished, Past::B).text(), QString::number(vanished));
  auto* table = window_->findChild<QTableWidget*>(QStringLiteral("sightTargets"));
  int differ = 0;
  int ever = 0;
  for (std::uint32_t i = 0; i < kTargets; ++i) {
    const bool first = sight().sighting(Past::Original)->sees(i);
    const bool a = sight().sighting(Past::A)->sees(i);
    const bool b = sight().sighting(Past::B)->sees(i);
    differ += a != first || b != first ? 1 : 0;
    ever += a || b || first ? 1 : 0;
  }
  QCOMPARE(table->rowCount(), differ);
  window_->findChild<QCheckBox*>(QStringLiteral("sightDiffering"))->setChecked(false);
  QCOMPARE(table->rowCount(), ever);
  for (const Past past : kPasts) QCOMPARE(panel().picture(past).image().size(), QSize(1024, 512));
  showEverything();
  keepPicture(*window_, QStringLiteral("sight-figure-17"));
}

void SightTest::followsTheRate() {
  openBlock();
  standBeforeTheBlock();
  settle();
  const auto before = sight().seen();
  SimplifyOptions options = stage().options(Stage::A);
  options.method = SimplifyMethod::Qem;
  for (const double rate : {0.6, 0.7, 0.8, 0.9}) {  // faster than anybody looks
    options.rate = rate;
    stage().setOptions(Stage::A, options, QStringLiteral("test"));
    QTest::qWait(30);
  }
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isOutdated(Stage::A), kLong);
  QVERIFY(sight().isOutdated());
  QVERIFY(sight().sighting(Past::A));  // the last good result stays
  settle();
  QCOMPARE(sight().seen()->models[1].get(), &stage().level(Stage::A)->simplified->mesh);
  QCOMPARE(shown(Past::A), reference(stage().level(Stage::A)->simplified->mesh));
  QCOMPARE(sight().sighting(Past::Original), before->sightings[0].get());  // not looked past again
}

void SightTest::dragsTheViewpoint() {
  openBlock();
  standBeforeTheBlock();
  settle();
  stageWindow().layoutAction(0)->trigger();
  stageWindow().view().view().setPlanView(true);
  showEverything();
  const Camera camera = scene().camera();
  const SightOptions first = sight().options();
  drag(handlePoint(first, SightHandle::Far), first.foot() + Vec3(20, 30, 0));
  const SightOptions turned = sight().options();
  QVERIFY(std::abs(turned.heading - std::atan2(20, 30) * 180 / M_PI) < 2);
  QVERIFY(std::abs(turned.distance - std::hypot(20, 30)) < 2);
  QCOMPARE(turned.angle, first.angle);
  drag(handlePoint(turned, SightHandle::Left), turned.foot() + Vec3(-10, 30, 0));
  const SightOptions opened = sight().options();
  QVERIFY(std::abs(opened.angle - 2 * (turned.heading + std::atan2(10, 30) * 180 / M_PI)) < 4);
  QCOMPARE(opened.heading, turned.heading);
  drag(opened.foot(), opened.foot() + Vec3(-5, -5, 0));
  QVERIFY((sight().options().foot() - opened.foot() - Vec3(-5, -5, 0)).norm() < 1);
  QVERIFY(scene().camera() == camera);
  for (const SightOptions& step : {opened, turned, first}) {
    window_->workspace().session().undo();  // a drag is one step
    QCOMPARE(sight().options(), step);
  }
  keepPicture(*window_, QStringLiteral("sight-plan"));
  panel().placeButton().click();
  drag(first.foot() + Vec3(6, -2, 0), first.foot() + Vec3(-10, 20, 0));
  QVERIFY((sight().options().foot() - first.foot() - Vec3(6, -2, 0)).norm() < 1);
  QVERIFY(std::abs(sight().options().distance - std::hypot(16, 22)) < 2);
  window_->workspace().session().undo();
  QCOMPARE(sight().options(), first);
}

void SightTest::typesTheViewpoint() {
  openBlock();
  standBeforeTheBlock();
  settle();
  const std::tuple<const char*, double SightOptions::*, double> typed[] = {
      {"heading", &SightOptions::heading, 12.5},
      {"tilt", &SightOptions::tilt, -3},
      {"angle", &SightOptions::angle, 44},
      {"distance", &SightOptions::distance, 35},
      {"height", &SightOptions::height, 9.5}};
  for (const auto& [name, member, value] : typed) {
    auto* box = qobject_cast<QDoubleSpinBox*>(panel().fields().editor(name));
    QVERIFY(box);
    box->setValue(value);
    QCOMPARE(sight().options().*member, value);
  }
  settle();
  QCOMPARE(shown(Past::Original), reference(*stage().staged()->mesh));
  QVERIFY(sight().seen()->within < kTargets);  // 35 m do not reach them all

  auto* position = window_->findChild<QLineEdit*>(QStringLiteral("sightPosition"));
  const auto type = [&](const QString& text) {
    position->setFocus();
    position->selectAll();
    QTest::keyClicks(position, text);
    QTest::keyClick(position, Qt::Key_Return);
  };
  const Vec3 eye(16, -20, 3);
  const Vec3 world = toWorld(*stage().staged()->city, eye);
  type(QStringLiteral("%1; %2 %3").arg(world.x()).arg(world.y()).arg(world.z()));
  QVERIFY((sight().options().eye() - eye).norm() < 1e-6);
  const QString said = position->text();
  type(QStringLiteral("nowhere; 1; 2"));
  QCOMPARE(position->text(), said);
  QVERIFY((sight().options().eye() - eye).norm() < 1e-6);

  // What a drag gave is said as the box says it.
  SightOptions dragged = sight().options();
  dragged.distance = 155.902;
  sight().setOptions(dragged, QStringLiteral("test"));
  settle();
  const auto* distance = qobject_cast<QDoubleSpinBox*>(panel().fields().editor("distance"));
  const auto* state = window_->findChild<QLabel*>(QStringLiteral("sightState"));
  QVERIFY2(state->text().contains(QStringLiteral("within %1.").arg(distance->text())),
           qPrintable(state->text()));
  window_->findChild<QAction*>(QStringLiteral("showVisibility"))->trigger();
  QTest::qWait(50);
  for (const char* name : {"sightFromCamera", "sightLook", "sightRemove"}) {
    const auto* button = window_->findChild<QToolButton*>(QString::fromLatin1(name));
    QVERIFY2(!button->text().isEmpty() && button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon, name);
    QVERIFY2(button->width() >= button->sizeHint().width() && panel().rect().contains(button->geometry()),
             name);
  }
}

void SightTest::goesToTheCameraAndBack() {
  openBlock();
  standBeforeTheBlock();
  settle();
  const SightOptions before = sight().options();
  window_->findChild<QToolButton*>(QStringLiteral("sightLook"))->click();
  const Camera camera = scene().camera();
  QVERIFY((camera.eye - before.eye()).norm() < 1e-6);
  QVERIFY(((camera.target - camera.eye).normalized() - before.direction()).norm() < 1e-6);
  (void)image();
  window_->findChild<QToolButton*>(QStringLiteral("sightFromCamera"))->click();
  const SightOptions after = sight().options();
  QVERIFY((after.eye() - before.eye()).norm() < 1e-6);
  QVERIFY(std::abs(after.heading - before.heading) < 1e-6 && std::abs(after.tilt - before.tilt) < 1e-6);
  QVERIFY(after.angle > 10 && after.angle < 120 && after.angle != before.angle);
  keepPicture(*window_, QStringLiteral("sight-from-there"));
}

void SightTest::rowsMarkAndFly() {
  openBlock();
  standBeforeTheBlock();
  compareMethods();
  auto* table = window_->findChild<QTableWidget*>(QStringLiteral("sightTargets"));
  QVERIFY(table->rowCount() > 0);
  table->selectRow(0);
  QVERIFY(sight().target());
  const Camera before = scene().camera();
  Q_EMIT table->itemActivated(table->item(0, 0));
  QVERIFY(!(scene().camera() == before));
  const Vec3 centre = boxOf(*scene().surroundings(), *sight().target()).center();
  const auto seen = scene().project(0, centre);
  const auto [left, right] = scene().spanOf(0);
  QVERIFY(seen && std::abs(seen->x() - (left + right) / 2) < (right - left) / 4);
  sight().choose({});
  QVERIFY(table->selectionModel()->selectedRows().isEmpty());
  (void)image();
  QTest::mouseClick(surface(), Qt::LeftButton, Qt::NoModifier, widgetPoint(centre));
  QVERIFY(sight().target());
  QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
}

void SightTest::escapesAndIsRemoved() {
  openBlock();
  panel().placeButton().click();
  QTest::keyClick(&stageWindow().view().view(), Qt::Key_Escape);
  QVERIFY(!sight().isPlacing());
  QVERIFY(!panel().placeButton().isChecked());
  standBeforeTheBlock();
  settle();
  QVERIFY(scene().surroundings() && scene().sight());
  window_->findChild<QToolButton*>(QStringLiteral("sightRemove"))->click();
  QVERIFY(!scene().surroundings() && !scene().sight());
  window_->workspace().session().undo();
  settle();
  QVERIFY(scene().surroundings() && scene().sight());
  stage().close();
  QVERIFY(!scene().surroundings() && !sight().seen());
}

void SightTest::isDrawnInTheDark() {
  QApplication::setPalette(paletteOf(Appearance::Dark));
  openBlock();
  standBeforeTheBlock();
  compareMethods();
  showEverything();
  keepPicture(*window_, QStringLiteral("sight-dark"));
  // A target that is seen past the original has its colour in the first pane, lighter or darker.
  const std::uint32_t target = seenIn(*sight().sighting(Past::Original)).back();
  const Rgb& given = darkPalette().seen;
  const QImage picture = image();
  const Box3 box = boxOf(*scene().surroundings(), target);
  const auto roof = scene().project(0, Vec3(box.center().x(), box.center().y(), box.max.z()));
  QVERIFY(roof);
  const QColor colour = picture.pixelColor(qRound(roof->x()), qRound(roof->y()));
  const int turn = std::abs(colour.hsvHue() - QColor::fromRgbF(given[0], given[1], given[2]).hsvHue());
  QVERIFY2(std::min(turn, 360 - turn) < 25, qPrintable(colour.name()));
  QApplication::setPalette(paletteOf(Appearance::Light));
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::SightTest>(argc, argv);
}

#include "sight_test.moc"
