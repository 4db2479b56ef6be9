#include "model/io/cityjson/cityjson_encoder.h"

#include <algorithm>
#include <bit>
#include <iterator>

#include <fmt/format.h>

#include "model/io/cityjson/cityjson_objects.h"
#include "model/io/cityjson/cityjson_schema.h"
#include "model/io/json_writing.h"

namespace lodestone {
namespace {

/// Name of the one theme: the model keeps one material and one texture a surface.
constexpr std::string_view kTheme = "lodestone";

struct Corner {
  std::size_t vertex;        ///< number in the file
  std::uint32_t ringVertex;  ///< place in Geometry::ringVertices
};
struct EncodedSurface {
  SurfaceInfo info;
  std::vector<std::vector<Corner>> rings;
};
using Shell = std::vector<EncodedSurface>;

std::size_t fewestCorners(GeometryKind kind) {
  if (kind == GeometryKind::MultiPoint) return 1;
  return kind == GeometryKind::MultiCurve ? 2 : 3;
}

/// `[a,b,…]` of what `print(text, item)` writes for each.
template <class List, class Print>
void appendList(std::string& text, const List& list, Print&& print) {
  text += '[';
  bool first = true;
  for (const auto& item : list) {
    if (!first) text += ',';
    first = false;
    print(text, item);
  }
  text += ']';
}

std::string imageType(const std::string& name) {
  std::string ending = name.substr(std::min(name.size(), name.rfind('.')));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == ".png") return R"("type":"PNG",)";
  return ending == ".jpg" || ending == ".jpeg" ? R"("type":"JPG",)" : "";
}

std::string materialJson(const Material& material) {
  std::string text =
      fmt::format(R"({{"name":{},"diffuseColor":[{},{},{}],"transparency":{})", jsonQuoted(material.name),
                  material.diffuse[0], material.diffuse[1], material.diffuse[2], material.transparency);
  if (material.json.size() > 2) text += "," + material.json.substr(1, material.json.size() - 2);
  return text + "}";
}

std::string textureJson(const Texture& texture, const std::string& image) {
  std::string text = "{" + imageType(image) + "\"image\":" + jsonQuoted(image);
  if (!texture.wrap.empty()) text += ",\"wrapMode\":" + jsonQuoted(texture.wrap);
  if (!texture.type.empty()) text += ",\"textureType\":" + jsonQuoted(texture.type);
  return text + "}";
}

}  // namespace

/// A geometry as it will be written: solids of shells of surfaces, or one shell of surfaces.
struct CityJsonEncoder::Shape {
  GeometryKind kind = GeometryKind::MultiSurface;
  const Geometry* geometry = nullptr;
  std::vector<std::vector<Shell>> solids;

  /// Lists nested as the kind asks, with `print(text, surface)` for each surface.
  template <class Print>
  void appendNested(std::string& text, Print&& print) const {
    const auto shell = [&](std::string& out, const Shell& list) { appendList(out, list, print); };
    const auto solid = [&](std::string& out, const std::vector<Shell>& list) {
      appendList(out, list, shell);
    };
    if (kind == GeometryKind::Solid) {
      solid(text, solids.front());
    } else if (kind == GeometryKind::MultiSolid || kind == GeometryKind::CompositeSolid) {
      appendList(text, solids, solid);
    } else {
      shell(text, solids.front().front());
    }
  }
  template <class Test>
  [[nodiscard]] bool any(Test&& test) const {
    for (const auto& solid : solids) {
      for (const Shell& shell : solid) {
        if (std::any_of(shell.begin(), shell.end(), test)) return true;
      }
    }
    return false;
  }
};

std::size_t CityJsonEncoder::Uses::of(std::int32_t index) {
  const auto [entry, isNew] = number.try_emplace(index, used.size());
  if (isNew) used.push_back(index);
  return entry->second;
}

void CityJsonEncoder::reset() {
  vertices_.clear();
  vertexCount_ = 0;
  materials_ = {};
  textures_ = {};
  textureVertices_.clear();
  textureVertexNumbers_.clear();
}

void CityJsonEncoder::lose(std::string what) {
  if (std::find(losses_.begin(), losses_.end(), what) == losses_.end()) losses_.push_back(std::move(what));
}

void CityJsonEncoder::append(std::string& text, const Entry& entry) {
  places_.clear();
  appendObject(text, entry, {});
}

void CityJsonEncoder::appendObject(std::string& text, const Entry& entry, std::string_view parent) {
  const CityObject& object = *entry.object;
  const std::string type = cityJsonType(object, !parent.empty());
  text += jsonQuoted(object.id) + ":{\"type\":" + jsonQuoted(type);
  if (!parent.empty()) text += ",\"parents\":[" + jsonQuoted(parent) + "]";
  if (!object.children.empty()) {
    text += ",\"children\":";
    appendList(text, object.children,
               [](std::string& out, const CityObject& child) { out += jsonQuoted(child.id); });
  }
  appendMembers(text, entry, type);
  const std::size_t before = text.size();
  for (const Geometry& geometry : entry.geometries ? *entry.geometries : object.geometries) {
    appendGeometry(text, geometry, type);
  }
  if (text.size() > before) {
    text[before] = '[';  // instead of the first geometry's comma
    text.insert(before, ",\"geometry\":");
    text += ']';
  }
  text += '}';
  for (const CityObject& child : object.children) {
    text += ',';
    appendObject(text, {&child, nullptr, nullptr}, object.id);
  }
}

/// Attributes, and those of them that have a place of their own beside the attributes.
void CityJsonEncoder::appendMembers(std::string& text, const Entry& entry, std::string_view type) {
  const CityObject& object = *entry.object;
  std::string attributes;
  const auto addAttribute = [&](const std::string& name, const AttributeValue& value) {
    attributes += (attributes.empty() ? "" : ",") + jsonQuoted(name) + ":" + attributeJson(value);
  };
  bool hasMembers = !object.children.empty();
  for (const auto& [name, value] : object.attributes) {
    const auto* json = std::get_if<JsonText>(&value);
    const bool isGroup =
        object.type == ObjectType::ObjectGroup && (name == "children" || name == "children_roles");
    if (name == kTypeAttribute && toText(value) == type) continue;
    if (json && isGroup) {
      text += "," + jsonQuoted(name) + ":" + json->text;
      hasMembers = hasMembers || name == "children";
      continue;
    }
    const std::string addresses =
        json && name == "address" && hasAddress(type) ? addressList(json->text) : std::string();
    if (!addresses.empty()) {
      text += ",\"address\":" + addresses;
      continue;
    }
    addAttribute(name, value);
  }
  if (entry.more) {
    for (const auto& [name, value] : *entry.more) addAttribute(name, value);
  }
  if (object.type == ObjectType::ObjectGroup && !hasMembers) text += ",\"children\":[]";
  if (!attributes.empty()) text += ",\"attributes\":{" + attributes + "}";
}

CityJsonEncoder::Shape CityJsonEncoder::shapeOf(const Geometry& geometry, std::string_view type) {
  Shape shape;
  shape.kind = geometry.kind;
  shape.geometry = &geometry;
  const GeometryFit fit = geometryFit(type, geometry.kind);
  if (fit == GeometryFit::No) {
    lose(fmt::format("{} of a {}", kindName(geometry.kind), type));
    return shape;
  }
  if (fit == GeometryFit::AsCompositeSolid) shape.kind = GeometryKind::CompositeSolid;
  if (fit == GeometryFit::AsMultiSurface) shape.kind = GeometryKind::MultiSurface;
  if (fit == GeometryFit::AsCompositeSurface) shape.kind = GeometryKind::CompositeSurface;

  const auto encodeRing = [&](std::size_t r) {
    std::vector<std::pair<std::array<std::int64_t, 3>, std::uint32_t>> places;
    for (std::uint32_t i = geometry.ringStart[r]; i < geometry.ringStart[r + 1]; ++i) {
      const auto place = placement_.quantise(geometry.vertices[geometry.ringVertices[i]]);
      if (places.empty() || places.back().first != place) places.emplace_back(place, i);
    }
    const bool closes = fewestCorners(shape.kind) == 3;
    while (closes && places.size() > 1 && places.front().first == places.back().first) places.pop_back();
    std::vector<Corner> corners;
    if (places.size() < fewestCorners(shape.kind)) return corners;
    for (const auto& [place, i] : places) corners.push_back({vertexNumber(place), i});
    return corners;
  };
  const auto encodeShell = [&](std::size_t begin, std::size_t end) {
    Shell shell;
    for (std::size_t s = begin; s < end; ++s) {
      EncodedSurface surface{geometry.surfaces[s], {}};
      for (std::size_t r = geometry.surfaceStart[s]; r < geometry.surfaceStart[s + 1]; ++r) {
        std::vector<Corner> corners = encodeRing(r);
        const bool outer = r == geometry.surfaceStart[s];
        if (corners.empty() && outer) {
          lose("surfaces thinner than the steps of the file's coordinates");
          break;
        }
        if (!corners.empty()) surface.rings.push_back(std::move(corners));
      }
      if (!surface.rings.empty()) shell.push_back(std::move(surface));
    }
    return shell;
  };
  const bool nested = shape.kind == GeometryKind::Solid || shape.kind == GeometryKind::MultiSolid ||
                      shape.kind == GeometryKind::CompositeSolid;
  if (!nested || geometry.shellStart.size() < 2 || geometry.solidStart.size() < 2) {
    Shell shell = encodeShell(0, geometry.surfaceCount());
    if (!shell.empty()) shape.solids.push_back({std::move(shell)});
    return shape;
  }
  for (std::size_t k = 0; k + 1 < geometry.solidStart.size(); ++k) {
    std::vector<Shell> solid;
    for (std::size_t h = geometry.solidStart[k]; h < geometry.solidStart[k + 1]; ++h) {
      Shell shell = encodeShell(geometry.shellStart[h], geometry.shellStart[h + 1]);
      if (!shell.empty()) solid.push_back(std::move(shell));
    }
    if (!solid.empty()) shape.solids.push_back(std::move(solid));
  }
  return shape;
}

void CityJsonEncoder::appendGeometry(std::string& text, const Geometry& geometry, std::string_view type) {
  const Shape shape = shapeOf(geometry, type);
  if (shape.solids.empty()) return;
  const std::string lod = cityJsonLod(geometry.lod);
  if (lod != geometry.lod) lose(fmt::format("LoD \"{}\", written as \"{}\"", geometry.lod, lod));
  text += fmt::format(R"(,{{"type":"{}","lod":"{}","boundaries":)", kindName(shape.kind), lod);
  const auto ring = [](std::string& out, const std::vector<Corner>& corners) {
    appendList(out, corners, [](std::string& o, const Corner& corner) {
      fmt::format_to(std::back_inserter(o), "{}", corner.vertex);
    });
  };
  shape.appendNested(text, [&](std::string& out, const EncodedSurface& surface) {
    if (shape.kind == GeometryKind::MultiPoint) {
      fmt::format_to(std::back_inserter(out), "{}", surface.rings[0][0].vertex);
    } else if (shape.kind == GeometryKind::MultiCurve) {
      ring(out, surface.rings[0]);
    } else {
      appendList(out, surface.rings, ring);
    }
  });
  appendSemantics(text, shape);
  if (fewestCorners(shape.kind) == 3) {
    appendMaterials(text, shape);
    appendTextures(text, shape);
  }
  text += '}';
}

void CityJsonEncoder::appendSemantics(std::string& text, const Shape& shape) {
  std::vector<SurfaceType> types;
  const auto numberOf = [&](SurfaceType type) {
    return std::find(types.begin(), types.end(), type) - types.begin();
  };
  // CityJSON has no name for a generic surface: "+GenericSurface" would be one of an undeclared extension.
  const auto named = [](SurfaceType type) {
    return type != SurfaceType::Unknown && type != SurfaceType::Generic;
  };
  for (const SurfaceInfo& info : shape.geometry->surfaces) {
    const bool isNew = named(info.type) && static_cast<std::size_t>(numberOf(info.type)) == types.size();
    if (isNew) types.push_back(info.type);
  }
  if (types.empty()) return;
  text += ",\"semantics\":{\"surfaces\":";
  appendList(text, types, [](std::string& out, SurfaceType type) {
    out += fmt::format(R"({{"type":"{}"}})", toString(type));
  });
  text += ",\"values\":";
  shape.appendNested(text, [&](std::string& out, const EncodedSurface& surface) {
    out += named(surface.info.type) ? fmt::format("{}", numberOf(surface.info.type)) : "null";
  });
  text += '}';
}

void CityJsonEncoder::appendMaterials(std::string& text, const Shape& shape) {
  if (!shape.any([](const EncodedSurface& s) { return s.info.material >= 0; })) return;
  text += fmt::format(R"(,"material":{{"{}":{{"values":)", kTheme);
  shape.appendNested(text, [&](std::string& out, const EncodedSurface& surface) {
    out += surface.info.material < 0 ? "null" : fmt::format("{}", materials_.of(surface.info.material));
  });
  text += "}}";
}

void CityJsonEncoder::appendTextures(std::string& text, const Shape& shape) {
  const std::vector<Vec2f>& uvs = shape.geometry->textureCoordinates;
  if (uvs.empty() || !shape.any([](const EncodedSurface& s) { return s.info.texture >= 0; })) return;
  text += fmt::format(R"(,"texture":{{"{}":{{"values":)", kTheme);
  shape.appendNested(text, [&](std::string& out, const EncodedSurface& surface) {
    appendList(out, surface.rings, [&](std::string& o, const std::vector<Corner>& corners) {
      const bool textured = surface.info.texture >= 0 &&
                            std::all_of(corners.begin(), corners.end(),
                                        [&](const Corner& c) { return uvs[c.ringVertex].allFinite(); });
      if (!textured) {
        o += "[null]";
        return;
      }
      o += fmt::format("[{}", textures_.of(surface.info.texture));
      for (const Corner& corner : corners)
        o += fmt::format(",{}", textureVertexNumber(uvs[corner.ringVertex]));
      o += ']';
    });
  });
  text += "}}";
}

std::size_t CityJsonEncoder::vertexNumber(const std::array<std::int64_t, 3>& place) {
  const auto [entry, isNew] = places_.try_emplace(place, vertexCount_);
  if (isNew) {
    fmt::format_to(std::back_inserter(vertices_), "{}[{},{},{}]", vertexCount_ == 0 ? "" : ",", place[0],
                   place[1], place[2]);
    ++vertexCount_;
  }
  return entry->second;
}

std::size_t CityJsonEncoder::textureVertexNumber(const Vec2f& uv) {
  const std::uint64_t key =
      std::uint64_t{std::bit_cast<std::uint32_t>(uv.x())} << 32U | std::bit_cast<std::uint32_t>(uv.y());
  const auto [entry, isNew] = textureVertexNumbers_.try_emplace(key, textureVertices_.size());
  if (isNew) textureVertices_.push_back(uv);
  return entry->second;
}

std::string CityJsonEncoder::appearance(const std::vector<std::string>& imageNames) const {
  std::string text;
  const auto at = [](const auto& table, std::int32_t index) -> const auto& {
    return table[static_cast<std::size_t>(index)];
  };
  if (!materials_.used.empty()) {
    text += "\"materials\":";
    appendList(text, materials_.used, [&](std::string& out, std::int32_t index) {
      out += materialJson(at(model_.materials, index));
    });
  }
  if (!textures_.used.empty()) {
    text += text.empty() ? "\"textures\":" : ",\"textures\":";
    appendList(text, textures_.used, [&](std::string& out, std::int32_t index) {
      out += textureJson(at(model_.textures, index), at(imageNames, index));
    });
    text += ",\"vertices-texture\":";
    appendList(text, textureVertices_,
               [](std::string& out, const Vec2f& uv) { out += fmt::format("[{},{}]", uv.x(), uv.y()); });
  }
  return text.empty() ? text : "\"appearance\":{" + text + "}";
}

}  // namespace lodestone
