#include "model/io/meshes/obj_text.h"

#include <cmath>
#include <iterator>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace lodestone {
namespace {

using Triangles = std::span<const LevelObject::Triangle>;

/// Shortest digits of a number of whole millimetres; −0 is 0.
double toMillimetres(double x) {
  return std::round(x * 1000) / 1000 + 0.0;
}

/// Which texture coordinate each vertex of a surface has, by position among the ring vertices; empty: none.
std::map<std::uint32_t, std::uint32_t> cornersOf(const Geometry& geometry, std::uint32_t surface) {
  std::map<std::uint32_t, std::uint32_t> corners;
  if (geometry.textureCoordinates.empty()) return corners;
  const std::uint32_t begin = geometry.ringStart[geometry.surfaceStart[surface]];
  const std::uint32_t end = geometry.ringStart[geometry.surfaceStart[surface + 1]];
  for (std::uint32_t i = begin; i < end; ++i) {
    if (!geometry.textureCoordinates[i].allFinite()) return {};
    corners.emplace(geometry.ringVertices[i], i);
  }
  return corners;
}

/// The corners of a surface of one ring that two triangles of a fan make up: a convex quad, like all walls of
/// blocks.
std::span<const std::uint32_t> quadOf(const Geometry& geometry, std::uint32_t surface, Triangles triangles) {
  const std::uint32_t ring = geometry.surfaceStart[surface];
  const std::span<const std::uint32_t> corners(geometry.ringVertices.data() + geometry.ringStart[ring],
                                               geometry.ringStart[ring + 1] - geometry.ringStart[ring]);
  const bool oneRing = geometry.surfaceStart[surface + 1] == ring + 1;
  if (!oneRing || corners.size() != 4 || triangles.size() != 2) return {};
  const auto& p = geometry.vertices;
  const Vec3 first = (p[corners[1]] - p[corners[0]]).cross(p[corners[2]] - p[corners[1]]);
  for (std::size_t i = 1; i < 4; ++i) {
    const Vec3 a = p[corners[(i + 1) % 4]] - p[corners[i]];
    const Vec3 b = p[corners[(i + 2) % 4]] - p[corners[(i + 1) % 4]];
    const Vec3 turn = a.cross(b);
    if (turn.dot(first) < 0.999 * turn.norm() * first.norm() || turn.norm() <= 0) return {};
  }
  return corners;
}

class TextMaker {
 public:
  TextMaker(const CityModel* city, const ObjOffsets& before, const std::vector<bool>& usableTextures)
      : city_(city), before_(before), usable_(usableTextures) {}

  void add(const LevelObject& object) {
    if (object.geometries.empty()) return;
    describe(object);
    print("g {}\n", objName(object.id));
    material_.clear();
    for (std::size_t g = 0; g < object.geometries.size(); ++g) addGeometry(object, g);
  }

  ObjText take() {
    result_.text = fmt::to_string(out_);
    return std::move(result_);
  }

 private:
  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  void describe(const LevelObject& object) {
    if (object.role == DrawRole::Building) return;
    print("# {}", toString(object.role));
    if (object.of != kNoNode) print(" of cluster-{}", object.of);
    for (std::uint32_t building : object.buildings) {
      if (city_) print(" {}", objName(city_->buildings[building].object.id));
    }
    print("\n");
  }

  void addGeometry(const LevelObject& object, std::size_t g) {
    const Geometry& geometry = object.geometries[g];
    for (const Vec3& p : geometry.vertices) {
      print("v {} {} {}\n", toMillimetres(p.x()), toMillimetres(p.y()), toMillimetres(p.z()));
    }
    for (const Vec2f& st : geometry.textureCoordinates) {
      print("vt {} {}\n", std::isfinite(st.x()) ? st.x() : 0.F, std::isfinite(st.y()) ? st.y() : 0.F);
    }
    const auto& triangles = object.triangles[g];
    for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
      while (end < triangles.size() && triangles[end].surface == triangles[begin].surface) ++end;
      addSurface(geometry, object.role, {triangles.data() + begin, end - begin});
    }
    before_.vertices += geometry.vertices.size();
    before_.coordinates += geometry.textureCoordinates.size();
  }

  void addSurface(const Geometry& geometry, DrawRole role, Triangles triangles) {
    const std::uint32_t surface = triangles.front().surface;
    const SurfaceInfo& info = geometry.surfaces[surface];
    auto corners = cornersOf(geometry, surface);
    const bool textured = info.texture >= 0 && !corners.empty() &&
                          static_cast<std::size_t>(info.texture) < usable_.size() &&
                          usable_[static_cast<std::size_t>(info.texture)];
    useMaterial(role, info, textured);
    const std::span<const std::uint32_t> quad = quadOf(geometry, surface, triangles);
    if (!quad.empty()) return addFace(quad, corners);
    for (const auto& t : triangles) addFace(t.vertices, corners);
  }

  void useMaterial(DrawRole role, const SurfaceInfo& info, bool textured) {
    std::string name = objMaterialName(role, info, textured);
    if (name == material_) return;
    print("usemtl {}\n", name);
    result_.materials.try_emplace(name, ObjText::Use{role, info, textured});
    material_ = std::move(name);
  }

  void addFace(std::span<const std::uint32_t> vertices,
               const std::map<std::uint32_t, std::uint32_t>& corners) {
    out_.push_back('f');
    for (std::uint32_t v : vertices) {
      print(" {}", before_.vertices + v + 1);
      if (!corners.empty()) print("/{}", before_.coordinates + corners.at(v) + 1);
    }
    out_.push_back('\n');
  }

  const CityModel* city_;
  ObjOffsets before_;
  const std::vector<bool>& usable_;
  fmt::memory_buffer out_;
  std::string material_;
  ObjText result_;
};

}  // namespace

std::string objMaterialName(DrawRole role, const SurfaceInfo& surface, bool textured) {
  if (textured) return fmt::format("texture-{}", surface.texture);
  if (surface.material >= 0) return fmt::format("material-{}", surface.material);
  const char* type = toString(surface.type);
  return fmt::format("{}-{}", toString(role), *type == '\0' ? "Surface" : type);
}

std::string objName(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= ' ' || byte == 0x7F || c == '%') {
      result += fmt::format("%{:02X}", byte);
    } else {
      result += c;
    }
  }
  return result.empty() ? "%00" : result;
}

ObjOffsets objSizes(std::span<const LevelObject> objects) {
  ObjOffsets sizes;
  for (const LevelObject& object : objects) {
    for (const Geometry& geometry : object.geometries) {
      sizes.vertices += geometry.vertices.size();
      sizes.coordinates += geometry.textureCoordinates.size();
    }
  }
  return sizes;
}

ObjText makeObjText(std::span<const LevelObject> objects, const CityModel* city, const ObjOffsets& before,
                    const std::vector<bool>& usableTextures) {
  TextMaker maker(city, before, usableTextures);
  for (const LevelObject& object : objects) maker.add(object);
  return maker.take();
}

}  // namespace lodestone
