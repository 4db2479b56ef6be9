// Contacts of a model followed in another that was not made here, by the names of their objects.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/component_mesh.h"
#include "model/progress.h"
#include "model/simplify_report.h"

namespace lodestone {

/// What became of the pairs of source objects (buildings, parts, groups) that touch in the original.
struct ObjectContacts {
  std::vector<ContactReport> contacts;  ///< of objects of the original that can be followed; see `named`
  std::uint32_t objects = 0;            ///< of the original, its parts of buildings too
  std::uint32_t unfollowed = 0;  ///< contacts of objects whose name is not theirs alone, in either model
  std::uint32_t named = 0;       ///< objects of the original whose name the other model has too
  bool partsUnknown = false;     ///< the other model knows none of the original's parts, but whole buildings
};

/// A model whose objects are to be followed by their names.
struct NamedModel {
  const ComponentMesh& mesh;
  std::span<const std::string> buildings;  ///< ids, by ComponentMesh::SourceObject::building
};

/// Nothing says which component of one model is which of another; the ids of source objects do say which
/// object is which. So the contacts are those between objects, each with all its components, and those within
/// an object are not followed. They are kept, separated or lost as followContacts() has it; gaps of no more
/// than `rounding` metres, by which files round their coordinates, are none. Parts of buildings of which the
/// other model knows not one are no objects: what lies between is a format without parts, in which they are
/// not lost. \pre both models stand in one frame. \throw Cancelled
[[nodiscard]] ObjectContacts followObjects(const NamedModel& original, const NamedModel& other,
                                           double rounding = 0, const Progress& progress = {});

}  // namespace lodestone
