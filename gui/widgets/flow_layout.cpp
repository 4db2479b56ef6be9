#include "gui/widgets/flow_layout.h"

#include <QWidget>
#include <algorithm>

namespace lodestone {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {}
FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) {
  items_.emplace_back(item);
}

int FlowLayout::count() const {
  return static_cast<int>(items_.size());
}

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index < 0 || index >= count() ? nullptr : items_[static_cast<std::size_t>(index)].get();
}

QLayoutItem* FlowLayout::takeAt(int index) {
  if (!itemAt(index)) return nullptr;
  QLayoutItem* item = items_[static_cast<std::size_t>(index)].release();
  items_.erase(items_.begin() + index);
  return item;
}

int FlowLayout::heightForWidth(int width) const {
  return arrange(QRect(0, 0, width, 0), false);
}

QSize FlowLayout::sizeHint() const {
  QSize size(-spacing(), 0);
  for (const auto& item : items_) {
    const QSize hint = item->sizeHint();
    size = QSize(size.width() + spacing() + hint.width(), std::max(size.height(), hint.height()));
  }
  return size.grownBy(contentsMargins());
}

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const auto& item : items_) size = size.expandedTo(item->minimumSize());
  return size.grownBy(contentsMargins());
}

void FlowLayout::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  arrange(rect, true);
}

int FlowLayout::arrange(const QRect& rect, bool move) const {
  const QRect room = rect.marginsRemoved(contentsMargins());
  int top = room.top();
  for (auto next = items_.begin(); next != items_.end();) {
    const auto first = next;
    int right = room.left();
    int height = 0;
    for (; next != items_.end(); ++next) {
      const QSize size = (*next)->sizeHint();
      if (next != first && right + size.width() > room.left() + room.width()) break;
      right += size.width() + spacing();
      height = std::max(height, size.height());
    }
    int left = room.left();
    for (auto item = first; move && item != next; ++item) {
      const QSize size = (*item)->sizeHint();
      (*item)->setGeometry(QRect(QPoint(left, top + (height - size.height()) / 2), size));
      left += size.width() + spacing();
    }
    top += height + (next == items_.end() ? 0 : spacing());
  }
  return top + contentsMargins().bottom() - rect.top();
}

}  // namespace lodestone
