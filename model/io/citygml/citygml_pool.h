// All geometry of one top-level city object, flat, as its elements come: what is linked to what is settled
// when the object ends (citygml_assembly.h). One pool is used for object after object and keeps its memory.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/city_model.h"

namespace lodestone::citygml {

inline constexpr std::uint32_t kNothing = 0xFFFFFFFFU;

struct PoolRing {
  std::uint32_t begin = 0;  ///< in GeometryPool::points, without the repeated last point
  std::uint32_t end = 0;
  std::uint64_t id = 0;
  std::uint32_t coordinates = kNothing;  ///< in GeometryPool::textureCoordinates, end − begin of them
};

struct PoolSurface {
  std::uint32_t ringBegin = 0;
  std::uint32_t ringEnd = 0;
  SurfaceType type = SurfaceType::Unknown;
  bool valid = true;

  std::int32_t material = -1;
  std::int32_t texture = -1;
};

enum class ItemKind : std::uint8_t { Surface, Link, Shell, Solid, SolidEnd };

/// A step through a geometry in document order: a surface, a link to some, or a shell's or solid's bounds.
struct Item {
  ItemKind kind = ItemKind::Surface;
  bool flip = false;
  std::uint32_t surface = 0;
  std::uint64_t link = 0;
};

/// What an id stands for: the items [begin, end).
struct Target {
  std::uint64_t id = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  bool flip = false;  ///< its items are written the other way round, for an OrientableSurface about it
};

/// Placement of an ImplicitGeometry.
struct Placement {
  std::array<double, 16> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  ///< row after row
  Vec3 reference = Vec3::Zero();
};

/// A geometry property: the items [begin, end) shown by an object at a LoD.
struct Draft {
  std::string lod;
  std::uint32_t object = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  GeometryKind kind = GeometryKind::MultiSurface;  ///< as its element says
  SurfaceType type = SurfaceType::Unknown;         ///< of the thematic surface it belongs to
  bool thematic = false;                           ///< belongs to a thematic surface or opening
  std::int32_t placement = -1;                     ///< in GeometryPool::placements

  [[nodiscard]] bool isSolid() const {
    return kind == GeometryKind::Solid || kind == GeometryKind::MultiSolid ||
           kind == GeometryKind::CompositeSolid;
  }
};

struct PoolObject {
  CityObject object;
  std::uint32_t parent = kNothing;
};

struct GeometryPool {
  std::vector<Vec3> points;
  std::vector<PoolRing> rings;
  std::vector<PoolSurface> surfaces;
  std::vector<Vec2f> textureCoordinates;
  std::vector<Item> items;
  std::vector<Target> targets;
  std::vector<Placement> placements;
  std::vector<Draft> drafts;
  std::vector<PoolObject> objects;  ///< parents before children

  void clear();
  /// Registers the items since `begin` under an id; 0 is no id.
  void addItem(ItemKind kind, std::uint32_t surface = 0, std::uint64_t link = 0) {
    items.push_back({kind, false, surface, link});
  }
  /// Turns the items since `item` round, as seen from outside them: what was named since `target` keeps its
  /// own orientation.
  void flip(std::uint32_t item, std::uint32_t target);
  void name(std::uint64_t id, std::uint32_t begin) {
    if (id != 0) targets.push_back({id, begin, static_cast<std::uint32_t>(items.size())});
  }
};

}  // namespace lodestone::citygml
