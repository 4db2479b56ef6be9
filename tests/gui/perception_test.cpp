// The Perception dock in the real window: what it shows is what the algorithms by themselves say.
#include <QAction>
#include <QDockWidget>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>

#include "algorithms/perception/viewpoints.h"
#include "gui/perception/classes_panel.h"
#include "gui/perception/comparison_panel.h"
#include "gui/perception/difference_plot.h"
#include "gui/perception/perceiving.h"
#include "gui/perception/perception_panel.h"
#include "gui/perception/picture_grid.h"
#include "gui/perception/sensitivity_plot.h"
#include "gui/perception/viewpoint_strip.h"
#include "gui/simplification/simplify_form.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_legend.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/detail_looks.h"
#include "gui/widgets/parameter_panel.h"
#include "gui/widgets/picture_image.h"
#include "tests/gui/stage_support.h"

namespace lodestone {

class PerceptionTest : public StageFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { writePavilion(); }
  void init() { openWindow(); }
  void cleanup();
  void saysWhatIsMissing();
  void buildingWithoutSurfacesHasNothingToSee();
  void nobodyLooksUnlessAsked();
  void looksWhenShown();
  void showsThePicturesOfTheChosenViewpoint();
  void judgesAgainWhenACutIsDragged();
  void takesTheCameraAsOneMoreViewpoint();
  void paintsTheModel();
  void saysWhatLargePicturesCost();
  void cancelledKeepsWhatWasSeen();
  void judgingThatFailsIsNotTriedForEver();
  void looksAtTheNextBuildingToo();
  void forgetsWithTheBuilding();
  void methodsAskPictures();
  void simplifiesAtAStage();
  void saysWhereAStageStopped();
  void leavesOtherDocksTheirWidth();
  void comparesLevelsWithTheOriginal();
  void comparesAgainWhatChanged();
  void isUsableInBothSizesAndThemes();

 private:
  [[nodiscard]] Perceiving& perceiving() { return stageWindow().perceiving(); }
  [[nodiscard]] PerceptionPanel& panel() { return stageWindow().perception(); }
  [[nodiscard]] QAction& action() { return *window_->findChild<QAction*>(QStringLiteral("showPerception")); }
  void setSmall();
  void showDock();
  void settle();
  void showComparison();
  [[nodiscard]] Perception reference();
  /// Share of a pane's pixels that are red.
  [[nodiscard]] double redIn(std::size_t pane);
  [[nodiscard]] QString cell(int row, int column) {
    return panel().classes().stages().item(row, column)->text();
  }
};

void PerceptionTest::cleanup() {
  window_.reset();
  QApplication::setPalette(paletteOf(Appearance::Light));
}

void PerceptionTest::setSmall() {
  PerceiveOptions options;
  options.views = 8;
  options.size = 96;
  perceiving().setOptions(options, QStringLiteral("test"));
}

void PerceptionTest::showDock() {
  openPavilion();
  setSmall();
  action().trigger();
  QVERIFY(panel().isVisible());
  settle();
}

void PerceptionTest::settle() {
  QTRY_VERIFY_WITH_TIMEOUT(!perceiving().isOutdated() && !window_->workspace().tasks().busy(), kLong);
}

Perception PerceptionTest::reference() {
  const ComponentMesh& mesh = *stage().staged()->mesh;
  const ModelRenderer renderer(mesh, readModelLook(*stage().staged()->city, mesh));
  const PerceiveOptions& options = perceiving().options();
  return perceive(renderer, viewpointsAround(bounds(mesh), options), options, {}, {},
                  closerViewpoints(bounds(mesh), options));
}

void PerceptionTest::saysWhatIsMissing() {
  action().trigger();
  QVERIFY2(panel().state().contains(QStringLiteral("No building")), qPrintable(panel().state()));
  QVERIFY(!panel().lookButton().isEnabled());
  QVERIFY(!panel().addButton().isEnabled());
  QVERIFY(panel().pictures().pictures().empty());
  QVERIFY(panel().classes().plot().isEmpty());
}

void PerceptionTest::buildingWithoutSurfacesHasNothingToSee() {
  const QString path = folder_.filePath(QStringLiteral("bare.city.json"));
  std::ofstream(path.toStdString()) << R"({"type": "CityJSON", "version": "2.0",
    "transform": {"scale": [0.01, 0.01, 0.01], "translate": [0, 0, 0]},
    "CityObjects": {"bare": {"type": "Building", "geometry": []}, "block": {"type": "Building", "geometry": [
      {"type": "MultiSurface", "lod": "0", "boundaries": [[[0, 1, 2, 3]]]}]}},
    "vertices": [[0, 0, 0], [1000, 0, 0], [1000, 1000, 0], [0, 1000, 0]]})";
  window_->openFiles({path}, false);
  QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().state().city && !window_->workspace().tasks().busy(), kLong);
  window_->workspace().select(window_->workspace().buildingsOf({"bare"}));
  window_->findChild<QAction*>(QStringLiteral("simplifyBuilding"))->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
  action().trigger();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  QCOMPARE(stage().staged()->mesh->triangleCount(), 0U);
  QVERIFY2(panel().state().contains(QStringLiteral("no surfaces")), qPrintable(panel().state()));
  QCOMPARE(panel().strip().viewCount(), std::size_t{0});
  QVERIFY(!panel().lookButton().isEnabled());
  stageWindow().legend().details().setChecked(true);
  (void)image();
  keepPicture(*window_, QStringLiteral("perception-bare"));
}

void PerceptionTest::nobodyLooksUnlessAsked() {
  openPavilion();
  QTest::qWait(600);
  QVERIFY(!perceiving().looked());
  QVERIFY(!perceiving().isLooking());
}

void PerceptionTest::looksWhenShown() {
  showDock();
  const Perception expected = reference();
  const Perception& seen = *perceiving().looked()->perception;
  QCOMPARE(panel().strip().viewCount(), std::size_t{8});
  QCOMPARE(seen.histogram, expected.histogram);
  QCOMPARE(seen.classes, expected.classes);
  QCOMPARE(seen.pixels, expected.pixels);
  QCOMPARE(seen.glimpsed, expected.glimpsed);
  QCOMPARE(stage().perception().get(), &seen);
  for (int number = 1; number <= 3; ++number) {
    std::size_t count = 0;
    std::size_t withUnseen = 0;
    for (const bool admitted : admittedTriangles(expected, number, false)) count += admitted ? 1 : 0;
    for (const bool admitted : admittedTriangles(expected, number, true)) withUnseen += admitted ? 1 : 0;
    QCOMPARE(cell(number - 1, 1), QLocale().toString(static_cast<qulonglong>(count)));
    QCOMPARE(cell(number - 1, 2), QLocale().toString(static_cast<qulonglong>(withUnseen)));
  }
  QVERIFY(!panel().classes().plot().isEmpty());
  QCOMPARE(panel().classes().plot().cuts(), expected.differences.cuts);
  QVERIFY2(panel().state().contains(QStringLiteral("8 viewpoints")), qPrintable(panel().state()));
  keepPicture(*window_, QStringLiteral("perception"));
}

void PerceptionTest::showsThePicturesOfTheChosenViewpoint() {
  showDock();
  panel().strip().setFocus();
  QTest::keyClick(&panel().strip(), Qt::Key_Right);
  QTest::keyClick(&panel().strip(), Qt::Key_Right);
  QCOMPARE(perceiving().view(), std::size_t{2});
  settle();
  const Looked& looked = *perceiving().looked();
  const PerceivedView view =
      perceiveView(*looked.renderer, looked.perception->cameras[2], looked.perception->options);
  const DifferenceClasses& classes = looked.perception->differences;
  const Picture expected[] = {view.rendered.picture, greyPicture(view.filtered),
                              differencePicture(view.difference, classes),
                              classPicture(view.difference, classes)};
  const auto& shown = panel().pictures().pictures();
  QCOMPARE(shown.size(), std::size_t{4});
  for (std::size_t i = 0; i < 4; ++i)
    QCOMPARE(shown[i].picture->image(), toImage(expected[i]).convertToFormat(QImage::Format_RGB32));
  // A pixel that shows the model says so, and a click selects its component.
  QPoint pixel(-1, -1);
  for (int y = 0; y < 96 && pixel.x() < 0; ++y) {
    for (int x = 0; x < 96; ++x) {
      if (view.rendered.triangle[static_cast<std::size_t>(y) * 96 + static_cast<std::size_t>(x)] !=
          kNoTriangle)
        pixel = QPoint(x, y);
    }
  }
  QVERIFY(pixel.x() >= 0);
  const std::uint32_t triangle =
      view.rendered.triangle[static_cast<std::size_t>(pixel.y()) * 96 + static_cast<std::size_t>(pixel.x())];
  QTest::mouseMove(&panel().pictures(),
                   panel().pictures().placeOf(0, QPointF(pixel) + QPointF(0.5, 0.5)).toPoint());
  Q_EMIT panel().pictures().picked(pixel);
  QCOMPARE(stage().selection(),
           std::vector<std::uint32_t>{componentOfTriangle(*stage().staged()->mesh, triangle)});
}

void PerceptionTest::judgesAgainWhenACutIsDragged() {
  showDock();
  const auto before = perceiving().looked();
  DifferencePlot& plot = panel().classes().plot();
  const int y = static_cast<int>(plot.plot().center().y());
  const QPoint from(qRound(plot.placeOfCut(0)), y);
  const QPoint to(qRound(plot.placeOfBin(2)), y);
  QTest::mousePress(&plot, Qt::LeftButton, Qt::NoModifier, from);
  QMouseEvent move(QEvent::MouseMove, QPointF(to), plot.mapToGlobal(QPointF(to)), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&plot, &move);
  QTest::mouseRelease(&plot, Qt::LeftButton, Qt::NoModifier, to);
  QCOMPARE(perceiving().options().slight, binBegin(2));
  settle();
  QTRY_VERIFY(perceiving().looked()->perception->options == perceiving().options());
  const Perception& seen = *perceiving().looked()->perception;
  QCOMPARE(perceiving().looked()->renderer, before->renderer);  // no new pictures
  QCOMPARE(seen.differences.cuts[0], 2);
  QCOMPARE(seen.classes, classesOfTriangles(*before->perception, seen.differences));
  std::size_t admitted = 0;
  for (const bool one : admittedTriangles(seen, 3, false)) admitted += one ? 1 : 0;
  QCOMPARE(cell(2, 1), QLocale().toString(static_cast<qulonglong>(admitted)));
  window_->workspace().session().undo();
  settle();
  QTRY_COMPARE(perceiving().looked()->perception->classes, before->perception->classes);
  QCOMPARE(plot.cuts(), before->perception->differences.cuts);
  QVERIFY(!panel().classes().findChild<QPushButton*>(QStringLiteral("findCuts"))->isEnabled());
}

void PerceptionTest::takesTheCameraAsOneMoreViewpoint() {
  showDock();
  panel().addButton().click();
  settle();
  QCOMPARE(panel().strip().viewCount(), std::size_t{9});
  QCOMPARE(perceiving().view(), std::size_t{8});
  const Camera& added = perceiving().looked()->perception->cameras.back();
  QCOMPARE(added.eye, scene().camera().eye);
  QCOMPARE(added.width, 96);
  QCOMPARE(added.height, 96);
  auto* remove = window_->findChild<QToolButton*>(QStringLiteral("removeViewpoint"));
  QVERIFY(remove->isEnabled());
  remove->click();
  settle();
  QCOMPARE(panel().strip().viewCount(), std::size_t{8});
  QVERIFY(!remove->isEnabled());
}

double PerceptionTest::redIn(std::size_t pane) {
  const QImage picture = image();
  const auto [left, right] = scene().spanOf(pane);
  std::size_t red = 0;
  std::size_t all = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = static_cast<int>(left); x < static_cast<int>(right); ++x, ++all) {
      const QColor colour = picture.pixelColor(x, y);
      red += colour.red() > 2 * colour.green() && colour.red() > 2 * colour.blue() ? 1U : 0U;
    }
  }
  return static_cast<double>(red) / static_cast<double>(all);
}

void PerceptionTest::paintsTheModel() {
  showDock();
  const QImage plain = image();
  stageWindow().legend().details().setChecked(true);
  QVERIFY(!stageWindow().legend().components().isChecked());
  QVERIFY(!stageWindow().legend().glyphs(VertexClass::Boundary).isChecked());  // they would hide it
  const QImage painted = image();
  QVERIFY(difference(plain, painted) > 0.01);
  // A cut that makes everything dramatic paints what is seen red.
  PerceiveOptions options = perceiving().options();
  options.slight = options.moderate = options.dramatic = binBegin(1);
  perceiving().setOptions(options, QStringLiteral("test"));
  settle();
  keepPicture(*window_, QStringLiteral("perception-painted"));
  const Perception& seen = *stage().perception();
  const PaintedTriangles& paint = *scene().look().painted.front();
  QCOMPARE(paint.mesh, stage().staged()->mesh);
  std::size_t red = 0;
  for (std::size_t t = 0; t < seen.classes.size(); ++t) {
    QCOMPARE(paint.colours[t], seen.isSeen(t) ? detailColour(seen.classes[t]) : unseenColour());
    red += seen.classes[t] == DetailClass::Dramatic ? 1 : 0;
  }
  QVERIFY(red > 0);
  // And what the method left of it, which is made again.
  const double before = redIn(1);
  QVERIFY2(before > 0.02, qPrintable(QString::number(before)));
  SimplifyOptions method;
  method.method = SimplifyMethod::QemOptimal;
  method.rate = 0.7;
  stage().setOptions(Stage::A, method, QStringLiteral("test"));
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A), kLong);
  const Simplified& left = *stage().level(Stage::A)->simplified;
  QCOMPARE(scene().look().painted.size(), std::size_t{2});
  const PaintedTriangles& again = *scene().look().painted[1];
  QCOMPARE(again.mesh.get(), &left.mesh);
  QCOMPARE(again.colours.size(), left.triangle.size());
  for (std::size_t t = 0; t < left.triangle.size(); ++t)
    QCOMPARE(again.colours[t], paint.colours[left.triangle[t]]);
  QVERIFY(redIn(1) > 0.02);
  keepPicture(*window_, QStringLiteral("perception-painted-level"));
  stageWindow().legend().components().setChecked(true);
  QVERIFY(!stageWindow().legend().details().isChecked());
  QVERIFY(stageWindow().legend().glyphs(VertexClass::Boundary).isChecked());
  QVERIFY(!stageWindow().legend().glyphs(VertexClass::Ordinary).isChecked());
}

void PerceptionTest::saysWhatLargePicturesCost() {
  showDock();
  const auto before = perceiving().looked();
  qobject_cast<QSpinBox*>(panel().fields().editor("size"))->setValue(8192);
  QTest::qWait(800);
  QVERIFY(!perceiving().isLooking());
  QVERIFY(perceiving().isOutdated());
  QCOMPARE(perceiving().looked(), before);
  QVERIFY2(panel().state().contains(QStringLiteral("GiB")), qPrintable(panel().state()));
  QVERIFY(panel().lookButton().isEnabled());
  keepPicture(*window_, QStringLiteral("perception-large"));
}

void PerceptionTest::cancelledKeepsWhatWasSeen() {
  showDock();
  const auto before = perceiving().looked();
  PerceiveOptions options = perceiving().options();
  options.size = 1024;
  options.views = 20;
  perceiving().setOptions(options, QStringLiteral("test"));
  QTRY_VERIFY(perceiving().isLooking());
  panel().lookButton().click();
  QTRY_VERIFY_WITH_TIMEOUT(!perceiving().isLooking(), kLong);
  QCOMPARE(perceiving().looked(), before);
  QVERIFY(perceiving().isOutdated());
  QTest::qWait(600);
  QVERIFY(!perceiving().isLooking());  // not again by itself
  QVERIFY2(panel().state().contains(QStringLiteral("of before")), qPrintable(panel().state()));
}

void PerceptionTest::judgingThatFailsIsNotTriedForEver() {
  showDock();
  const auto before = perceiving().looked();
  TaskRunner& tasks = window_->workspace().tasks();
  const QString key = QStringLiteral("perceive-judge");
  int begun = 0;
  const auto each = connect(&tasks, &TaskRunner::finished, this, [&](const QString& ended, bool) {
    if (ended == key && tasks.busy(key)) tasks.cancel(key);
  });
  const auto count = connect(&tasks, &TaskRunner::started, this,
                             [&](const QString& started) { begun += started == key ? 1 : 0; });
  PerceiveOptions options = perceiving().options();
  options.slight = options.moderate = options.dramatic = binBegin(1);
  perceiving().setOptions(options, QStringLiteral("test"));
  QVERIFY(tasks.busy(key));
  tasks.cancel(key);
  QTRY_VERIFY_WITH_TIMEOUT(!tasks.busy(), kLong);
  QTest::qWait(100);
  disconnect(each);
  disconnect(count);
  QCOMPARE(begun, 1);
  QCOMPARE(perceiving().looked(), before);
  QVERIFY2(panel().state().contains(QStringLiteral("of before")), qPrintable(panel().state()));
  QVERIFY(panel().lookButton().isEnabled());
  panel().lookButton().click();
  QTRY_VERIFY_WITH_TIMEOUT(perceiving().looked()->perception->options == options, kLong);
  QCOMPARE(perceiving().looked()->renderer, before->renderer);
  QTRY_VERIFY(!panel().lookButton().isEnabled());
}

void PerceptionTest::looksAtTheNextBuildingToo() {
  showDock();
  PerceiveOptions options = perceiving().options();
  options.size = 512;
  options.views = 12;
  perceiving().setOptions(options, QStringLiteral("test"));
  QTRY_VERIFY(perceiving().isLooking());
  stage().open(stage().building());
  QTRY_VERIFY_WITH_TIMEOUT(perceiving().looked() && !perceiving().isOutdated(), kLong);
}

void PerceptionTest::forgetsWithTheBuilding() {
  showDock();
  stage().close();
  QVERIFY(!perceiving().looked());
  QVERIFY(!stage().perception());
  QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  QVERIFY(panel().pictures().pictures().empty());
}

void PerceptionTest::methodsAskPictures() {
  openPavilion();
  setSmall();
  ParameterPanel& form = stageWindow().method().form(Stage::A).fields();
  QVERIFY(!form.editor("stage")->isVisibleTo(&form));
  SimplifyOptions options;
  options.method = SimplifyMethod::Perception;
  options.stage = 3;
  options.unseen = true;
  options.rate = 0.1;
  stage().setOptions(Stage::A, options, QStringLiteral("test"));
  for (const char* name : {"stage", "unseen", "error"}) QVERIFY(form.editor(name)->isVisibleTo(&form));
  // Nobody has looked: somebody does, and then the method follows.
  QTRY_VERIFY_WITH_TIMEOUT(perceiving().looked() && !stage().isUnfinished(Stage::A), kLong);
  const ComponentMesh& mesh = *stage().staged()->mesh;
  const Admission admission = admissionOf(mesh, *stage().perception(), options);
  const Simplified expected = simplify(mesh, *stage().staged()->classes, options, {}, admission);
  QCOMPARE(stage().level(Stage::A)->simplified->mesh.triangles, expected.mesh.triangles);
  QVERIFY(expected.mesh.triangleCount() < mesh.triangleCount());
  const StageReport report = stageReportOf(*stage().perception(), admission, expected.mesh);
  QCOMPARE(stage().level(Stage::A)->report->stage->removed, report.removed);
  QCOMPARE(stage().level(Stage::A)->report->stage->latent(), report.latent());
  // Other cuts, another level.
  PerceiveOptions cuts = perceiving().options();
  cuts.slight = cuts.moderate = cuts.dramatic = 200;
  perceiving().setOptions(cuts, QStringLiteral("test"));
  QTRY_VERIFY_WITH_TIMEOUT(stage().perception()->options == cuts && !stage().isUnfinished(Stage::A), kLong);
  const Admission fewer = admissionOf(mesh, *stage().perception(), options);
  QVERIFY(fewer.triangles != admission.triangles);
  QCOMPARE(stage().level(Stage::A)->simplified->mesh.triangles,
           simplify(mesh, *stage().staged()->classes, options, {}, fewer).mesh.triangles);
}

void PerceptionTest::simplifiesAtAStage() {
  showDock();
  panel().classes().stages().selectRow(2);
  auto* use = panel().findChild<QPushButton*>(QStringLiteral("useStage"));
  QVERIFY2(use->text().contains(QLatin1Char('3')), qPrintable(use->text()));
  use->click();
  QCOMPARE(stage().options(Stage::A).method, SimplifyMethod::Perception);
  QCOMPARE(stage().options(Stage::A).stage, 3);
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A), kLong);
  const auto* removed = panel().findChild<QLabel*>(QStringLiteral("removedTriangles"));
  QVERIFY2(removed->text().contains(QStringLiteral("A, stage 3")), qPrintable(removed->text()));
  QVERIFY2(removed->text().contains(QStringLiteral("slight and above")), qPrintable(removed->text()));
  window_->workspace().session().undo();
  QCOMPARE(stage().options(Stage::A).method, SimplifyMethod::Topology);
}

void PerceptionTest::saysWhereAStageStopped() {
  showDock();
  const auto* removed = panel().findChild<QLabel*>(QStringLiteral("removedTriangles"));
  QVERIFY2(removed->text().isEmpty(), qPrintable(removed->text()));  // topology follows no stage
  const QRect place = panel().classes().stages().geometry();
  SimplifyOptions options;
  options.method = SimplifyMethod::Perception;
  options.rate = 0.75;  // more than any stage admits of it
  stage().setOptions(Stage::A, options, QStringLiteral("test"));
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A), kLong);
  const QString stopped = QStringLiteral("stopped before rate %1").arg(QLocale().toString(options.rate));
  QVERIFY2(removed->text().contains(stopped), qPrintable(removed->text()));
  QApplication::processEvents();
  QCOMPARE(panel().classes().stages().geometry(), place);
  options.rate = 1;  // all that is admitted: nothing is held up
  stage().setOptions(Stage::A, options, QStringLiteral("test"));
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A), kLong);
  QVERIFY2(!removed->text().contains(QStringLiteral("stopped")), qPrintable(removed->text()));
  options.unseen = true;  // what is of no class has no share of one
  stage().setOptions(Stage::A, options, QStringLiteral("test"));
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A), kLong);
  QVERIFY2(removed->text().contains(QStringLiteral("of those admitted")), qPrintable(removed->text()));
}

void PerceptionTest::leavesOtherDocksTheirWidth() {
  openPavilion();
  setSmall();
  const auto* components = window_->findChild<QDockWidget*>(QStringLiteral("componentsDock"));
  const auto* method = window_->findChild<QDockWidget*>(QStringLiteral("simplifyDock"));
  const int left = components->width();
  const int right = method->width();
  action().trigger();
  settle();
  QVERIFY2(std::abs(components->width() - left) <= 4, qPrintable(QString::number(components->width())));
  QVERIFY2(std::abs(method->width() - right) <= 4, qPrintable(QString::number(method->width())));
}

void PerceptionTest::showComparison() {
  panel().views().setCurrentWidget(&panel().comparison());
  QTRY_VERIFY_WITH_TIMEOUT(panel().comparing().isDone() && !window_->workspace().tasks().busy(), kLong);
}

void PerceptionTest::comparesLevelsWithTheOriginal() {
  showDock();
  SimplifyOptions options;
  options.method = SimplifyMethod::VertexClustering;
  options.rate = 0.9;
  stage().setOptions(Stage::A, options, QStringLiteral("test"));
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A), kLong);
  showComparison();
  const Looked& looked = *perceiving().looked();
  const double pixels = perceiving().options().pixelsPerDegree();
  const ModelRenderer level(stage().level(Stage::A)->simplified->mesh, looked.look);
  const std::vector<Camera> cameras =
      viewpointsAround(bounds(*stage().staged()->mesh), perceiving().options(), 0.5);
  QCOMPARE(panel().comparing().cameras(), cameras);
  double sum = 0;
  for (std::size_t view = 0; view < cameras.size(); ++view) {
    QVERIFY(!(cameras[view] == looked.perception->cameras[view]));  // none that it was classified by
    const Picture reference = looked.renderer->render(cameras[view]).picture;
    const Picture test = level.render(cameras[view]).picture;
    const auto& measured = panel().comparing().measures(view)[Stage::A];
    QVERIFY(measured);
    QCOMPARE(measured->flip, flip(reference, test, pixels).mean);
    QCOMPARE(measured->pixelError, pixelError(reference, test));
    sum += measured->flip;
  }
  const PictureMeasures all = compareModels(*looked.renderer, level, cameras, pixels).all;
  const PictureMeasures& mean = panel().comparing().pooled(Stage::A).mean;
  QVERIFY(std::abs(mean.flip - all.flip) < 1e-12);
  QVERIFY(std::abs(mean.flipShown - all.flipShown) < 1e-12);
  QVERIFY(std::abs(mean.pixelError - all.pixelError) < 1e-12);
  QVERIFY(sum > 0);
  QCOMPARE(panel().comparing().pooled(Stage::A).mean.flip, sum / static_cast<double>(cameras.size()));
  QCOMPARE(panel().comparison().table().rowCount(), static_cast<int>(cameras.size()) + 1);
  QCOMPARE(panel().comparison().pictures().pictures().size(), std::size_t{3});
  panel().comparison().table().setCurrentCell(3, 0);  // the third measured view
  QTRY_VERIFY_WITH_TIMEOUT(panel().comparing().pictures()->camera == cameras[2], kLong);
  const Picture reference = looked.renderer->render(cameras[2]).picture;
  const Picture map = flipPicture(flip(reference, level.render(cameras[2]).picture, pixels));
  QCOMPARE(panel().comparison().pictures().pictures()[2].picture->image(),
           toImage(map).convertToFormat(QImage::Format_RGB32));
  keepPicture(*window_, QStringLiteral("perception-comparison"));
}

void PerceptionTest::comparesAgainWhatChanged() {
  showDock();
  showComparison();
  const double before = panel().comparing().pooled(Stage::A).mean.flip;
  SimplifyOptions options;
  options.method = SimplifyMethod::VertexClustering;
  options.rate = 0.95;
  stage().setOptions(Stage::B, options, QStringLiteral("test"));
  stageWindow().method().compareBox().setChecked(true);
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isUnfinished(Stage::A) && !stage().isUnfinished(Stage::B), kLong);
  QTRY_VERIFY_WITH_TIMEOUT(panel().comparing().pooled(Stage::B).views == 8, kLong);
  QCOMPARE(panel().comparing().pooled(Stage::A).mean.flip, before);
  QVERIFY(panel().comparing().pooled(Stage::B).mean.flip > before);
  QTRY_COMPARE_WITH_TIMEOUT(panel().comparison().pictures().pictures().size(), std::size_t{5}, kLong);
  keepPicture(*window_, QStringLiteral("perception-comparison-b"));
  stageWindow().method().compareBox().setChecked(false);
  QTRY_COMPARE_WITH_TIMEOUT(panel().comparison().pictures().pictures().size(), std::size_t{3}, kLong);
}

void PerceptionTest::isUsableInBothSizesAndThemes() {
  showDock();
  for (const QSize& size : {QSize(1440, 900), QSize(1280, 800)}) {
    for (const Appearance appearance : {Appearance::Light, Appearance::Dark}) {
      window_->resize(size);
      QApplication::setPalette(paletteOf(appearance));
      QTest::qWait(50);
      QVERIFY(panel().pictures().cell(0).width() > 100);
      QVERIFY(panel().pictures().cell(0).height() > 100);
      QVERIFY(panel().classes().plot().height() > 80);
      panel().sides().setCurrentIndex(1);
      QVERIFY(panel().sensitivity().width() > 200);
      QVERIFY(panel().pictures().cell(0).width() > 100);
      keepPicture(*window_, QStringLiteral("perception-display-%1").arg(size.width()));
      panel().sides().setCurrentIndex(0);
      keepPicture(*window_, QStringLiteral("perception-%1-%2")
                                .arg(size.width())
                                .arg(appearance == Appearance::Dark ? "dark" : "light"));
    }
  }
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::PerceptionTest>(argc, argv);
}
#include "perception_test.moc"
