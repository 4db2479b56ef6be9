#include "algorithms/simplification/object_contacts.h"

#include <unordered_map>

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

ObjectContacts followObjects(const ComponentMesh& original, const ComponentMesh& other,
                             const Progress& progress) {
  const ComponentMesh before = byObject(original);
  Simplified after;
  after.mesh = byObject(other);
  const auto namesBefore = namesOf(before);
  const auto namesAfter = namesOf(after.mesh);
  ObjectContacts result;
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
  }
  return result;
}

}  // namespace lodestone
