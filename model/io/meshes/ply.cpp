#include "model/io/meshes/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace lodestone {
namespace {

enum class Encoding { Ascii, Little, Big };

struct NumberType {
  std::size_t size;
  bool real;
  bool isSigned;
};

NumberType typeOf(std::string_view name) {
  struct Named {
    std::string_view name;
    NumberType type;
  };
  static constexpr std::array<Named, 16> kTypes{{{"char", {1, false, true}},
                                                 {"int8", {1, false, true}},
                                                 {"uchar", {1, false, false}},
                                                 {"uint8", {1, false, false}},
                                                 {"short", {2, false, true}},
                                                 {"int16", {2, false, true}},
                                                 {"ushort", {2, false, false}},
                                                 {"uint16", {2, false, false}},
                                                 {"int", {4, false, true}},
                                                 {"int32", {4, false, true}},
                                                 {"uint", {4, false, false}},
                                                 {"uint32", {4, false, false}},
                                                 {"float", {4, true, true}},
                                                 {"float32", {4, true, true}},
                                                 {"double", {8, true, true}},
                                                 {"float64", {8, true, true}}}};
  for (const Named& named : kTypes) {
    if (named.name == name) return named.type;
  }
  throw std::runtime_error(fmt::format("unknown type '{}'", name));
}

struct Property {
  std::string name;
  NumberType type{};
  bool list = false;
  NumberType countType{};
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::Ascii;
  std::vector<Element> elements;
  std::string texture;
  std::size_t size = 0;  ///< bytes up to the first element
};

std::string_view nextLine(std::string_view bytes, std::size_t& at) {
  const std::size_t end = bytes.find('\n', at);
  if (end == std::string_view::npos) throw std::runtime_error("its header does not end");
  std::string_view line = bytes.substr(at, end - at);
  at = end + 1;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The next word of a line, taken off its front.
std::string_view word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  const std::string_view result = line.substr(0, std::min(line.find_first_of(" \t"), line.size()));
  line.remove_prefix(result.size());
  return result;
}

Encoding encodingOf(std::string_view name) {
  if (name == "ascii") return Encoding::Ascii;
  if (name == "binary_little_endian") return Encoding::Little;
  if (name == "binary_big_endian") return Encoding::Big;
  throw std::runtime_error(fmt::format("unknown format '{}'", name));
}

Element elementOf(std::string_view line) {
  Element element{std::string(word(line)), 0, {}};
  const std::string_view count = word(line);
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (error != std::errc() || end != count.data() + count.size())
    throw std::runtime_error(fmt::format("bad number of elements '{}'", count));
  return element;
}

Property propertyOf(std::string_view line) {
  Property property;
  std::string_view type = word(line);
  property.list = type == "list";
  if (property.list) {
    property.countType = typeOf(word(line));
    type = word(line);
  }
  property.type = typeOf(type);
  property.name = word(line);
  return property;
}

Header headerOf(std::string_view bytes) {
  Header header;
  std::size_t at = std::min(bytes.find_first_not_of("\r\n"), bytes.size());
  if (nextLine(bytes, at) != "ply") throw std::runtime_error("it does not begin with 'ply'");
  for (bool ended = false; !ended;) {
    std::string_view line = nextLine(bytes, at);
    const std::string_view key = word(line);
    if (key == "format") {
      header.encoding = encodingOf(word(line));
    } else if (key == "element") {
      header.elements.push_back(elementOf(line));
    } else if (key == "property") {
      if (header.elements.empty()) throw std::runtime_error("a property before all elements");
      header.elements.back().properties.push_back(propertyOf(line));
    } else if (key == "comment" && word(line) == "TextureFile") {
      line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
      header.texture = line;
    }
    ended = key == "end_header";
  }
  header.size = at;
  return header;
}

/// Numbers of the body one by one.
class Numbers {
 public:
  Numbers(std::string_view bytes, Encoding encoding) : bytes_(bytes), encoding_(encoding) {}

  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

  /// \throw std::length_error at the end, std::runtime_error for what is no number
  double next(const NumberType& type) { return encoding_ == Encoding::Ascii ? text() : binary(type); }

 private:
  double text() {
    at_ = std::min(bytes_.find_first_not_of(" \t\r\n", at_), bytes_.size());
    if (at_ == bytes_.size()) throw std::length_error("it ends before its last element");
    double value = 0;
    if (bytes_[at_] == '+') ++at_;
    const char* const end = bytes_.data() + bytes_.size();
    const auto [stop, error] = std::from_chars(bytes_.data() + at_, end, value);
    if (error == std::errc::invalid_argument)
      throw std::runtime_error(fmt::format("no number at byte {} of the body", at_));
    at_ = static_cast<std::size_t>(stop - bytes_.data());
    return error == std::errc() ? value : std::numeric_limits<double>::infinity();
  }

  double binary(const NumberType& type) {
    if (left() < type.size) throw std::length_error("it ends before its last element");
    std::array<unsigned char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, type.size);
    at_ += type.size;
    const bool swap = (encoding_ == Encoding::Big) != (std::endian::native == std::endian::big);
    if (swap) std::reverse(raw.data(), raw.data() + type.size);
    if (type.real) return type.size == 4 ? as<float>(raw) : as<double>(raw);
    if (type.size == 1) return type.isSigned ? as<std::int8_t>(raw) : as<std::uint8_t>(raw);
    if (type.size == 2) return type.isSigned ? as<std::int16_t>(raw) : as<std::uint16_t>(raw);
    return type.isSigned ? as<std::int32_t>(raw) : as<std::uint32_t>(raw);
  }
  template <class T>
  static double as(const std::array<unsigned char, 8>& raw) {
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return static_cast<double>(value);
  }

  std::string_view bytes_;
  Encoding encoding_;
  std::size_t at_ = 0;
};

/// A vertex number, or one that no vertex has.
std::uint32_t indexOf(double value) {
  return value >= 0 && value < 4e9 ? static_cast<std::uint32_t>(value) : 0xFFFFFFFFU;
}

std::size_t countOf(double value, std::size_t most) {
  if (!(value >= 0) || value > static_cast<double>(most))
    throw std::length_error("a list longer than what is left of it");
  return static_cast<std::size_t>(value);
}

/// What a property of a vertex is to us: 0–2 a coordinate, 3 and 4 a texture coordinate, −1 nothing.
int roleOf(const std::string& name) {
  static constexpr std::array<std::array<std::string_view, 4>, 5> kNames{
      {{"x"}, {"y"}, {"z"}, {"s", "u", "texture_u", "texture_s"}, {"t", "v", "texture_v", "texture_t"}}};
  for (std::size_t role = 0; role < kNames.size(); ++role) {
    for (const std::string_view known : kNames[role]) {
      if (!known.empty() && known == name) return static_cast<int>(role);
    }
  }
  return -1;
}

class Body {
 public:
  Body(std::string_view bytes, const Header& header) : numbers_(bytes, header.encoding) {
    mesh_.texture = header.texture;
    for (const Element& element : header.elements) read(element);
  }
  PlyMesh take() { return std::move(mesh_); }

 private:
  void read(const Element& element) {
    if (element.properties.empty()) return;
    if (element.count > numbers_.left()) throw std::length_error("more elements claimed than it has bytes");
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        readVertex(element);
      else if (element.name == "face")
        readFace(element);
      else
        for (const Property& property : element.properties) readValues(property);
    }
  }

  /// The number, or all numbers of a list.
  const std::vector<double>& readValues(const Property& property) {
    const std::size_t count = property.list ? countOf(numbers_.next(property.countType), numbers_.left()) : 1;
    values_.clear();
    for (std::size_t i = 0; i < count; ++i) values_.push_back(numbers_.next(property.type));
    return values_;
  }

  void readVertex(const Element& element) {
    std::array<double, 5> found{};
    bool textured = false;
    for (const Property& property : element.properties) {
      const std::vector<double>& values = readValues(property);
      const int role = property.list ? -1 : roleOf(property.name);
      if (role >= 0) found[static_cast<std::size_t>(role)] = values.front();
      textured = textured || role >= 3;
    }
    mesh_.vertices.emplace_back(found[0], found[1], found[2]);
    if (textured)
      mesh_.vertexCoordinates.emplace_back(static_cast<float>(found[3]), static_cast<float>(found[4]));
  }

  void readFace(const Element& element) {
    std::vector<Vec2f> coordinates;
    for (const Property& property : element.properties) {
      const std::vector<double>& values = readValues(property);
      if (property.name == "vertex_indices" || property.name == "vertex_index") {
        for (const double value : values) mesh_.corners.push_back(indexOf(value));
      } else if (property.name == "texcoord") {
        for (std::size_t i = 0; i + 1 < values.size(); i += 2)
          coordinates.emplace_back(static_cast<float>(values[i]), static_cast<float>(values[i + 1]));
      }
    }
    const std::size_t first = mesh_.faceStart.back();
    mesh_.faceStart.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    if (coordinates.empty() && mesh_.cornerCoordinates.empty()) return;
    const Vec2f none = Vec2f::Constant(std::numeric_limits<float>::quiet_NaN());
    mesh_.cornerCoordinates.resize(first, none);
    mesh_.cornerCoordinates.insert(mesh_.cornerCoordinates.end(), coordinates.begin(), coordinates.end());
    mesh_.cornerCoordinates.resize(mesh_.corners.size(), none);
  }

  Numbers numbers_;
  PlyMesh mesh_;
  std::vector<double> values_;
};

}  // namespace

PlyMesh parsePly(std::string_view bytes) {
  const Header header = headerOf(bytes);
  return Body(bytes.substr(header.size), header).take();
}

}  // namespace lodestone
