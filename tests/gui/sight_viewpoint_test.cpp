// The viewpoint of visibility analysis in the real window: placed, dragged, typed, taken from the camera.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "gui/widgets/parameter_panel.h"
#include "model/io/places/georeference.h"
#include "tests/gui/sight_support.h"

namespace lodestone {

class SightViewpointTest : public SightFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { writeStreets(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void placesTheViewpointWithAClick();
  void dragsTheViewpoint();
  void typesTheViewpoint();
  void goesToTheCameraAndBack();
  void escapesAndIsRemoved();
};

void SightViewpointTest::placesTheViewpointWithAClick() {
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

void SightViewpointTest::dragsTheViewpoint() {
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

void SightViewpointTest::typesTheViewpoint() {
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

void SightViewpointTest::goesToTheCameraAndBack() {
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

void SightViewpointTest::escapesAndIsRemoved() {
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

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::SightViewpointTest>(argc, argv);
}
#include "sight_viewpoint_test.moc"
