// A GLB file taken apart and checked against the glTF 2.0 specification, as far as our writer goes.
#pragma once

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lodestone::test {

class Glb {
 public:
  explicit Glb(std::string bytes) : bytes_(std::move(bytes)) { parse(); }

  nlohmann::json json;

  template <class Value>
  Value at(std::size_t offset) const {
    Value value;
    std::memcpy(&value, bytes_.data() + binary_ + offset, sizeof(Value));
    return value;
  }
  std::string view(std::size_t index) const {
    const auto& v = json["bufferViews"][index];
    return bytes_.substr(binary_ + v.value("byteOffset", 0U), v["byteLength"]);
  }
  /// Element i, component c of an accessor.
  double number(std::size_t accessor, std::size_t i, std::size_t c = 0) const {
    const auto& a = json["accessors"][accessor];
    const auto& v = json["bufferViews"][a["bufferView"].get<std::size_t>()];
    const std::size_t size = componentSize(a);
    const std::size_t stride = v.value("byteStride", size * components(a));
    const std::size_t offset = v.value("byteOffset", 0U) + a.value("byteOffset", 0U) + i * stride + c * size;
    switch (a["componentType"].get<int>()) {
      case 5126:
        return at<float>(offset);
      case 5125:
        return at<std::uint32_t>(offset);
      default:
        return at<std::uint16_t>(offset);
    }
  }
  static std::size_t componentSize(const nlohmann::json& a) { return a["componentType"] == 5123 ? 2 : 4; }
  static std::size_t components(const nlohmann::json& a) {
    const std::string type = a["type"];
    return type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
  }
  /// The texts of a string column, by offsets.
  std::vector<std::string> texts(const nlohmann::json& property) const {
    const std::string values = view(property["values"]);
    const std::string offsets = view(property["stringOffsets"]);
    std::vector<std::string> result;
    for (std::size_t i = 0; i + 8 <= offsets.size(); i += 4) {
      std::uint32_t range[2];
      std::memcpy(range, offsets.data() + i, 8);
      result.push_back(values.substr(range[0], range[1] - range[0]));
    }
    return result;
  }
  template <class Value>
  std::vector<Value> values(std::size_t index) const {
    const std::string bytes = view(index);
    std::vector<Value> result(bytes.size() / sizeof(Value));
    std::memcpy(result.data(), bytes.data(), result.size() * sizeof(Value));
    return result;
  }

  /// Everything that can be wrong with offsets, sizes, ranges and indices.
  void expectSound() const {
    for (const auto& v : json.value("bufferViews", nlohmann::json::array())) {
      EXPECT_LE(v.value("byteOffset", 0U) + v["byteLength"].get<std::size_t>(), bufferSize_);
      EXPECT_EQ(v.value("byteOffset", 0U) % 8, 0U);
    }
    for (std::size_t i = 0; i < json.value("accessors", nlohmann::json::array()).size(); ++i)
      expectSoundAccessor(i);
    for (const auto& mesh : json.value("meshes", nlohmann::json::array())) {
      for (const auto& p : mesh["primitives"]) expectSoundPrimitive(p);
    }
    for (const auto& node : json.value("nodes", nlohmann::json::array()))
      EXPECT_LT(node["mesh"], json["meshes"].size());
  }

 private:
  void parse() {
    ASSERT_GE(bytes_.size(), 20U);
    ASSERT_EQ(bytes_.substr(0, 4), "glTF");
    const auto word = [this](std::size_t offset) {
      std::uint32_t value = 0;
      std::memcpy(&value, bytes_.data() + offset, 4);
      return value;
    };
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes_.size());
    const std::size_t length = word(12);
    EXPECT_EQ(length % 4, 0U);
    EXPECT_EQ(bytes_.substr(16, 4), "JSON");
    json = nlohmann::json::parse(bytes_.substr(20, length));
    binary_ = 20 + length + 8;
    if (20 + length == bytes_.size()) return;
    bufferSize_ = word(20 + length);
    EXPECT_EQ(bufferSize_ % 4, 0U);
    EXPECT_EQ(binary_ + bufferSize_, bytes_.size());
    EXPECT_EQ(json["buffers"][0]["byteLength"], bufferSize_);
  }

  void expectSoundAccessor(std::size_t index) const {
    const auto& a = json["accessors"][index];
    const auto& v = json["bufferViews"][a["bufferView"].get<std::size_t>()];
    const std::size_t size = componentSize(a);
    const std::size_t count = a["count"];
    ASSERT_GT(count, 0U);
    const std::size_t stride = v.value("byteStride", size * components(a));
    EXPECT_EQ(a.value("byteOffset", 0U) % size, 0U);
    EXPECT_LE(a.value("byteOffset", 0U) + (count - 1) * stride + components(a) * size,
              v["byteLength"].get<std::size_t>());
    for (std::size_t c = 0; c < components(a); ++c) {
      double low = number(index, 0, c);
      double high = low;
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(std::isfinite(number(index, i, c)));
        low = std::min(low, number(index, i, c));
        high = std::max(high, number(index, i, c));
      }
      if (!a.contains("min")) continue;
      EXPECT_EQ(a["min"][c].get<double>(), low);
      EXPECT_EQ(a["max"][c].get<double>(), high);
    }
  }

  void expectSoundPrimitive(const nlohmann::json& p) const {
    const auto& attributes = p["attributes"];
    const std::size_t count = json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"];
    ASSERT_TRUE(json["accessors"][attributes["POSITION"].get<std::size_t>()].contains("min"));
    std::set<double> features;
    for (const auto& [name, accessor] : attributes.items())
      EXPECT_EQ(json["accessors"][accessor.get<std::size_t>()]["count"], count);
    for (std::size_t i = 0; i < count; ++i) {
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c) square += std::pow(number(attributes["NORMAL"], i, c), 2);
      EXPECT_NEAR(square, 1, 1e-5);
      features.insert(number(attributes["_FEATURE_ID_0"], i));
    }
    const std::size_t indices = p["indices"];
    EXPECT_EQ(json["accessors"][indices]["count"].get<std::size_t>() % 3, 0U);
    for (std::size_t i = 0; i < json["accessors"][indices]["count"].get<std::size_t>(); ++i)
      EXPECT_LT(number(indices, i), count);
    const auto& id = p["extensions"]["EXT_mesh_features"]["featureIds"][0];
    EXPECT_EQ(id["featureCount"], features.size());
    EXPECT_LT(*features.rbegin(),
              json["extensions"]["EXT_structural_metadata"]["propertyTables"][0]["count"].get<double>());
    EXPECT_LT(p["material"], json["materials"].size());
  }

  std::string bytes_;
  std::size_t binary_ = 0;
  std::size_t bufferSize_ = 0;
};

}  // namespace lodestone::test
