// A CityJSON file or sequence being written.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "model/io/atomic_file.h"
#include "model/io/cityjson/cityjson_encoder.h"

namespace lodestone {

enum class CityJsonLayout { Document, Sequence };

/// Usage: begin, add …, finish. Without finish() nothing is left. \throw std::system_error from all of them
class CityJsonStream {
 public:
  CityJsonStream(const CityModel& model, const std::filesystem::path& path, CityJsonLayout layout);

  /// `description`: JSON text of the metadata's member "lodestone". (A member "+lodestone" of the root would
  /// be one of an extension, which CityJSON wants declared with the address of its schema.)
  void begin(const std::string& description);
  void add(const CityJsonEncoder::Entry& entry);
  /// Completes the file and copies the images that it names from other folders beside it, all or none.
  /// Returns all files made.
  [[nodiscard]] std::vector<std::filesystem::path> finish();
  [[nodiscard]] const std::vector<std::string>& losses() const { return encoder_.losses(); }

 private:
  void nameImages(const CityModel& model);
  void addFeature(const CityJsonEncoder::Entry& entry);
  void copyImages();

  const CityModel& model_;
  std::filesystem::path path_;
  CityJsonLayout layout_;
  CityJsonPlacement placement_;
  CityJsonEncoder encoder_;
  AtomicFiles files_;
  AtomicFile& file_;
  std::unique_ptr<AtomicFile>
      vertices_;                         ///< of a document: they come last, and can be more than memory holds
  std::vector<std::string> imageNames_;  ///< by model texture
  std::set<std::int32_t> imagesUsed_;
  bool first_ = true;
};

}  // namespace lodestone
