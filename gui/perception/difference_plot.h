// How many pixels differ how much from what the eye lets through, and where classes of detail are cut.
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <optional>
#include <utility>

#include "model/perception.h"

namespace lodestone {

/// Counts on a logarithmic axis over differences on that of their roots, the Gaussian of each class over
/// them, each class's share of the pixels above, and a line at each cut. Lines are dragged, or chosen with 1
/// to 3 and moved with the arrow keys; a double click or Delete lets a cut be found again.
class DifferencePlot : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kCuts = kDetailClasses - 1;

  explicit DifferencePlot(QWidget* parent = nullptr);

  /// `fixed`: cuts that somebody chose.
  void show(const DifferenceHistogram& histogram, const DifferenceClasses& classes,
            const std::array<bool, kCuts>& fixed);
  void clear(const QString& message);
  [[nodiscard]] bool isEmpty() const { return !shown_; }
  /// As drawn, while one is dragged too.
  [[nodiscard]] const std::array<int, kCuts>& cuts() const { return classes_.cuts; }
  [[nodiscard]] double placeOfCut(std::size_t cut) const;  ///< in the widget
  [[nodiscard]] double placeOfBin(double bin) const;
  [[nodiscard]] QRectF plot() const;
  /// What is said above the plot of each class, as short as the width wants it.
  [[nodiscard]] QStringList shares() const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// A person moved a cut to the beginning of a bin from 1 on; told with every step.
  void cutMoved(std::size_t cut, int bin);
  /// It is to be found by maximum likelihood again.
  void cutReset(std::size_t cut);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] int lastBin() const;
  [[nodiscard]] double placeOfCount(double count) const;
  [[nodiscard]] std::optional<std::size_t> cutNear(double x) const;
  void moveCut(std::size_t cut, int bin);
  [[nodiscard]] QString helpAt(const QPointF& at) const;
  [[nodiscard]] std::pair<int, int> binsOf(DetailClass detail) const;
  [[nodiscard]] double shareOf(DetailClass detail) const;
  [[nodiscard]] QStringList namedShares() const;
  [[nodiscard]] double roomOf(const QStringList& texts) const;
  void paintShares(QPainter& painter) const;
  void paintBands(QPainter& painter) const;
  void paintAxes(QPainter& painter) const;
  void paintHistogram(QPainter& painter) const;
  void paintGaussians(QPainter& painter) const;
  void paintCuts(QPainter& painter) const;

  DifferenceHistogram histogram_{};
  DifferenceClasses classes_;
  std::array<bool, kCuts> fixed_{};
  std::uint64_t total_ = 0;
  std::uint64_t most_ = 1;
  bool shown_ = false;
  QString message_;
  std::optional<std::size_t> grabbed_;
  std::size_t chosen_ = 0;
};

}  // namespace lodestone
