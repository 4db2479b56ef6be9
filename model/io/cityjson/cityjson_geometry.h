// Geometries of CityJSON documents.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/city_model.h"
#include "model/diagnostics.h"
#include "model/io/cityjson/cityjson_appearance.h"
#include "model/io/placed_templates.h"

namespace lodestone {

/// What the geometries of one document refer to.
struct CityJsonContext {
  std::vector<Vec3> vertices;  ///< transformed; NaN: broken
  CityJsonAppearance appearance;
  /// In their own coordinates; without surfaces: broken. May be null.
  const std::vector<Geometry>* templates = nullptr;
  PlacedTemplates* placed = nullptr;  ///< of all documents of a file; null: not counted
};

/// One diagnostic a code and object with a count, however many surfaces are broken.
class ObjectDiagnostics {
 public:
  void add(Code code, std::string detail) {
    auto [entry, isNew] = found_.try_emplace({code, std::move(detail)}, 0);
    ++entry->second;
  }
  void flush(const std::string& object, Diagnostics& diagnostics);

 private:
  std::map<std::pair<Code, std::string>, std::size_t> found_;
};

class CityJsonGeometryReader {
 public:
  explicit CityJsonGeometryReader(const CityJsonContext& context);

  /// Reads one entry of `geometry` or of `templates`. Broken surfaces are left out and said; an empty result
  /// means that nothing is left.
  [[nodiscard]] Geometry read(const JsonObject& json, ObjectDiagnostics& said);

 private:
  struct SurfaceSides;
  void readShell(const std::optional<JsonElement>& boundaries, const SurfaceSides& sides);
  void readSolid(const std::optional<JsonElement>& boundaries, const SurfaceSides& sides);
  void readSolids(const std::optional<JsonElement>& boundaries, const SurfaceSides& sides);
  void readSurface(const JsonElement& rings, const SurfaceSides& sides);
  bool collectRing(const std::optional<JsonElement>& ring, const std::optional<JsonElement>& texture,
                   bool first);
  void collectTexture(const JsonElement& texture, std::size_t begin, std::size_t count,
                      const std::vector<std::size_t>& places);
  void appendCollected(SurfaceInfo info);
  [[nodiscard]] SurfaceInfo infoOf(const SurfaceSides& sides);
  [[nodiscard]] Geometry readInstance(const JsonObject& json);
  void readSemantics(const std::optional<JsonObject>& semantics);

  const CityJsonContext& context_;
  std::vector<std::uint32_t> localOf_;  ///< by document vertex: its place in the geometry being read
  std::vector<std::uint32_t> used_;     ///< document vertices of the geometry being read
  ObjectDiagnostics* said_ = nullptr;
  Geometry geometry_;
  std::vector<SurfaceType> types_;
  bool textured_ = false;
  // The surface being read: nothing of it reaches the geometry before all of it is found good.
  std::vector<std::uint32_t> indices_;
  std::vector<Vec2f> uvs_;
  std::vector<std::size_t> ringEnds_;
  std::int32_t surfaceTexture_ = -1;
};

}  // namespace lodestone
