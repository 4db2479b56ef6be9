#include "model/io/merge_models.h"

#include <iterator>
#include <unordered_map>

#include <fmt/format.h>

namespace lodestone {
namespace {

constexpr std::size_t kSaidOneByOne = 100;

template <class T>
void append(std::vector<T>& to, std::vector<T>& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void shiftAppearance(CityModel& part, std::int32_t materials, std::int32_t textures) {
  if (materials == 0 && textures == 0) return;
  forEachObjectOf(part, [&](CityObject& object) {
    for (Geometry& geometry : object.geometries) {
      for (SurfaceInfo& surface : geometry.surfaces) {
        if (surface.material >= 0) surface.material += materials;
        if (surface.texture >= 0) surface.texture += textures;
      }
    }
  });
}

}  // namespace

CityModel mergeModels(std::vector<CityModel> parts) {
  if (parts.empty()) return {};
  CityModel whole = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    CityModel& part = parts[i];
    shiftAppearance(part, static_cast<std::int32_t>(whole.materials.size()),
                    static_cast<std::int32_t>(whole.textures.size()));
    for (Building& building : part.buildings)
      building.source += static_cast<std::uint32_t>(whole.sources.size());
    append(whole.sources, part.sources);
    append(whole.buildings, part.buildings);
    append(whole.others, part.others);
    append(whole.lines, part.lines);
    append(whole.materials, part.materials);
    append(whole.textures, part.textures);
  }
  return whole;
}

Diagnostics makeIdsUnique(CityModel& model) {
  Diagnostics diagnostics;
  std::unordered_map<std::string, std::size_t> taken;  // id → last suffix given
  std::size_t count = 0;
  forEachObjectOf(model, [&](const CityObject&) { ++count; });
  taken.reserve(count);
  std::size_t repeated = 0;
  std::size_t place = 0;
  forEachObjectOf(model, [&](CityObject& object) {
    if (object.id.empty()) object.id = fmt::format("object-{}", place);
    ++place;
    if (taken.emplace(object.id, 1).second) return;
    const std::string old = object.id;
    std::size_t& suffix = taken.at(old);
    do {
      object.id = fmt::format("{}_{}", old, ++suffix);
    } while (taken.contains(object.id));
    taken.emplace(object.id, 1);
    if (++repeated <= kSaidOneByOne) {
      diagnostics.push_back(diagnose(Code::DuplicateId, "now " + object.id, old));
    }
  });
  if (repeated > kSaidOneByOne) {
    diagnostics.push_back(
        diagnose(Code::DuplicateId, fmt::format("{} more objects", repeated - kSaidOneByOne)));
  }
  return diagnostics;
}

}  // namespace lodestone
