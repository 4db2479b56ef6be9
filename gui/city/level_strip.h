// The levels of a chain as a strip of cards, from fine to coarse.
#pragma once

#include <QImage>
#include <QListView>
#include <vector>

#include "model/lod_chain.h"

class QStandardItemModel;

namespace lodestone {

/// Each card: a picture of the level, its name and method, what it costs, how far off it is, and from where
/// it takes over. A click, Return or the arrow keys choose a level.
class LevelStrip : public QListView {
  Q_OBJECT

 public:
  explicit LevelStrip(QWidget* parent = nullptr);

  /// Shows the levels, without pictures.
  void setLevels(const std::vector<LodLevel>& levels);
  /// Pictures of the levels shown, in their order.
  void setPictures(const std::vector<QImage>& pictures);
  /// Marks a level as the one that is drawn; −1: none of them. Says nothing.
  void setShown(int level);
  /// Size to draw pictures at, device-independent pixels; a low strip shows the middle of them.
  [[nodiscard]] QSize pictureSize() const;
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void chosen(int level);

 protected:
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QStandardItemModel* model_;
  bool telling_ = true;
};

}  // namespace lodestone
