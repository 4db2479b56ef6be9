// What a vector file holds, before it is imported: enough to ask the right questions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/geometry.h"
#include "model/result.h"

namespace lodestone {

struct FieldPreview {
  std::string name;
  bool numeric = false;  ///< a number by its type, or text that is a number in every sampled feature
  std::vector<std::string> samples;  ///< a few different values
  double min = 0;                    ///< of the sampled numbers
  double max = 0;
};

struct LayerPreview {
  std::string name;
  std::int64_t features = -1;  ///< −1: not known without reading all
  bool hasPolygons = false;
  bool hasLines = false;
  bool read = false;         ///< the one that is taken where none is named
  std::string crs;           ///< for people; empty: the file names none
  bool saysHeights = false;  ///< has one of the fields in which heights or floors are usually found
  std::vector<FieldPreview> fields;
  std::vector<Ring> outlines;  ///< outer rings of the sampled features, in the coordinates of the file
};

struct VectorPreview {
  std::vector<LayerPreview> layers;
};

/// Looks at the first features of each layer (at most 2,000). Cost: below 0.1 s for most files; no network
/// access.
[[nodiscard]] Result<VectorPreview> previewVector(const std::filesystem::path& path);

}  // namespace lodestone
