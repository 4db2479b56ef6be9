// From the pool of one top-level object to city objects: links followed, surfaces shown once, geometries
// built.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/io/citygml/citygml_pool.h"
#include "model/io/citygml/citygml_reports.h"

namespace lodestone::citygml {

/// Geometry that is linked to from other top-level objects, by the hash of its id.
using SharedGeometry = std::unordered_map<std::uint64_t, Geometry>;

/// Rules of what is shown where, in this order:
/// 1. a surface has the type of the thematic surface that holds it, else of the first that links to it;
/// 2. the solids of objects are built as they stand, links followed;
/// 3. so are the surfaces that objects show directly, and last the thematic surfaces of each object, as one
///    MultiSurface a LoD, always without what an earlier rule shows at the same LoD in the object itself or
///    in an object around it: a polygon that a solid links to is there once.
class Assembler {
 public:
  Assembler(GeometryPool& pool, const SharedGeometry& shared, Reports& reports);

  /// Fills the geometries of the pool's objects and returns the top-level ones: the first, and buildings
  /// inside what is no building (group members). Takes the objects out of the pool. Cost: O(n log n) for n
  /// items.
  [[nodiscard]] std::vector<CityObject> assemble();
  /// What an id of this pool stands for, as geometry of its own. \pre before assemble()
  [[nodiscard]] Geometry extract(const Target& target);
  /// Links that led nowhere, by hash.
  [[nodiscard]] const std::vector<std::uint64_t>& missing() const { return missing_; }
  /// Vertices placed through templates so far.
  [[nodiscard]] std::uint64_t placed() const { return placed_; }

 private:
  /// A surface of the pool, or of a shared geometry.
  struct Shown {
    const Geometry* shared = nullptr;
    std::uint32_t surface = 0;
    bool flip = false;
  };
  /// Who shows a surface: a bit for each LoD, and the first object.
  struct Use {
    std::uint8_t lods = 0;
    std::uint32_t object = kNothing;
  };
  struct Expansion {
    std::vector<Shown> surfaces;  ///< outside solids
    std::vector<Shown> inSolids;
    std::vector<std::uint32_t> shells;  ///< first of inSolids
    std::vector<std::uint32_t> solids;  ///< first of shells
    bool insideSolid = false;
    void clear();
  };

  [[nodiscard]] const Target* find(std::uint64_t id) const;
  void expand(const Draft& draft);
  void expandItems(std::uint32_t begin, std::uint32_t end, bool flip);
  void follow(const Item& item, bool flip);
  void showShared(const Geometry& geometry, bool flip);
  void show(Shown shown);
  void typeSurfaces(SurfaceType type);
  void build(const Draft& draft);
  void buildThematic();
  void markUsed(const Draft& draft, const std::vector<Shown>& surfaces);
  void leaveOutUsed(const Draft& draft, std::vector<Shown>& surfaces) const;
  [[nodiscard]] bool isShownElsewhere(const Shown& shown, const Draft& draft) const;
  [[nodiscard]] Geometry make(const std::vector<Shown>& surfaces, const Placement* placement);
  void copyPoolSurface(Geometry& geometry, const Shown& shown, bool withCoordinates) const;
  static void copySharedSurface(Geometry& geometry, const Shown& shown, bool withCoordinates);
  [[nodiscard]] Geometry makeSolid(GeometryKind kind, const Placement* placement);
  [[nodiscard]] const std::string& idOf(const Draft& draft) const {
    return pool_.objects[draft.object].object.id;
  }
  [[nodiscard]] std::string lodOf(const Draft& draft) const;
  [[nodiscard]] std::vector<CityObject> takeObjects();

  GeometryPool& pool_;
  const SharedGeometry& shared_;
  Reports& reports_;
  Expansion expansion_;
  std::vector<std::uint64_t> active_;  ///< links being followed
  std::vector<std::uint64_t> missing_;
  std::vector<Use> used_;  ///< of the pool's surfaces
  std::map<std::pair<const Geometry*, std::uint32_t>, Use> usedShared_;
  const Draft* draft_ = nullptr;
  bool silent_ = false;  ///< a first look at links, which are followed again
  std::uint64_t steps_ = 0;
  std::uint64_t stepLimit_ = 0;
  std::uint64_t placed_ = 0;
};

}  // namespace lodestone::citygml
