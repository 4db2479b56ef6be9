// What every use of GDAL's vector drivers here shares: drivers registered once, errors caught, nothing
// fetched.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/result.h"

class GDALDataset;
class OGRSpatialReference;

namespace lodestone {

/// Keeps GDAL's errors on this thread from stderr for as long as it lives, and the first of them in mind.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  /// Messages of failures (not of warnings) so far, each once, the first ten.
  [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }
  [[nodiscard]] std::string joined() const;

 private:
  std::vector<std::string> failures_;
};

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const;
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

/// Registers GDAL's drivers, once, with network access switched off. Thread-safe.
void useGdal();

/// Opens a vector data set for reading, by the drivers that footprints and lines come in; null if none can.
/// OSM files are opened with all their tags and without temporary index files that need sorted ids.
[[nodiscard]] DatasetPtr openVector(const std::string& virtualPath);

/// The system of a layer as resolveCrs() understands it: "EPSG:N", or WKT where it has no code. Empty for
/// none.
[[nodiscard]] std::string spellingOf(const OGRSpatialReference* srs);

}  // namespace lodestone
