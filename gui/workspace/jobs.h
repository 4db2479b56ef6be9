// What the workbench has worker threads do: calls into algorithms/ and model/io, put together.
#pragma once

#include <QString>
#include <QStringList>

#include "gui/workspace/workspace.h"
#include "model/io/format.h"

namespace lodestone {

[[nodiscard]] std::vector<std::string> toStrings(const QStringList& list);

/// The sample town's file, beside the program or in the source tree it was built in; empty when it is not
/// there.
[[nodiscard]] QString samplePath();
/// The line layers beside it.
[[nodiscard]] QStringList sampleStreets();

/// \throw Cancelled
[[nodiscard]] Result<std::vector<LineLayer>> readBarrierLines(const CityModel& city,
                                                              const std::vector<std::string>& paths,
                                                              const std::string& layer,
                                                              const Progress& progress);

/// Barriers, dendrogram and merged hulls of a city. \throw Cancelled
[[nodiscard]] Result<std::shared_ptr<const ClusterTree>> makeTree(const CityModel& city,
                                                                  const TreeRecipe& recipe,
                                                                  const Progress& progress);

/// The nodes at a height of the dendrogram, as something to draw and to export.
[[nodiscard]] Cut makeWeightCut(const ClusterTree& tree, double weight);
/// What the state draws from a camera; null when every building is drawn itself.
[[nodiscard]] std::shared_ptr<const Cut> chosenCut(const ProjectState& state, const Camera& camera);

/// Writes every format that is asked for; `camera` is the one that the drawn cut is chosen from. A tree that
/// was dropped is made again first: without it there would be no level but the finest. A format that fails
/// is said, the others are written. \throw Cancelled
[[nodiscard]] Result<WriteReport> writeChain(ProjectState state, const Camera& camera,
                                             const ExportRequest& request, const Progress& progress);

/// Writes a chain in every format that is asked for, after what was `said` of it before. \throw Cancelled
[[nodiscard]] Result<WriteReport> writeFormats(const LodChain& chain, Diagnostics said,
                                               const ExportRequest& request, const Progress& progress);

}  // namespace lodestone
