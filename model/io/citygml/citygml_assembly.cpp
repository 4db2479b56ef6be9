#include "model/io/citygml/citygml_assembly.h"

#include <algorithm>
#include <map>

namespace lodestone::citygml {
namespace {

/// Links may show a surface several times, but not so often that a small file fills the memory.
constexpr std::uint64_t kStepsPerItem = 64;
constexpr std::uint64_t kStepsAnyway = 1 << 16;

std::uint8_t lodBit(const std::string& lod) {
  return lod.size() == 1 && lod[0] >= '0' && lod[0] <= '4' ? static_cast<std::uint8_t>(1 << (lod[0] - '0'))
                                                           : 0x80;
}

}  // namespace

void Assembler::Expansion::clear() {
  surfaces.clear();
  inSolids.clear();
  shells.clear();
  solids.clear();
  insideSolid = false;
}

Assembler::Assembler(GeometryPool& pool, const SharedGeometry& shared, Reports& reports)
    : pool_(pool),
      shared_(shared),
      reports_(reports),
      stepLimit_(kStepsPerItem * pool.items.size() + kStepsAnyway) {
  const bool linked = std::any_of(pool.items.begin(), pool.items.end(),
                                  [](const Item& item) { return item.kind == ItemKind::Link; });
  // Stable: of two with one id the first is meant.
  if (linked) {
    std::stable_sort(pool.targets.begin(), pool.targets.end(),
                     [](const Target& a, const Target& b) { return a.id < b.id; });
  }
}

const Target* Assembler::find(std::uint64_t id) const {
  const auto it =
      std::lower_bound(pool_.targets.begin(), pool_.targets.end(), id,
                       [](const Target& target, std::uint64_t wanted) { return target.id < wanted; });
  return it != pool_.targets.end() && it->id == id ? &*it : nullptr;
}

void Assembler::expand(const Draft& draft) {
  expansion_.clear();
  active_.clear();
  draft_ = &draft;
  expandItems(draft.begin, draft.end, false);
}

void Assembler::expandItems(std::uint32_t begin, std::uint32_t end, bool flip) {
  for (std::uint32_t i = begin; i < end; ++i) {
    if (++steps_ > stepLimit_) {
      reports_.once(Code::CountImplausible, "links multiply the surfaces of one object", idOf(*draft_));
      return;
    }
    const Item& item = pool_.items[i];
    switch (item.kind) {
      case ItemKind::Surface:
        show({nullptr, item.surface, item.flip != flip});
        break;
      case ItemKind::Link:
        follow(item, item.flip != flip);
        break;
      case ItemKind::Solid:
        expansion_.insideSolid = true;
        expansion_.solids.push_back(static_cast<std::uint32_t>(expansion_.shells.size()));
        break;
      case ItemKind::Shell:
        if (expansion_.insideSolid)
          expansion_.shells.push_back(static_cast<std::uint32_t>(expansion_.inSolids.size()));
        break;
      case ItemKind::SolidEnd:
        expansion_.insideSolid = false;
        break;
    }
  }
}

void Assembler::show(Shown shown) {
  if (!shown.shared && !pool_.surfaces[shown.surface].valid) return;
  if (!expansion_.insideSolid) return expansion_.surfaces.push_back(shown);
  if (expansion_.shells.size() == expansion_.solids.back()) {
    expansion_.shells.push_back(static_cast<std::uint32_t>(expansion_.inSolids.size()));
  }
  expansion_.inSolids.push_back(shown);
}

void Assembler::follow(const Item& item, bool flip) {
  if (std::find(active_.begin(), active_.end(), item.link) != active_.end()) {
    reports_.once(Code::XlinkCycle, {}, idOf(*draft_));
    return;
  }
  if (const Target* target = find(item.link)) {
    active_.push_back(item.link);
    expandItems(target->begin, target->end, flip != target->flip);
    active_.pop_back();
  } else if (const auto shared = shared_.find(item.link); shared != shared_.end()) {
    showShared(shared->second, flip);
  } else if (!silent_) {
    missing_.push_back(item.link);
    reports_.add(Code::XlinkUnresolved, {}, idOf(*draft_));
  }
}

void Assembler::showShared(const Geometry& geometry, bool flip) {
  stepLimit_ += geometry.surfaceCount();
  std::size_t shell = 0;
  std::size_t solid = 0;
  for (std::uint32_t s = 0; s < geometry.surfaceCount(); ++s) {
    ++steps_;
    while (shell + 1 < geometry.shellStart.size() && geometry.shellStart[shell] == s) {
      if (solid + 1 < geometry.solidStart.size() && geometry.solidStart[solid] == shell) {
        expansion_.insideSolid = true;
        expansion_.solids.push_back(static_cast<std::uint32_t>(expansion_.shells.size()));
        ++solid;
      }
      expansion_.shells.push_back(static_cast<std::uint32_t>(expansion_.inSolids.size()));
      ++shell;
    }
    show({&geometry, s, flip});
  }
  if (solid > 0) expansion_.insideSolid = false;
}

void Assembler::typeSurfaces(SurfaceType type) {
  if (type == SurfaceType::Unknown) return;
  for (const auto* list : {&expansion_.surfaces, &expansion_.inSolids}) {
    for (const Shown& shown : *list) {
      if (shown.shared) continue;
      PoolSurface& surface = pool_.surfaces[shown.surface];
      if (surface.type == SurfaceType::Unknown) surface.type = type;
    }
  }
}

std::string Assembler::lodOf(const Draft& draft) const {
  if (!draft.lod.empty()) return draft.lod;
  // Reliefs say their level in a property of their own.
  return pool_.objects[draft.object].object.attributes.text("lod").value_or(std::string());
}

void Assembler::markUsed(const Draft& draft, const std::vector<Shown>& surfaces) {
  for (const Shown& shown : surfaces) {
    Use& use = shown.shared ? usedShared_[{shown.shared, shown.surface}] : used_[shown.surface];
    use.lods |= lodBit(draft.lod);
    use.object = std::min(use.object, draft.object);
  }
}

bool Assembler::isShownElsewhere(const Shown& shown, const Draft& draft) const {
  Use use;
  if (!shown.shared) {
    use = used_[shown.surface];
  } else if (const auto it = usedShared_.find({shown.shared, shown.surface}); it != usedShared_.end()) {
    use = it->second;
  }
  if ((use.lods & lodBit(draft.lod)) == 0) return false;
  for (std::uint32_t object = draft.object; object != kNothing; object = pool_.objects[object].parent) {
    if (object == use.object) return true;
  }
  return false;
}

void Assembler::leaveOutUsed(const Draft& draft, std::vector<Shown>& surfaces) const {
  std::erase_if(surfaces, [&](const Shown& shown) { return isShownElsewhere(shown, draft); });
}

void Assembler::build(const Draft& draft) {
  expand(draft);
  const Placement* placement =
      draft.placement < 0 ? nullptr : &pool_.placements[static_cast<std::size_t>(draft.placement)];
  auto& geometries = pool_.objects[draft.object].object.geometries;
  if (expansion_.inSolids.empty() && expansion_.surfaces.empty()) {
    if (draft.end > draft.begin) reports_.add(Code::GeometryEmpty, "lod" + lodOf(draft), idOf(draft));
    return;
  }
  if (!placement) leaveOutUsed(draft, expansion_.surfaces);
  if (!expansion_.inSolids.empty()) {
    geometries.push_back(makeSolid(draft.kind, placement));
    geometries.back().lod = lodOf(draft);
    markUsed(draft, expansion_.inSolids);
  }
  if (!expansion_.surfaces.empty()) {
    const bool composite = draft.kind == GeometryKind::CompositeSurface;
    geometries.push_back(make(expansion_.surfaces, placement));
    geometries.back().kind = composite ? GeometryKind::CompositeSurface : GeometryKind::MultiSurface;
    geometries.back().lod = lodOf(draft);
    markUsed(draft, expansion_.surfaces);
  }
  if (placement && !geometries.empty()) placed_ += geometries.back().vertices.size();
}

Geometry Assembler::makeSolid(GeometryKind kind, const Placement* placement) {
  Geometry geometry = make(expansion_.inSolids, placement);
  geometry.shellStart.assign(expansion_.shells.begin(), expansion_.shells.end());
  geometry.shellStart.push_back(static_cast<std::uint32_t>(expansion_.inSolids.size()));
  geometry.solidStart.assign(expansion_.solids.begin(), expansion_.solids.end());
  geometry.solidStart.push_back(static_cast<std::uint32_t>(expansion_.shells.size()));
  const bool composite = kind == GeometryKind::CompositeSolid || kind == GeometryKind::MultiSolid;
  geometry.kind = composite                       ? kind
                  : expansion_.solids.size() == 1 ? GeometryKind::Solid
                                                  : GeometryKind::MultiSolid;
  return geometry;
}

void Assembler::buildThematic() {
  std::map<std::pair<std::uint32_t, std::string>, std::vector<Shown>> shown;
  for (const Draft& draft : pool_.drafts) {
    if (!draft.thematic) continue;
    expand(draft);
    auto& list = shown[{draft.object, draft.lod}];
    for (const auto* from : {&expansion_.surfaces, &expansion_.inSolids}) {
      std::copy_if(from->begin(), from->end(), std::back_inserter(list),
                   [&](const Shown& surface) { return !isShownElsewhere(surface, draft); });
    }
  }
  for (const auto& [key, surfaces] : shown) {
    if (surfaces.empty()) continue;
    Geometry geometry = make(surfaces, nullptr);
    geometry.lod = key.second;
    pool_.objects[key.first].object.geometries.push_back(std::move(geometry));
  }
}

std::vector<CityObject> Assembler::assemble() {
  silent_ = true;
  for (const Draft& draft : pool_.drafts) {
    if (draft.type == SurfaceType::Unknown) continue;
    // Surfaces inside have their type from their element: only links can bring others.
    const auto isLink = [](const Item& item) { return item.kind == ItemKind::Link; };
    if (std::none_of(pool_.items.begin() + draft.begin, pool_.items.begin() + draft.end, isLink)) continue;
    expand(draft);
    typeSurfaces(draft.type);
  }
  silent_ = false;
  used_.assign(pool_.surfaces.size(), Use{});
  for (const Draft& draft : pool_.drafts) {
    if (!draft.thematic && draft.isSolid()) build(draft);
  }
  for (const Draft& draft : pool_.drafts) {
    if (!draft.thematic && !draft.isSolid()) build(draft);
  }
  buildThematic();
  return takeObjects();
}

Geometry Assembler::extract(const Target& target) {
  const Draft whole{.lod = {}, .object = 0, .begin = target.begin, .end = target.end};
  expand(whole);
  Geometry geometry = expansion_.inSolids.empty() ? make(expansion_.surfaces, nullptr)
                                                  : makeSolid(GeometryKind::MultiSurface, nullptr);
  draft_ = nullptr;
  return geometry;
}

std::vector<CityObject> Assembler::takeObjects() {
  std::vector<CityObject> roots;
  for (std::size_t i = pool_.objects.size(); i-- > 0;) {
    CityObject& object = pool_.objects[i].object;
    const std::uint32_t parent = pool_.objects[i].parent;
    std::reverse(object.children.begin(), object.children.end());
    const bool standsAlone = object.type == ObjectType::Building && parent != kNothing &&
                             pool_.objects[parent].object.type != ObjectType::Building &&
                             pool_.objects[parent].object.type != ObjectType::BuildingPart;
    if (parent == kNothing || standsAlone) {
      roots.push_back(std::move(object));
    } else {
      pool_.objects[parent].object.children.push_back(std::move(object));
    }
  }
  std::reverse(roots.begin(), roots.end());
  pool_.objects.clear();
  return roots;
}

}  // namespace lodestone::citygml
