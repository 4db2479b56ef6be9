// The widgets of the Perception dock by themselves.
#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QWheelEvent>
#include <cmath>

#include "gui/perception/difference_plot.h"
#include "gui/perception/picture_grid.h"
#include "gui/perception/sensitivity_plot.h"
#include "gui/perception/viewpoint_strip.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {
namespace {

constexpr int kSize = 256;

/// Black and white pixels like a chessboard in the left half, red in the right.
QImage chessboard() {
  QImage image(kSize, kSize, QImage::Format_RGB32);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x)
      image.setPixelColor(x, y, x >= kSize / 2 ? QColor(Qt::red) : (x + y) % 2 == 0 ? Qt::black : Qt::white);
  }
  return image;
}

std::vector<PictureGrid::Entry> entries(std::size_t count) {
  std::vector<PictureGrid::Entry> all;
  const auto picture = std::make_shared<const ZoomPicture>(chessboard());
  for (std::size_t i = 0; i < count; ++i) all.push_back({QString::number(i), {}, picture});
  return all;
}

void wheel(QWidget& widget, const QPointF& at, int steps) {
  QWheelEvent event(at, widget.mapToGlobal(at), {}, QPoint(0, 120 * steps), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

void move(QWidget& widget, const QPointF& at, Qt::MouseButtons buttons = Qt::NoButton) {
  QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, buttons, Qt::NoModifier);
  QApplication::sendEvent(&widget, &event);
}

void drag(QWidget& widget, const QPoint& from, const QPoint& to) {
  QTest::mousePress(&widget, Qt::LeftButton, Qt::NoModifier, from);
  for (const double share : {0.25, 0.5, 1.0})
    move(widget, QPointF(from) + share * QPointF(to - from), Qt::LeftButton);
  QTest::mouseRelease(&widget, Qt::LeftButton, Qt::NoModifier, to);
}

/// Four bumps.
DifferenceHistogram bumps() {
  DifferenceHistogram histogram{};
  for (int bin = 0; bin < 200; ++bin) {
    for (const auto& [middle, height] : {std::pair(4, 2e6), {40, 3e5}, {90, 4e4}, {150, 900.0}})
      histogram[static_cast<std::size_t>(bin)] +=
          static_cast<std::uint64_t>(height * std::exp(-(bin - middle) * (bin - middle) / 200.0));
  }
  return histogram;
}

DifferenceClasses fourClasses() {
  DifferenceClasses classes;
  classes.gaussians = {Gaussian{0.8, 0.2, 0.3}, Gaussian{0.15, 6, 2}, Gaussian{0.04, 32, 6},
                       Gaussian{0.01, 88, 12}};
  classes.cuts = {20, 65, 120};
  return classes;
}

void keepWidget(QWidget& widget, const QString& name) {
  const QString folder = qEnvironmentVariable("LODESTONE_SCREENSHOTS");
  if (!folder.isEmpty() && QDir().mkpath(folder)) widget.grab().save(QDir(folder).filePath(name + ".png"));
}

}  // namespace

class PerceptionWidgetsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void picturesAreZoomedAndMovedInStep();
  void pixelsAreCrispWhenMagnifiedAndSmoothWhenNot();
  void pixelUnderThePointerIsTold();
  void pictureGridFollowsTheKeyboard();
  void picturesOfAnotherSizeAreFitted();
  void cutsAreDraggedAndNeverCross();
  void cutsFollowTheKeyboard();
  void cutIsFoundAgain();
  void sharesOfAllClassesAreSaid();
  void bandsStandOnTheCurve();
  void legendOfTheCurveHasRoom();
  void stripMarksTheChosenViewpoint();
  void stripFollowsTheKeyboard();
};

void PerceptionWidgetsTest::picturesAreZoomedAndMovedInStep() {
  PictureGrid grid;
  grid.resize(1000, 280);
  grid.setPictures(entries(4));
  grid.show();
  QVERIFY(grid.isFitted());
  const QPointF at = grid.placeOf(2, {64.5, 64.5});
  wheel(grid, at, 8);
  QVERIFY(!grid.isFitted());
  QVERIFY(QLineF(grid.placeOf(2, {64.5, 64.5}), at).length() < 0.01);  // zoomed about the pointer
  const QPointF before = grid.placeOf(0, {64.5, 64.5}) - grid.cell(0).topLeft();
  for (std::size_t i = 1; i < 4; ++i)
    QVERIFY(QLineF(grid.placeOf(i, {64.5, 64.5}) - grid.cell(i).topLeft(), before).length() < 0.01);
  const QPoint from = grid.cell(3).center().toPoint();
  drag(grid, from, from + QPoint(20, -10));
  const QPointF after = grid.placeOf(0, {64.5, 64.5}) - grid.cell(0).topLeft();
  QVERIFY(QLineF(after - before, QPointF(20, -10)).length() < 1);
  QTest::mouseDClick(&grid, Qt::LeftButton, Qt::NoModifier, from);
  QVERIFY(grid.isFitted());
  wheel(grid, at, -3);
  QVERIFY(grid.isFitted());  // never smaller than that
}

void PerceptionWidgetsTest::pixelsAreCrispWhenMagnifiedAndSmoothWhenNot() {
  PictureGrid grid;
  grid.resize(300, 120);
  grid.setPictures(entries(1));
  grid.show();
  QImage shown = grid.grab().toImage();
  const auto colourAt = [&](const QPointF& pixel) {
    return QColor(shown.pixel((grid.placeOf(0, pixel) * shown.devicePixelRatio()).toPoint()));
  };
  // The board is finer than the screen: what is shown is neither black nor white, and grey in the mean.
  double sum = 0;
  int extremes = 0;
  for (int x = 40; x < 104; ++x) {
    const int red = colourAt({x + 0.5, 128}).red();
    sum += red;
    extremes += red < 8 || red > 247 ? 1 : 0;
  }
  QVERIFY2(std::abs(sum / 64 - 127.5) < 16, qPrintable(QString::number(sum / 64)));
  QVERIFY2(extremes < 16, qPrintable(QString::number(extremes)));
  wheel(grid, grid.placeOf(0, {64.5, 64.5}), 20);
  QVERIFY(grid.scale() > 8);
  move(grid, {1, 1});  // the frame of the pixel would be in the way
  shown = grid.grab().toImage();
  for (const double off : {-0.4, 0.0, 0.4}) {
    QCOMPARE(colourAt({64.5 + off, 64.5}), QColor(Qt::black));
    QCOMPARE(colourAt({65.5 + off, 64.5}), QColor(Qt::white));
  }
}

void PerceptionWidgetsTest::pixelUnderThePointerIsTold() {
  PictureGrid grid;
  grid.resize(1000, 280);
  grid.setPictures(entries(4));
  grid.setReadout([](const QPoint& p) { return QStringLiteral("%1, %2").arg(p.x()).arg(p.y()); });
  grid.show();
  const QSignalSpy picked(&grid, &PictureGrid::picked);
  move(grid, grid.placeOf(3, {200.5, 17.5}));
  QCOMPARE(grid.readout(), QStringLiteral("200, 17"));
  QTest::mouseClick(&grid, Qt::LeftButton, Qt::NoModifier, grid.placeOf(1, {100.5, 50.5}).toPoint());
  QCOMPARE(picked.size(), 1);
  move(grid, {2, 2});
  QVERIFY(!grid.pointed());
  QVERIFY(grid.readout().isEmpty());
}

void PerceptionWidgetsTest::pictureGridFollowsTheKeyboard() {
  PictureGrid grid;
  grid.resize(1000, 280);
  grid.setPictures(entries(4));
  grid.show();
  for (int i = 0; i < 6; ++i) QTest::keyClick(&grid, Qt::Key_Plus);
  QVERIFY(!grid.isFitted());
  const QPointF before = grid.placeOf(0, {0, 0});
  QTest::keyClick(&grid, Qt::Key_Right);
  QVERIFY(grid.placeOf(0, {0, 0}).x() < before.x());
  QTest::keyClick(&grid, Qt::Key_0);
  QVERIFY(grid.isFitted());
}

void PerceptionWidgetsTest::picturesOfAnotherSizeAreFitted() {
  PictureGrid grid;
  grid.resize(600, 300);
  grid.setPictures(entries(2));
  grid.show();
  wheel(grid, grid.cell(0).center(), 10);
  grid.setPictures(entries(2));
  QVERIFY(!grid.isFitted());
  grid.setPictures(
      {{QStringLiteral("other"), {}, std::make_shared<const ZoomPicture>(chessboard().copy(0, 0, 64, 48))}});
  QVERIFY(grid.isFitted());
  grid.setMessage(QStringLiteral("Nothing is seen."));
  grid.setPictures({});
  keepWidget(grid, QStringLiteral("picture-grid-empty"));
}

void PerceptionWidgetsTest::cutsAreDraggedAndNeverCross() {
  DifferencePlot plot;
  plot.resize(460, 240);
  plot.show(bumps(), fourClasses(), {});
  plot.QWidget::show();
  QSignalSpy moved(&plot, &DifferencePlot::cutMoved);
  const int y = static_cast<int>(plot.plot().center().y());
  const QPoint from(qRound(plot.placeOfCut(1)), y);
  drag(plot, from, QPoint(qRound(plot.placeOfBin(80)), y));
  QVERIFY(!moved.isEmpty());
  QCOMPARE(moved.last()[0].value<std::size_t>(), std::size_t{1});
  QVERIFY(std::abs(moved.last()[1].toInt() - 80) <= 1);
  QCOMPARE(plot.cuts()[1], moved.last()[1].toInt());
  drag(plot, QPoint(qRound(plot.placeOfCut(1)), y), QPoint(qRound(plot.placeOfBin(5)), y));
  QCOMPARE(plot.cuts()[1], plot.cuts()[0]);
  drag(plot, QPoint(qRound(plot.placeOfCut(0)), y), QPoint(0, y));
  QCOMPARE(plot.cuts()[0], 1);  // 0 would mean: found
  keepWidget(plot, QStringLiteral("difference-plot"));
}

void PerceptionWidgetsTest::cutsFollowTheKeyboard() {
  DifferencePlot plot;
  plot.resize(460, 240);
  plot.show(bumps(), fourClasses(), {});
  plot.QWidget::show();
  QTest::keyClick(&plot, Qt::Key_3);
  for (int i = 0; i < 4; ++i) QTest::keyClick(&plot, Qt::Key_Right);
  QCOMPARE(plot.cuts()[2], 124);
  QSignalSpy reset(&plot, &DifferencePlot::cutReset);
  QTest::keyClick(&plot, Qt::Key_Delete);
  QCOMPARE(reset.size(), 1);
  QCOMPARE(reset.last()[0].value<std::size_t>(), std::size_t{2});
}

void PerceptionWidgetsTest::cutIsFoundAgain() {
  DifferencePlot plot;
  plot.resize(460, 240);
  plot.clear(QStringLiteral("Nothing is seen."));
  plot.QWidget::show();
  keepWidget(plot, QStringLiteral("difference-plot-empty"));
  DifferenceClasses empty;  // classes that no pixel has
  plot.show({}, empty, {});
  keepWidget(plot, QStringLiteral("difference-plot-nothing"));
  plot.show(bumps(), fourClasses(), {true, true, true});
  QSignalSpy reset(&plot, &DifferencePlot::cutReset);
  QTest::mouseDClick(&plot, Qt::LeftButton, Qt::NoModifier,
                     QPoint(qRound(plot.placeOfCut(0)), qRound(plot.plot().center().y())));
  QCOMPARE(reset.size(), 1);
  QCOMPARE(reset.last()[0].value<std::size_t>(), std::size_t{0});
}

void PerceptionWidgetsTest::sharesOfAllClassesAreSaid() {
  DifferencePlot plot;
  DifferenceHistogram histogram{};
  histogram[0] = 9'000'000;  // classes in bands that are narrower than any word
  histogram[2] = 900'000;
  histogram[4] = 99'990;
  histogram[200] = 10;
  DifferenceClasses classes = fourClasses();
  classes.cuts = {2, 4, 6};
  plot.show(histogram, classes, {});
  for (const int width : {plot.minimumSizeHint().width(), 900}) {
    plot.resize(width, 240);
    const QStringList shares = plot.shares();
    QCOMPARE(shares.size(), static_cast<qsizetype>(kDetailClasses));
    int wide = 0;
    for (const QString& share : shares) {
      QVERIFY2(share.contains(QLatin1Char('%')), qPrintable(share));
      wide += plot.fontMetrics().horizontalAdvance(share);
    }
    QVERIFY(wide < width);
    QVERIFY2(shares.first().contains(QStringLiteral("90")), qPrintable(shares.first()));
    QVERIFY2(shares.last().contains(QLatin1Char('<')), qPrintable(shares.last()));  // few, but some
    keepWidget(plot, QStringLiteral("difference-plot-narrow-%1").arg(width));
  }
  QVERIFY2(plot.shares().first().contains(QStringLiteral("None")), qPrintable(plot.shares().first()));
}

void PerceptionWidgetsTest::legendOfTheCurveHasRoom() {
  SensitivityPlot plot;
  const QString words = QStringLiteral("weight straight diagonal");
  QVERIFY(plot.minimumSizeHint().width() > plot.fontMetrics().horizontalAdvance(words));
  plot.resize(plot.minimumSizeHint());
  keepWidget(plot, QStringLiteral("sensitivity-plot-narrow"));
}

void PerceptionWidgetsTest::bandsStandOnTheCurve() {
  SensitivityPlot plot;
  plot.resize(420, 260);
  plot.QWidget::show();
  PerceiveOptions options;
  plot.show(options);
  QCOMPARE(plot.bands().size(), std::size_t{10});
  const double pixels = options.pixelsPerDegree();
  QVERIFY(std::abs(plot.bands()[0].frequency - 0.75 * pixels / 2) < 1e-9);
  QVERIFY(std::abs(plot.bands()[5].frequency - 0.75 * pixels / 2 * std::sqrt(2)) < 1e-9);
  QVERIFY(plot.bands()[5].weight < plot.bands()[0].weight);
  QVERIFY(plot.placeOf(20, 0.5).x() > plot.placeOf(10, 0.5).x());
  keepWidget(plot, QStringLiteral("sensitivity-plot"));
  const double near = plot.bands()[0].weight;
  options.distance *= 3;  // farther: the finest band is seen less
  plot.show(options);
  QVERIFY(plot.bands()[0].weight < near);
}

void PerceptionWidgetsTest::stripMarksTheChosenViewpoint() {
  ViewpointStrip strip;
  strip.resize(600, strip.sizeHint().height());
  strip.show();
  std::vector<Camera> cameras(5);
  cameras[1].eye = Vec3(50, 50, 0);
  cameras[1].target = Vec3::Zero();
  strip.setViewpoints(cameras);
  QSignalSpy chosen(&strip, &ViewpointStrip::chosen);
  strip.choose(3);
  QVERIFY(chosen.isEmpty());
  QCOMPARE(strip.currentRow(), 3);
  QTest::mouseClick(strip.viewport(), Qt::LeftButton, Qt::NoModifier,
                    strip.visualItemRect(strip.item(1)).center());
  QCOMPARE(chosen.size(), 1);
  QCOMPARE(chosen.last()[0].value<std::size_t>(), std::size_t{1});
  QCOMPARE(directionText(cameras[1]), QStringLiteral("from the north-east"));
  strip.setPicture(1, chessboard().scaled(128, 128));
  strip.setViewpoints(cameras);
  QCOMPARE(strip.currentRow(), 1);
  keepWidget(strip, QStringLiteral("viewpoint-strip"));
}

void PerceptionWidgetsTest::stripFollowsTheKeyboard() {
  ViewpointStrip strip;
  strip.resize(600, strip.sizeHint().height());
  strip.show();
  strip.setViewpoints(std::vector<Camera>(5));
  strip.choose(2);
  QSignalSpy chosen(&strip, &ViewpointStrip::chosen);
  QTest::keyClick(&strip, Qt::Key_Right);
  QCOMPARE(chosen.size(), 1);
  QCOMPARE(chosen.last()[0].value<std::size_t>(), std::size_t{3});
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::PerceptionWidgetsTest>(argc, argv);
}
#include "perception_widgets_test.moc"
