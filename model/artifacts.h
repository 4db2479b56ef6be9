// Intermediate results, told to whoever looks as they are made.
#pragma once

#include <functional>
#include <string_view>
#include <variant>

#include "model/city_model.h"
#include "model/cluster_tree.h"
#include "model/lod_chain.h"

namespace lodestone {

using Artifact =
    std::variant<const CityModel*, const Dendrogram*, const ClusterTree*, const Cut*, const LodChain*>;
/// Called on the working thread; the artifact lives as long as the call. An empty sink costs nothing.
using ArtifactSink = std::function<void(std::string_view stage, const Artifact& artifact)>;

inline void tell(const ArtifactSink& sink, std::string_view stage, const Artifact& artifact) {
  if (sink) sink(stage, artifact);
}

}  // namespace lodestone
