// The Simplification view with a model's own textures and materials.
#include <QToolButton>

#include "gui/simplification/stage_legend.h"
#include "gui/simplification/stage_view.h"
#include "gui/window/stage_window.h"
#include "model/io/atomic_file.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {
namespace {

/// A block whose long sides show an image, left half red and right half blue, the others a green material.
constexpr const char* kBlock =
    "mtllib block.mtl\nv 0 0 0\nv 8 0 0\nv 8 0 4\nv 0 0 4\nv 0 6 0\nv 8 6 0\nv 8 6 4\nv 0 6 4\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "g block\nusemtl picture\nf 4/1 3/2 7/3 8/4\nf 2/1 1/2 5/3 6/4\n"
    "usemtl green\nf 1/1 2/1 3/1 4/1\nf 8/1 7/1 6/1 5/1\nf 1/1 4/1 8/1 5/1\nf 2/1 6/1 7/1 3/1\n";

class SurfacesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    QVERIFY(folder_.isValid());
    QImage image(64, 32, QImage::Format_RGB32);
    image.fill(QColor(230, 20, 20));
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 32; x < 64; ++x) image.setPixelColor(x, y, QColor(20, 20, 230));
    }
    QVERIFY(image.save(folder_.filePath(QStringLiteral("halves.png"))));
    write("block.mtl", "newmtl picture\nmap_Kd halves.png\nnewmtl green\nKd 0.1 0.8 0.1\n");
    write("block.obj", kBlock);
    write("plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nf 1 2 3\nf 1 3 4\n");
    window_ = makeWindow();
  }
  void cleanup() { window_.reset(); }

  void areShownInEveryPane();
  void areOfferedWhereThereAreAny();

 private:
  void write(const char* name, const char* text) {
    writeFile(folder_.filePath(QString::fromLatin1(name)).toStdString(), text);
  }
  [[nodiscard]] Stage& stage() { return window_->stage().stage(); }
  void open(const QString& name) {
    window_->openFiles({folder_.filePath(name)}, false);
    QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A) && stage().level(Stage::A)->report, kLong);
  }
  [[nodiscard]] QToolButton& toggle(const char* name) {
    return *window_->findChild<QToolButton*>(QString::fromLatin1(name));
  }
  /// Share of the pixels of one half of the view, 0 or 1, in which one channel, 0 to 2, stands out.
  [[nodiscard]] double share(int half, int channel) {
    const QImage image = window_->stage().view().view().grabImage();
    int count = 0;
    const int width = image.width() / 2;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = half * width; x < (half + 1) * width; ++x) {
        const QColor c = image.pixelColor(x, y);
        const int parts[] = {c.red(), c.green(), c.blue()};
        if (parts[channel] > 60 && parts[channel] > 2 * parts[(channel + 1) % 3] &&
            parts[channel] > 2 * parts[(channel + 2) % 3])
          ++count;
      }
    }
    return count / static_cast<double>(width * image.height());
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

void SurfacesTest::areShownInEveryPane() {
  open(QStringLiteral("block.obj"));
  SimplifyOptions options = stage().options(Stage::A);
  options.rate = 0;
  stage().setOptions(Stage::A, options, QStringLiteral("rate"));
  QTRY_VERIFY_WITH_TIMEOUT(!stage().isOutdated(Stage::A), kLong);
  for (const char* glyphs : {"showBoundary", "showHole", "showContacts"}) toggle(glyphs).setChecked(false);
  for (const int channel : {0, 1, 2}) QVERIFY(share(0, channel) < 0.01);
  toggle("showTextures").click();
  QVERIFY(!toggle("showComponents").isChecked());
  keepPicture(*window_, QStringLiteral("surfaces"));
  for (const int half : {0, 1}) {
    for (const int channel : {0, 1, 2})
      QVERIFY2(share(half, channel) > 0.01, qPrintable(QString::number(channel)));
  }
  stage().select({0});  // marked components keep the colour of their mark
  QVERIFY(share(0, 0) < 0.01);
  stage().select({});
  toggle("showComponents").click();
  QVERIFY(!toggle("showTextures").isChecked());
  for (const int channel : {0, 1, 2}) QVERIFY(share(0, channel) < 0.01);
}

void SurfacesTest::areOfferedWhereThereAreAny() {
  open(QStringLiteral("block.obj"));
  QVERIFY(toggle("showTextures").isEnabled());
  toggle("showTextures").click();
  window_->workspace().close();
  open(QStringLiteral("plain.obj"));
  QVERIFY(!toggle("showTextures").isEnabled());
  QVERIFY(toggle("showComponents").isChecked());
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::SurfacesTest>(argc, argv);
}

#include "surfaces_test.moc"
