// How far pictures of what is drawn are from pictures of everything (Chang et al. 2008, figure 3).
#pragma once

#include <memory>

#include "algorithms/perception/comparison.h"
#include "algorithms/rendering/model_rendering.h"
#include "model/cluster_tree.h"
#include "model/progress.h"

namespace lodestone {

/// All buildings of a city, ready to be looked at again and again. Walls and roofs have the same tints
/// whatever stands for a building, so that shapes alone make a difference. Memory: about 200 bytes a
/// triangle.
class Fidelity {
 public:
  /// \throw std::runtime_error when Embree cannot build the scene
  Fidelity(std::shared_ptr<const CityModel> city, std::shared_ptr<const ClusterTree> tree);

  /// A picture of the cut from its camera against the same of all buildings. Cost: two renderings and a ꟻLIP.
  /// \throw Cancelled
  [[nodiscard]] PictureMeasures measure(const Cut& cut, double pixelsPerDegree,
                                        const Progress& progress = {}) const;

 private:
  [[nodiscard]] ModelRenderer rendererOf(const Cut& cut) const;

  std::shared_ptr<const CityModel> city_;
  std::shared_ptr<const ClusterTree> tree_;
  std::shared_ptr<const ModelLook> look_;
  Box3 box_;
  ModelRenderer everything_;
};

}  // namespace lodestone
