// From where a scene is looked at, and how deep the picture reaches.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gui/view3d/camera_ray.h"
#include "gui/view3d/city_mesh.h"

class vtkCamera;

namespace lodestone {

struct SceneGeometry;

/// Those nodes of a mesh that are drawn.
struct DrawnPart {
  const NodeMesh& mesh;
  std::span<const NodeId> nodes;
};

/// The camera of a scene with its plan view: directions, fits, and what VTK is told for a frame.
class SceneCamera {
 public:
  SceneCamera();

  [[nodiscard]] const Camera& camera() const { return camera_; }
  /// Keeps the size of the picture, which is the window's.
  void set(const Camera& camera);
  void setSize(int width, int height);
  /// Shifts the next frames by parts of a pixel.
  void setJitter(double x, double y) { jitter_ = Vec2(x, y); }
  /// Straight down without perspective; leaving it comes back to the direction before.
  void setPlan(bool plan);
  [[nodiscard]] bool plan() const { return plan_; }

  /// Looks at the buildings of a city without strays; when it does so already, at everything, terrain
  /// included; at a city's worth of ground where there is nothing.
  void fit(const SceneGeometry* geometry);
  void fitTo(const Box3& box);

  [[nodiscard]] Ray through(double x, double y) const { return rayThrough(camera_, plan_, x, y); }
  [[nodiscard]] std::optional<Vec2> project(const Vec3& point) const {
    return projectPoint(camera_, plan_, point);
  }
  /// Aims `target`, with depths that are spread over what is drawn: from the nearest of `parts` in the
  /// picture to the far end of `everything`. Cost: one pass over the drawn nodes' boxes.
  void aim(vtkCamera& target, std::span<const DrawnPart> parts, const Box3& everything) const;
  /// Least depth of the drawn nodes in the picture; infinity where there are none.
  [[nodiscard]] double nearestDepth(std::span<const DrawnPart> parts) const;
  /// Of a box's corners, at least 0; without a box twice the distance to the target.
  [[nodiscard]] double farthestDepth(const Box3& everything) const;

 private:
  [[nodiscard]] Vec3 lookToFit() const;
  /// \pre there is a box.
  [[nodiscard]] Camera fitted(const std::vector<Box3>& boxes) const;

  Camera camera_;
  bool plan_ = false;
  Vec3 slant_;  ///< direction to go back to from plan view
  Vec2 jitter_ = Vec2::Zero();
};

}  // namespace lodestone
