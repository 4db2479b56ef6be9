#include "algorithms/simplification/object_contacts.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/contacts.h"

namespace lodestone {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// The mesh with the components of an object as one; they stand beside each other.
ComponentMesh byObject(ComponentMesh mesh) {
  std::vector<Component> objects;
  for (const Component& component : mesh.components) {
    if (!objects.empty() && objects.back().object == component.object) {
      objects.back().vertexCount = component.endVertex() - objects.back().firstVertex;
      objects.back().triangleCount = component.endTriangle() - objects.back().firstTriangle;
    } else {
      objects.push_back(component);
    }
  }
  mesh.components = std::move(objects);
  return mesh;
}

/// Every name by which a model calls something.
std::unordered_set<std::string> allNames(const NamedModel& model) {
  std::unordered_set<std::string> names(model.buildings.begin(), model.buildings.end());
  for (const ComponentMesh::SourceObject& object : model.mesh.objects) names.insert(object.id);
  names.erase("");
  return names;
}

/// Whether the model has parts, and `other` knows the name of none.
bool hasUnknownParts(const NamedModel& model, const NamedModel& other) {
  const auto known = allNames(other);
  bool parts = false;
  for (const ComponentMesh::SourceObject& object : model.mesh.objects) {
    if (object.building >= model.buildings.size() || object.id == model.buildings[object.building]) continue;
    if (known.contains(object.id)) return false;
    parts = true;
  }
  return parts;
}

/// The mesh with the objects of a building as one, named as it is.
ComponentMesh byBuilding(const NamedModel& model) {
  ComponentMesh mesh = model.mesh;
  std::vector<std::uint32_t> first(model.buildings.size(), kNone);
  for (Component& component : mesh.components) {
    const std::uint32_t building = mesh.objects[component.object].building;
    if (first[building] == kNone) first[building] = component.object;
    component.object = first[building];
  }
  for (std::uint32_t b = 0; b < first.size(); ++b) {
    if (first[b] != kNone) mesh.objects[first[b]].id = model.buildings[b];
  }
  return byObject(std::move(mesh));
}

const std::string& nameOf(const ComponentMesh& mesh, std::uint32_t component) {
  return mesh.objects[mesh.components[component].object].id;
}

/// Components by the name of their object; kNone for a name that several have, and for none at all.
std::unordered_map<std::string, std::uint32_t> namesOf(const ComponentMesh& mesh) {
  std::unordered_map<std::string, std::uint32_t> names{{"", kNone}};
  for (std::uint32_t c = 0; c < mesh.components.size(); ++c) {
    const auto [place, added] = names.emplace(nameOf(mesh, c), c);
    if (!added) place->second = kNone;
  }
  return names;
}

}  // namespace

ObjectContacts followObjects(const NamedModel& original, const NamedModel& other, double rounding,
                             const Progress& progress) {
  ObjectContacts result;
  result.partsUnknown = hasUnknownParts(original, other);
  const ComponentMesh before = result.partsUnknown ? byBuilding(original) : byObject(original.mesh);
  Simplified after;
  after.mesh = hasUnknownParts(other, original) ? byBuilding(other) : byObject(other.mesh);
  result.objects = static_cast<std::uint32_t>(byObject(original.mesh).components.size());
  const auto namesBefore = namesOf(before);
  const auto namesAfter = namesOf(after.mesh);
  std::vector<bool> followed(before.components.size());
  for (std::uint32_t c = 0; c < before.components.size(); ++c) {
    const auto found = namesAfter.find(nameOf(before, c));
    const bool there = found != namesAfter.end();
    followed[c] = namesBefore.at(nameOf(before, c)) != kNone && (!there || found->second != kNone);
    if (followed[c] && there) ++result.named;
  }
  // What the original does not have touches nothing of it.
  std::erase_if(after.mesh.components, [&](const Component& component) {
    const auto found = namesBefore.find(after.mesh.objects[component.object].id);
    const bool known = found != namesBefore.end() && found->second != kNone && followed[found->second];
    if (known) after.component.push_back(found->second);
    return !known;
  });
  Classification classes = classify(before, 0.01, progress.part(0, 0.5));
  const auto lost = std::erase_if(classes.contacts, [&](const auto& contact) {
    return !followed[contact.first] || !followed[contact.second];
  });
  result.unfollowed = static_cast<std::uint32_t>(lost);
  std::erase_if(classes.edges, [&](const BoundaryEdge& edge) {
    return !followed[componentOfVertex(before, edge.from)] || !followed[edge.other];
  });
  result.contacts = followContacts(before, classes, after, progress.part(0.5, 1));
  for (ContactReport& contact : result.contacts) {
    contact.first = before.components[contact.first].object;
    contact.second = before.components[contact.second].object;
    if (contact.fate != ContactFate::Separated || contact.gap > rounding) continue;
    contact.fate = ContactFate::Kept;
    contact.gap = 0;
  }
  return result;
}

}  // namespace lodestone
