// Colour and opacity of the layer that is chosen.
#pragma once

#include <QWidget>

#include "gui/view3d/city_scene.h"

class QSlider;
class QToolButton;

namespace lodestone {

class LayerStyleRow : public QWidget {
  Q_OBJECT

 public:
  explicit LayerStyleRow(QWidget* parent = nullptr);
  /// Shows a style, and says nothing.
  void show(const LayerStyle& style);
  [[nodiscard]] const LayerStyle& style() const { return style_; }
  /// As if a person had chosen it; nothing: the theme's.
  void setColour(const std::optional<Rgb>& colour);

 Q_SIGNALS:
  /// A person changed it.
  void edited(const lodestone::LayerStyle& style);

 private:
  void chooseColour();
  void showColour();

  LayerStyle style_;
  QToolButton* colour_;
  QSlider* opacity_;
};

}  // namespace lodestone
