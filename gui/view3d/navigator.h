// Camera control made for cities and buildings: z is always up, the eye goes no lower than the scene allows,
// what is grabbed stays under the cursor.
#pragma once

#include <functional>
#include <optional>

#include "model/camera.h"

namespace lodestone {

class Scene;

enum class DragKind { None, Orbit, Pan };

/// Moves the camera of a scene. Coordinates are device pixels, x right and y down from the top left. No
/// toolkit: whoever has a window calls it.
class Navigator {
 public:
  explicit Navigator(Scene& scene) : scene_(scene) {}

  /// Orbit turns about the point under the cursor; in plan view it pans.
  void beginDrag(DragKind kind, double x, double y);
  void drag(double x, double y);
  void endDrag() { kind_ = DragKind::None; }
  [[nodiscard]] bool dragging() const { return kind_ != DragKind::None; }

  /// Moves towards (steps > 0) or away from what is under the cursor; one step is one notch of a wheel.
  void zoom(double steps, double x, double y);
  /// Brings the point under the cursor to the middle of the picture.
  void centre(double x, double y);
  /// Moves by shares of the picture's size: right and up are positive.
  void panBy(double right, double up);
  /// Turns about the middle of the picture, degrees: the eye goes counter-clockwise seen from above, and
  /// upwards.
  void orbitBy(double azimuth, double elevation);

 private:
  void orbitAbout(const Vec3& pivot, double azimuth, double elevation);
  void moveBy(const Vec3& offset);
  [[nodiscard]] std::optional<Vec3> onPlane(double x, double y, double z) const;

  Scene& scene_;
  DragKind kind_ = DragKind::None;
  Vec3 pivot_ = Vec3::Zero();
  Vec2 last_ = Vec2::Zero();
};

}  // namespace lodestone
