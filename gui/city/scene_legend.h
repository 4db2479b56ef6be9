// What the colours and lines of the 3D view mean, in a corner of it.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <vector>

namespace lodestone {

class CityScene;

struct LegendEntry {
  enum class Sign { Block, Hues, Hull, Box };
  Sign sign = Sign::Block;
  QColor colour;
  QString text;
  bool operator==(const LegendEntry&) const = default;
};

/// What is to be explained in a scene now; empty while neither hulls nor negative space are drawn: blocks
/// explain themselves.
[[nodiscard]] std::vector<LegendEntry> legendOf(const CityScene& scene);

/// Lets the mouse through to the view below it. Hidden while it has no entries.
class SceneLegend : public QWidget {
  Q_OBJECT

 public:
  explicit SceneLegend(QWidget* parent = nullptr);
  void setEntries(std::vector<LegendEntry> entries);
  [[nodiscard]] const std::vector<LegendEntry>& entries() const { return entries_; }
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] int rowHeight() const { return fontMetrics().height() + 6; }
  [[nodiscard]] int signWidth() const { return fontMetrics().height() * 3 / 2; }

  std::vector<LegendEntry> entries_;
};

}  // namespace lodestone
