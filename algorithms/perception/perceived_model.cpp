#include "algorithms/perception/perceived_model.h"

#include <algorithm>

#include "algorithms/perception/perceiving.h"
#include "algorithms/perception/viewpoints.h"

namespace lodestone {

Perception perceiveModel(TextureCache& textures, const ComponentMesh& mesh, const PerceiveOptions& options,
                         Diagnostics* diagnostics, const Progress& progress) {
  const auto look = readModelLook(textures, mesh, diagnostics, progress.part(0, 0.1, "textures"));
  const Box3 box = bounds(mesh);
  Perception perception = perceive(ModelRenderer(mesh, look), viewpointsAround(box, options), options,
                                   progress.part(0.1, 1, "perceive"), {}, closerViewpoints(box, options));
  const bool seen = std::any_of(perception.pixels.begin(), perception.pixels.end(),
                                [](std::uint32_t pixels) { return pixels > 0; });
  if (diagnostics && !seen) diagnostics->push_back(diagnose(Code::ModelNotSeen));
  return perception;
}

}  // namespace lodestone
