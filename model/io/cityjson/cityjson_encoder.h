// City objects as CityJSON 2.0 text, piece by piece.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/city_model.h"
#include "model/diagnostics.h"
#include "model/io/cityjson/cityjson_placement.h"
#include "model/tuple_hash.h"

namespace lodestone {

/// Encodes one object after another and keeps what they refer to: vertices as text to be taken away at any
/// time, and the appearance entries that were used. The same calls give the same bytes.
class CityJsonEncoder {
 public:
  CityJsonEncoder(const CityModel& model, const CityJsonPlacement& placement)
      : model_(model), placement_(placement) {}

  struct Entry {
    const CityObject* object = nullptr;
    const std::vector<Geometry>* geometries = nullptr;  ///< instead of the object's own, if not null
    const Attributes* more = nullptr;                   ///< beside the object's own
  };
  /// `"id":{…}` of the object and of everything below it, separated by commas.
  void append(std::string& text, const Entry& entry);

  /// Vertices encoded since the last call, as list items separated by commas; all of them have numbers from
  /// one series.
  [[nodiscard]] std::string takeVertices() { return std::exchange(vertices_, {}); }
  /// The member `"appearance":{…}` for all objects since the last reset; empty when nothing refers to it.
  [[nodiscard]] std::string appearance(const std::vector<std::string>& imageNames) const;
  /// Model textures that are used, in the order of first use.
  [[nodiscard]] const std::vector<std::int32_t>& texturesUsed() const { return textures_.used; }
  /// Starts a document of its own: numbers begin at 0 again.
  void reset();
  /// What the schema of CityJSON has no place for, counted.
  [[nodiscard]] const std::vector<std::string>& losses() const { return losses_; }

 private:
  struct Uses {
    std::unordered_map<std::int32_t, std::size_t> number;
    std::vector<std::int32_t> used;
    std::size_t of(std::int32_t index);
  };
  struct Shape;
  void appendObject(std::string& text, const Entry& entry, std::string_view parent);
  void appendMembers(std::string& text, const Entry& entry, std::string_view type);
  void appendGeometry(std::string& text, const Geometry& geometry, std::string_view type);
  void appendSemantics(std::string& text, const Shape& shape);
  void appendMaterials(std::string& text, const Shape& shape);
  void appendTextures(std::string& text, const Shape& shape);
  [[nodiscard]] Shape shapeOf(const Geometry& geometry, std::string_view type);
  std::size_t vertexNumber(const std::array<std::int64_t, 3>& place);
  std::size_t textureVertexNumber(const Vec2f& uv);
  void lose(std::string what);

  const CityModel& model_;
  const CityJsonPlacement& placement_;
  std::string vertices_;
  std::size_t vertexCount_ = 0;
  /// Of the object being written: shared corners are one vertex, so that solids stay closed by index.
  std::unordered_map<std::array<std::int64_t, 3>, std::size_t, TupleHash> places_;
  Uses materials_;
  Uses textures_;
  std::vector<Vec2f> textureVertices_;
  std::unordered_map<std::uint64_t, std::size_t> textureVertexNumbers_;
  std::vector<std::string> losses_;
};

}  // namespace lodestone
