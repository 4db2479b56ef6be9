// The stage of one building in the real window, for tests.
#pragma once

#include <QTemporaryDir>
#include <fstream>
#include <memory>
#include <optional>

#include "gui/simplification/stage_view.h"
#include "gui/window/stage_window.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {

/// Groups of an OBJ file, z up.
class ObjFile {
 public:
  void group(const std::string& name) { text_ += "g " + name + "\n"; }
  /// A box whose faces are `n` × `n` quads.
  void box(const Vec3& low, const Vec3& high, int n = 1) {
    for (int axis = 0; axis < 3; ++axis) {
      side(low, high, axis, false, n);
      side(low, high, axis, true, n);
    }
  }
  void write(const QString& path) const { std::ofstream(path.toStdString()) << text_; }

 private:
  void side(const Vec3& low, const Vec3& high, int axis, bool top, int n) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto at = [&](int i, int j) {
      Vec3 p = top ? high : low;
      p[u] = low[u] + (high[u] - low[u]) * i / n;
      p[v] = low[v] + (high[v] - low[v]) * j / n;
      return p;
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const std::array<Vec3, 4> face{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        for (const Vec3& p : face) {
          text_ += "v " + std::to_string(p.x()) + " " + std::to_string(p.z()) + " " + std::to_string(-p.y()) +
                   "\n";
          ++vertices_;  // the file's y is up
        }
        text_ += "f";
        for (int k = 0; k < 4; ++k) text_ += " " + std::to_string(vertices_ - (top ? 3 - k : k));
        text_ += "\n";
      }
    }
  }

  std::string text_;
  int vertices_ = 0;
};

/// Share of pixels that differ clearly.
inline double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return 1;
  std::size_t differ = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int far =
          std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
      differ += far > 30 ? 1U : 0U;
    }
  }
  return static_cast<double>(differ) / (static_cast<double>(a.width()) * a.height());
}

/// A window, and a pavilion to put on its stage: a slab, a column that stands on it, one through it, and a
/// block that touches nothing.
class StageFixture : public QObject {
 protected:
  void writePavilion() {
    ObjFile pavilion;
    pavilion.group("slab");
    pavilion.box({0, 0, 0}, {12, 12, 1}, 4);
    pavilion.group("standing");
    pavilion.box({2, 2, 1}, {4, 4, 6}, 3);
    pavilion.group("through");
    pavilion.box({8, 8, -2}, {10, 10, 7}, 3);
    pavilion.group("apart");
    pavilion.box({16, 2, 0}, {20, 6, 4}, 3);
    pavilion.write(folder_.filePath(QStringLiteral("pavilion.obj")));
  }
  void openWindow() {
    window_ = makeWindow();
    window_->useDefaultLayout();
  }
  [[nodiscard]] StageWindow& stageWindow() { return window_->stage(); }
  [[nodiscard]] Stage& stage() { return window_->stage().stage(); }
  [[nodiscard]] BuildingScene& scene() { return stageWindow().view().scene(); }
  [[nodiscard]] QImage image() { return stageWindow().view().view().grabImage(); }
  void open(const QString& path) {
    window_->openFiles({path}, false);
    QTRY_VERIFY_WITH_TIMEOUT(stage().isOpen(), kLong);
    QTRY_VERIFY_WITH_TIMEOUT(stage().level(Stage::A) && stage().level(Stage::A)->report, kLong);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workspace().tasks().busy(), kLong);
  }
  void openPavilion() { open(folder_.filePath(QStringLiteral("pavilion.obj"))); }
  /// A pixel at which a component is seen in a pane.
  [[nodiscard]] std::optional<QPoint> pixelOf(std::uint32_t component, std::size_t pane = 0) {
    const QSize size = image().size();
    for (int y = 0; y < size.height(); y += 4) {
      for (int x = 0; x < size.width(); x += 4) {
        const auto part = scene().pick(x + 0.5, y + 0.5);
        const auto beside = scene().pick(x + 3.5, y + 2.5);
        if (part && beside && part->pane == pane && part->component == component &&
            beside->component == component)
          return QPoint(x, y);
      }
    }
    return {};
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace lodestone
