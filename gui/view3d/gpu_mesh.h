// A NodeMesh on the GPU.
#pragma once

#include <memory>
#include <vector>

#include "gui/view3d/city_mesh.h"

namespace lodestone {

class GpuMesh {
 public:
  /// Uploaded at the next draw; what was there before is given back then.
  void setMesh(std::shared_ptr<const NodeMesh> mesh);
  [[nodiscard]] const std::shared_ptr<const NodeMesh>& mesh() const { return mesh_; }
  /// Ranges of indices to draw; neighbours are joined here.
  void setRanges(const std::vector<MeshRange>& ranges);
  [[nodiscard]] bool empty() const { return !mesh_ || counts_.empty(); }
  /// \pre its context and program are current.
  void draw();
  void release();

 private:
  void upload();

  std::shared_ptr<const NodeMesh> mesh_;
  std::shared_ptr<const NodeMesh> uploaded_;
  std::vector<int> counts_;
  std::vector<const void*> offsets_;
  unsigned array_ = 0;
  unsigned vertices_ = 0;
  unsigned indices_ = 0;
};

}  // namespace lodestone
