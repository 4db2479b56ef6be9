// One CityJSON document, or one feature of a sequence, into the model.
#pragma once

#include "model/import_options.h"
#include "model/io/cityjson/cityjson_objects.h"

namespace lodestone {

/// Takes documents in turn; a feature without a transform or appearance of its own uses those of the document
/// before it.
class CityJsonDocuments {
 public:
  CityJsonDocuments(CityModel& model, const std::filesystem::path& file, const ImportOptions& options,
                    Diagnostics& diagnostics);

  /// False, and an error, when the document is neither CityJSON nor a feature. \throw Cancelled
  bool add(const JsonElement& root, const std::string& place, const Progress& progress);

 private:
  void readHeader(const JsonObject& root, const std::string& place);
  void readVersion(const JsonObject& root, const std::string& place);
  void readTransform(const JsonObject& root, const std::string& place);
  void readReferenceSystem(const JsonObject& root);
  void readTemplates(const JsonObject& root);
  void checkFeature(const JsonObject& root, const JsonObject& objects, const std::string& place);
  [[nodiscard]] std::vector<Vec3> readVertices(const std::optional<JsonElement>& list,
                                               bool transformed) const;

  CityModel& model_;
  Diagnostics& diagnostics_;
  AppearanceTables tables_;
  CityJsonObjects objects_;
  Vec3 scale_ = Vec3::Ones();
  Vec3 translate_ = Vec3::Zero();
  bool hasTransform_ = false;
  CityJsonAppearance appearance_;  ///< of the last document that is not a feature, as are the templates
  std::vector<Geometry> templates_;
  PlacedTemplates placed_;
};

}  // namespace lodestone
