// The four pictures of the view that is chosen.
#pragma once

#include <QObject>
#include <deque>
#include <memory>
#include <optional>

#include "gui/perception/perceiving.h"

namespace lodestone {

/// Made in the background when a view is chosen, painted again when classes are cut elsewhere. The last few
/// are kept. Lives on the GUI thread.
class ShownPictures : public QObject {
  Q_OBJECT

 public:
  ShownPictures(Perceiving& perceiving, Workspace& workspace, QObject* parent = nullptr);

  /// Of the chosen view, or of the one before while they are made; null: nothing was looked at.
  [[nodiscard]] const std::shared_ptr<const ViewPictures>& pictures() const { return shown_; }
  /// The triangle that a pixel shows.
  [[nodiscard]] std::optional<std::uint32_t> triangleAt(const QPoint& pixel) const;
  /// Grey values, class and triangle of a pixel, for people.
  [[nodiscard]] QString textOf(const QPoint& pixel) const;

 Q_SIGNALS:
  void changed();

 private:
  void follow();
  void start(std::shared_ptr<const ViewPictures> same);
  [[nodiscard]] std::optional<Camera> wanted() const;
  [[nodiscard]] std::shared_ptr<const ViewPictures> known(const Camera& camera) const;
  void keep(std::shared_ptr<const ViewPictures> made);
  void show(std::shared_ptr<const ViewPictures> pictures);

  Perceiving& perceiving_;
  Workspace& workspace_;
  std::deque<std::shared_ptr<const ViewPictures>> kept_;  ///< the latest first
  std::shared_ptr<const ViewPictures> shown_;
  std::optional<Camera> making_;
};

}  // namespace lodestone
