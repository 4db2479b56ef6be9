// The viewpoints that a model is looked at from: a small picture of each.
#pragma once

#include <QImage>
#include <QListWidget>
#include <vector>

#include "model/camera.h"

namespace lodestone {

class ViewpointStrip : public QListWidget {
  Q_OBJECT

 public:
  /// Of a small picture, pixels.
  static constexpr int kSide = 128;

  explicit ViewpointStrip(QWidget* parent = nullptr);

  /// Empty frames, until pictures come. What was chosen stays so where there is as much.
  void setViewpoints(const std::vector<Camera>& cameras);
  void setPicture(std::size_t view, const QImage& picture);
  /// Says nothing.
  void choose(std::size_t view);
  [[nodiscard]] std::size_t viewCount() const { return static_cast<std::size_t>(count()); }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override {
    return {iconSize().width() * 2, sizeHint().height()};
  }

 Q_SIGNALS:
  /// By a person.
  void chosen(std::size_t view);
};

/// "from the north-east, 20° above".
[[nodiscard]] QString directionText(const Camera& camera);

}  // namespace lodestone
