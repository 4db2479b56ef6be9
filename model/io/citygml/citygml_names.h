// The vocabulary of CityGML 0.4–3.0 and of the GML it uses, looked up by namespace and local name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/city_model.h"

namespace lodestone::citygml {

/// Stands between namespace and local name in Expat's names. No XML text can hold it.
inline constexpr char kSeparator = '\x01';

/// Whose word a name is. Other: xAL, ADEs and everything else.
enum class Space : std::uint8_t { None, Gml, CityGml, Other };

/// What the reader does with an element.
enum class Kind : std::uint8_t {
  Unknown,
  // GML
  Aggregate,  ///< value: the GeometryKind it makes
  Solid,
  Polygon,   ///< also patches, triangles, rectangles
  Ring,      ///< LinearRing, Ring
  Boundary,  ///< exterior, interior: of a polygon or of a solid
  PosList,
  Pos,
  Coordinates,
  Curve,  ///< curves and points, which are not read as geometry
  Envelope,
  // CityGML
  Object,       ///< value: its ObjectType
  Surface,      ///< thematic surface or opening; value: its SurfaceType
  Transparent,  ///< holds city objects and is none
  Implicit,
  TransformationMatrix,
  ReferencePoint,
  RelativeGeometry,
  LibraryObject,
  Appearance,
  Ignored,  ///< a feature that tells nothing about shape or standing attributes
};

struct Tag {
  Space space = Space::None;
  Kind kind = Kind::Unknown;
  std::uint8_t value = 0;
  std::uint8_t version = 0;  ///< major version of a CityGML namespace; 0 also for 0.4
  std::string_view local;

  [[nodiscard]] ObjectType objectType() const { return static_cast<ObjectType>(value); }
  [[nodiscard]] SurfaceType surfaceType() const { return static_cast<SurfaceType>(value); }
  [[nodiscard]] GeometryKind geometryKind() const { return static_cast<GeometryKind>(value); }
};

/// Splits and looks up names. Keeps the namespaces of the document, the latest used first; not thread-safe.
class NameTable {
 public:
  /// `name` as Expat gives it; the tag's local name points into it.
  [[nodiscard]] Tag resolve(const char* name);

 private:
  struct Known {
    std::string uri;  ///< with the separator
    Space space = Space::Other;
    std::uint8_t version = 0;
  };
  const Known& spaceOf(std::string_view name);
  std::vector<Known> known_;
};

/// Attributes of one element, valid during the call that brings them.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  /// An attribute without namespace; empty when absent.
  [[nodiscard]] std::string_view find(std::string_view name) const;
  [[nodiscard]] std::string_view gmlId() const;
  [[nodiscard]] std::string_view href() const;
  [[nodiscard]] const char** pairs() const { return pairs_; }

 private:
  const char** pairs_;
};

/// Hash of an id, or of a reference to it ("#id"); 0 for none. 64 bits: ids are told apart by it alone.
[[nodiscard]] std::uint64_t idHash(std::string_view id);
[[nodiscard]] std::uint64_t linkHash(std::string_view reference);
/// True for "#id" and plain "id"; false for what leads out of the file.
[[nodiscard]] bool isLocalLink(std::string_view reference);

/// "2" of "lod2Solid"; empty when the name tells none.
[[nodiscard]] std::string_view lodOfProperty(std::string_view local);
/// The type of a thematic surface that only an ADE knows: by the end of its name ("IndustrialRoofSurface").
[[nodiscard]] SurfaceType guessSurfaceType(std::string_view local);

}  // namespace lodestone::citygml
