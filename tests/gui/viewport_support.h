// A viewport on a small town, and ways to look at its pictures.
#pragma once

#include <QApplication>
#include <QDir>
#include <QMouseEvent>
#include <QTest>

#include "gui/city/viewport.h"
#include "tests/gui/scene_support.h"

namespace lodestone::test {

inline int difference(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
}

inline std::size_t changedPixels(const QImage& a, const QImage& b) {
  std::size_t count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) count += difference(a.pixel(x, y), b.pixel(x, y)) > 6;
  }
  return count;
}

/// A pointer move as the window system sends it; QTest's own goes through the real cursor.
inline void sendMove(Viewport& view, const QPoint& at, Qt::MouseButtons buttons = Qt::NoButton) {
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

inline void keepPicture(const QImage& picture, const QString& name) {
  // LODESTONE_SCREENSHOTS names a folder in which people find what the tests saw.
  const QString folder = qEnvironmentVariable("LODESTONE_SCREENSHOTS");
  if (!folder.isEmpty() && QDir().mkpath(folder)) {
    picture.save(QDir(folder).filePath(QGuiApplication::platformName() + QLatin1Char('-') + name +
                                       QLatin1String(".png")));
  }
}

/// Rows of data: perspective and plan, of all buildings and of a cut.
inline void addViews() {
  QTest::addColumn<bool>("plan");
  QTest::addColumn<bool>("cut");
  QTest::newRow("perspective, buildings") << false << false;
  QTest::newRow("perspective, cut") << false << true;
  QTest::newRow("plan, buildings") << true << false;
  QTest::newRow("plan, cut") << true << true;
}

/// Runs one test class that needs viewports and no window.
template <class Test>
int runViewportTest(int argc, char** argv) {
  Viewport::setDefaultSurfaceFormat();
  QApplication application(argc, argv);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace lodestone::test
