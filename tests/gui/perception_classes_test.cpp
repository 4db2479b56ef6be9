// Classes of detail in the real window: cut, painted, and what methods make of them.
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "gui/perception/difference_plot.h"
#include "gui/simplification/simplify_form.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_legend.h"
#include "gui/widgets/detail_looks.h"
#include "gui/widgets/parameter_panel.h"
#include "tests/gui/perception_support.h"

namespace lodestone {

class PerceptionClassesTest : public PerceptionFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { writePavilion(); }
  void init() { openWindow(); }
  void cleanup() { closeWindow(); }
  void judgesAgainWhenACutIsDragged();
  void judgingThatFailsIsNotTriedForEver();
  void paintsTheModel();
  void methodsAskPictures();
  void simplifiesAtAStage();
  void saysWhereAStageStopped();

 private:
  /// Share of a pane's pixels that are red.
  [[nodiscard]] double redIn(std::size_t pane);
};

void PerceptionClassesTest::judgesAgainWhenACutIsDragged() {
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

void PerceptionClassesTest::judgingThatFailsIsNotTriedForEver() {
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

double PerceptionClassesTest::redIn(std::size_t pane) {
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

void PerceptionClassesTest::paintsTheModel() {
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

void PerceptionClassesTest::methodsAskPictures() {
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

void PerceptionClassesTest::simplifiesAtAStage() {
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

void PerceptionClassesTest::saysWhereAStageStopped() {
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

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::PerceptionClassesTest>(argc, argv);
}
#include "perception_classes_test.moc"
