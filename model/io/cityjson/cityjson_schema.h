// What the schema of CityJSON 2.0 allows where.
#pragma once

#include <string>
#include <string_view>

#include "model/city_model.h"

namespace lodestone {

/// Type name to write for an object: its own where the schema has it, else the nearest that it has.
[[nodiscard]] std::string cityJsonType(const CityObject& object, bool hasParent);

enum class GeometryFit { AsIs, AsCompositeSolid, AsMultiSurface, AsCompositeSurface, No };
/// How a geometry of this kind can stand in an object of this type.
[[nodiscard]] GeometryFit geometryFit(std::string_view type, GeometryKind kind);

/// The nearest of the schema's LoD strings; the same text where it is one of them.
[[nodiscard]] std::string cityJsonLod(const std::string& lod);

/// Whether objects of the type have an `address` of their own.
[[nodiscard]] bool hasAddress(std::string_view type);

/// A structured attribute as the member `address`: a list of objects, each without `location`, which would
/// have to name vertices. Empty where the text is no object and no list of objects.
[[nodiscard]] std::string addressList(const std::string& json);

/// Name of a kind as CityJSON writes it.
[[nodiscard]] std::string_view kindName(GeometryKind kind);

}  // namespace lodestone
