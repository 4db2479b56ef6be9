// Contacts of a model followed in another that was not made here, by the names of their objects.
#pragma once

#include <vector>

#include "model/component_mesh.h"
#include "model/progress.h"
#include "model/simplify_report.h"

namespace lodestone {

/// What became of the pairs of source objects (buildings, parts, groups) that touch in the original.
struct ObjectContacts {
  std::vector<ContactReport> contacts;  ///< of objects of the original that can be followed; see `names`
  std::uint32_t unfollowed = 0;  ///< contacts of objects whose name is not theirs alone, in either model
  std::uint32_t named = 0;       ///< objects of the original whose name the other model has too
};

/// Nothing says which component of one model is which of another; the ids of source objects do say which
/// object is which. So the contacts are those between objects, each with all its components, and those within
/// an object are not followed. They are kept, separated or lost as followContacts() has it. \pre both models
/// stand in one frame. \throw Cancelled
[[nodiscard]] ObjectContacts followObjects(const ComponentMesh& original, const ComponentMesh& other,
                                           const Progress& progress = {});

}  // namespace lodestone
