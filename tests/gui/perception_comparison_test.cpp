// Levels beside the original in the Perception dock: measured as the algorithms measure them.
#include <QGroupBox>
#include <QTabWidget>

#include "gui/perception/comparison_panel.h"
#include "gui/perception/picture_grid.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/widgets/picture_image.h"
#include "tests/gui/perception_support.h"

namespace lodestone {

class PerceptionComparisonTest : public PerceptionFixture {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { writePavilion(); }
  void init() { openWindow(); }
  void cleanup() { closeWindow(); }
  void comparesLevelsWithTheOriginal();
  void comparesAgainWhatChanged();

 private:
  void showComparison();
};

void PerceptionComparisonTest::showComparison() {
  panel().views().setCurrentWidget(&panel().comparison());
  QTRY_VERIFY_WITH_TIMEOUT(panel().comparing().isDone() && !window_->workspace().tasks().busy(), kLong);
}

void PerceptionComparisonTest::comparesLevelsWithTheOriginal() {
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

void PerceptionComparisonTest::comparesAgainWhatChanged() {
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

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::PerceptionComparisonTest>(argc, argv);
}
#include "perception_comparison_test.moc"
