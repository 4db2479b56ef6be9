#include "model/io/citygml/citygml_appearance.h"

#include <limits>

#include <fmt/format.h>

#include "model/io/citygml/citygml_numbers.h"

namespace lodestone::citygml {

AppearanceTable::AppearanceTable(const std::string& file, bool allowOutside, Reports& reports)
    : images_(file, allowOutside), reports_(reports) {}

std::int32_t AppearanceTable::material(Material material) {
  const auto& d = material.diffuse;
  const std::string key =
      fmt::format("{}|{}|{}|{}|{}|{}", material.name, d[0], d[1], d[2], material.transparency, material.json);
  const auto [it, added] = materialNumbers_.try_emplace(key, static_cast<std::int32_t>(materials_.size()));
  if (added) materials_.push_back(std::move(material));
  return it->second;
}

Texture AppearanceTable::located(const std::string& uri) {
  Diagnostics said;
  Texture texture = images_.find(uri, said);
  for (Diagnostic& diagnostic : said) reports_.add(std::move(diagnostic));
  return texture;
}

std::int32_t AppearanceTable::texture(const std::string& uri, const std::string& wrap,
                                      const std::string& type) {
  const auto [it, added] = textureNumbers_.try_emplace(uri + '\n' + wrap + '\n' + type,
                                                       static_cast<std::int32_t>(textures_.size()));
  if (added) {
    textures_.push_back(located(uri));
    textures_.back().wrap = wrap;
    textures_.back().type = type;
  }
  return it->second;
}

void AppearanceTable::moveTo(CityModel& model) {
  model.materials = std::move(materials_);
  model.textures = std::move(textures_);
}

void AppearanceLinks::clear() {
  surfaces_.clear();
  rings_.clear();
  coordinates_.clear();
  projections_.clear();
}

void AppearanceLinks::setMaterial(std::uint64_t target, std::int32_t material) {
  OfSurface& entry = surfaces_[target];
  if (entry.material < 0) entry.material = material;
}

void AppearanceLinks::setTexture(std::uint64_t target, std::int32_t texture) {
  OfSurface& entry = surfaces_[target];
  if (entry.texture < 0) entry.texture = texture;
}

void AppearanceLinks::setProjection(std::uint64_t target, const std::array<double, 12>& matrix) {
  OfSurface& entry = surfaces_[target];
  if (entry.projection >= 0) return;
  entry.projection = static_cast<std::int32_t>(projections_.size());
  projections_.push_back(matrix);
}

void AppearanceLinks::setCoordinates(std::uint64_t ring, std::int32_t texture,
                                     const std::vector<double>& numbers) {
  const auto begin = static_cast<std::uint32_t>(coordinates_.size());
  const auto count = static_cast<std::uint32_t>(numbers.size() / 2);
  if (!rings_.try_emplace(ring, OfRing{texture, begin, count}).second) return;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    coordinates_.emplace_back(static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1]));
  }
}

bool AppearanceLinks::mentions(const GeometryPool& pool) const {
  for (const Target& target : pool.targets) {
    if (surfaces_.contains(target.id)) return true;
  }
  for (const PoolRing& ring : pool.rings) {
    if (ring.id != 0 && rings_.contains(ring.id)) return true;
  }
  return false;
}

void AppearanceLinks::apply(GeometryPool& pool, Reports& reports, const std::string& object) const {
  if (empty()) return;
  for (PoolSurface& surface : pool.surfaces) {
    for (std::uint32_t r = surface.ringBegin; r < surface.ringEnd; ++r) {
      PoolRing& ring = pool.rings[r];
      if (ring.id == 0 || ring.coordinates != kNothing) continue;
      const auto found = rings_.find(ring.id);
      if (found == rings_.end()) continue;
      if (surface.texture < 0) surface.texture = found->second.texture;
      if (surface.texture == found->second.texture) applyToRing(pool, ring, found->second, reports, object);
    }
  }
  for (const Target& target : pool.targets) {
    const auto found = surfaces_.find(target.id);
    if (found == surfaces_.end()) continue;
    for (std::uint32_t i = target.begin; i < target.end; ++i) {
      if (pool.items[i].kind == ItemKind::Surface) applyToSurface(pool, pool.items[i].surface, found->second);
    }
  }
}

void AppearanceLinks::applyToSurface(GeometryPool& pool, std::uint32_t number, const OfSurface& found) const {
  PoolSurface& surface = pool.surfaces[number];
  if (surface.material < 0) surface.material = found.material;
  if (surface.texture >= 0) return;
  surface.texture = found.texture;
  if (found.projection >= 0) project(pool, surface, projections_[static_cast<std::size_t>(found.projection)]);
}

void AppearanceLinks::applyToRing(GeometryPool& pool, PoolRing& ring, const OfRing& found, Reports& reports,
                                  const std::string& object) const {
  const std::uint32_t points = ring.end - ring.begin;
  // A list repeats its first point as the ring does; some writers leave the repetition out.
  if (found.count != points + 1 && found.count != points) {
    reports.add(Code::TextureBad, fmt::format("{} coordinates for {} points", found.count, points), object);
    return;
  }
  ring.coordinates = static_cast<std::uint32_t>(pool.textureCoordinates.size());
  const auto begin = coordinates_.begin() + found.begin;
  pool.textureCoordinates.insert(pool.textureCoordinates.end(), begin, begin + points);
}

void AppearanceLinks::project(GeometryPool& pool, const PoolSurface& surface,
                              const std::array<double, 12>& m) const {
  for (std::uint32_t r = surface.ringBegin; r < surface.ringEnd; ++r) {
    PoolRing& ring = pool.rings[r];
    ring.coordinates = static_cast<std::uint32_t>(pool.textureCoordinates.size());
    for (std::uint32_t i = ring.begin; i < ring.end; ++i) {
      const Vec3& p = pool.points[i];
      const auto row = [&](std::size_t k) {
        return m[k] * p.x() + m[k + 1] * p.y() + m[k + 2] * p.z() + m[k + 3];
      };
      const double q = row(8);
      const double scale = q == 0 ? std::numeric_limits<double>::quiet_NaN() : 1 / q;
      pool.textureCoordinates.emplace_back(static_cast<float>(row(0) * scale),
                                           static_cast<float>(row(4) * scale));
    }
  }
}

}  // namespace lodestone::citygml
