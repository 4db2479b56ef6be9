// City objects of CityJSON documents and features.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "model/io/cityjson/cityjson_geometry.h"
#include "model/progress.h"

namespace lodestone {

/// Turns `CityObjects` of one document after another into buildings and other objects of one model.
class CityJsonObjects {
 public:
  CityJsonObjects(CityModel& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  /// Adds all objects, children below their parents. \throw Cancelled
  void add(const JsonObject& cityObjects, const CityJsonContext& context, const Progress& progress);

 private:
  struct Node {
    CityObject object;
    std::int64_t parent = -1;
    int depth = 0;
  };
  [[nodiscard]] CityObject readObject(std::string id, const JsonObject& json,
                                      CityJsonGeometryReader& geometries);
  [[nodiscard]] std::string uniqueId(std::string id);
  void linkParents(const std::vector<JsonObject>& jsons, const std::vector<std::string_view>& ids,
                   std::vector<Node>& nodes);
  void measureDepths(std::vector<Node>& nodes);
  void place(CityObject object);

  CityModel& model_;
  Diagnostics& diagnostics_;
  std::unordered_set<std::string> ids_;
  std::unordered_map<std::string, int> suffixes_;
};

/// Attribute under which the type of an object is kept that has no ObjectType of its own: "+NoiseBuilding".
inline constexpr std::string_view kTypeAttribute = "cityjson:type";

}  // namespace lodestone
