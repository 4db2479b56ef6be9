// Widgets in lines, one after the other, as words are.
#pragma once

#include <QLayout>
#include <memory>
#include <vector>

namespace lodestone {

/// Each widget has the size that it asks for; what does not fit into a line begins the next one. Widgets of a
/// line stand in its middle.
class FlowLayout : public QLayout {
 public:
  explicit FlowLayout(QWidget* parent = nullptr);
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override;
  [[nodiscard]] int count() const override;
  [[nodiscard]] QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;

  [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;     ///< all in one line
  [[nodiscard]] QSize minimumSize() const override;  ///< the widest in a line alone
  void setGeometry(const QRect& rect) override;

 private:
  /// The lines in a rectangle of this width, and where the last one ends; moves the widgets where it is told
  /// to.
  int arrange(const QRect& rect, bool move) const;

  std::vector<std::unique_ptr<QLayoutItem>> items_;
};

}  // namespace lodestone
