#include <algorithm>

#include <fmt/format.h>

#include "model/attributes.h"
#include "model/io/citygml/citygml_appearance.h"
#include "model/io/citygml/citygml_numbers.h"

namespace lodestone::citygml {
namespace {

bool isTrue(std::string_view text) {
  return text == "true" || text == "1";
}

}  // namespace

void AppearanceReader::startData(Data data) {
  data_ = data;
  material_ = Material{};
  front_ = true;
  targets_.clear();
  uri_.clear();
  wrap_.clear();
  type_.clear();
  texture_ = -1;
}

void AppearanceReader::startElement(const Tag& tag, const XmlAttributes& attributes) {
  const std::string_view local = tag.local;
  if (local == "textureCoordinates") {
    ring_ = linkHash(attributes.find("ring"));
  } else if (local == "target") {
    target_ = linkHash(attributes.find("uri"));
  } else if (local == "TextureAssociation") {
    target_ = 0;
  } else if (local == "TexCoordList") {
    waitingCoordinates_.clear();
    waitingRings_.clear();
  } else if (local == "X3DMaterial" || local == "Material") {
    startData(Data::Material);
    material_.name = attributes.gmlId();
  } else if (local == "ParameterizedTexture" || local == "SimpleTexture") {
    startData(Data::Parameterized);
  } else if (local == "GeoreferencedTexture") {
    startData(Data::Georeferenced);
  }
}

std::int32_t AppearanceReader::currentTexture() {
  if (texture_ < 0 && !uri_.empty()) texture_ = table_.texture(uri_, wrap_, type_);
  return texture_;
}

void AppearanceReader::endElement(std::string_view local, std::string_view text) {
  if (data_ == Data::None || !links_) return;
  if (local == "textureCoordinates") {
    endCoordinates(text);
  } else if (local == "ring") {
    waitingRings_.push_back(linkHash(text));
  } else if (local == "TexCoordList") {
    for (std::size_t i = 0; i < std::min(waitingRings_.size(), waitingCoordinates_.size()); ++i) {
      links_->setCoordinates(waitingRings_[i], currentTexture(), waitingCoordinates_[i]);
    }
    if (target_ != 0) links_->setTexture(target_, currentTexture());
  } else if (local == "worldToTexture") {
    numbers_.clear();
    if (!parseNumbers(text, numbers_) || numbers_.size() != 12 || target_ == 0) {
      reports_.add(Code::AppearanceBad, "worldToTexture needs 12 numbers and a target");
    } else {
      std::array<double, 12> matrix{};
      std::copy(numbers_.begin(), numbers_.end(), matrix.begin());
      links_->setTexture(target_, currentTexture());
      links_->setProjection(target_, matrix);
    }
  } else if (local == "target") {
    endTarget(text);
  } else if (local == "imageURI") {
    uri_ = text;
  } else if (local == "wrapMode") {
    wrap_ = text;
  } else if (local == "textureType") {
    type_ = text;
  } else if (local == "X3DMaterial" || local == "Material" || local == "ParameterizedTexture" ||
             local == "SimpleTexture" || local == "GeoreferencedTexture") {
    endData();
  } else if (data_ == Data::Material) {
    endMaterialField(local, text);
  }
}

void AppearanceReader::endCoordinates(std::string_view text) {
  numbers_.clear();
  if (!parseNumbers(text, numbers_) || numbers_.size() % 2 != 0) {
    reports_.add(Code::TextureBad, "textureCoordinates are not pairs of numbers");
    numbers_.clear();
  }
  if (ring_ != 0) {
    if (!numbers_.empty()) links_->setCoordinates(ring_, currentTexture(), numbers_);
  } else {
    waitingCoordinates_.push_back(numbers_);
  }
}

void AppearanceReader::endTarget(std::string_view text) {
  // CityGML 1 and 2 name textures' targets in an attribute, CityGML 3 and materials in the text.
  if (!text.empty()) target_ = linkHash(text);
  if (data_ != Data::Parameterized && target_ != 0) targets_.push_back(target_);
}

void AppearanceReader::endMaterialField(std::string_view local, std::string_view text) {
  numbers_.clear();
  const bool numbers = parseNumbers(text, numbers_);
  if (local == "diffuseColor" && numbers && numbers_.size() == 3) {
    std::transform(numbers_.begin(), numbers_.end(), material_.diffuse.begin(),
                   [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); });
  } else if (local == "transparency" && numbers && numbers_.size() == 1) {
    material_.transparency = static_cast<float>(std::clamp(numbers_[0], 0.0, 1.0));
  } else if ((local == "emissiveColor" || local == "specularColor") && numbers && numbers_.size() == 3) {
    addExtra(local, fmt::format("[{},{},{}]", numbers_[0], numbers_[1], numbers_[2]));
  } else if ((local == "ambientIntensity" || local == "shininess") && numbers && numbers_.size() == 1) {
    addExtra(local, fmt::format("{}", numbers_[0]));
  } else if (local == "isSmooth") {
    addExtra(local, isTrue(text) ? "true" : "false");
  } else if (local == "isFront") {
    front_ = isTrue(text);
  }
}

void AppearanceReader::addExtra(std::string_view name, const std::string& json) {
  std::string& all = material_.json;
  if (all.empty()) {
    all = "{";
  } else {
    all.back() = ',';
  }
  all += fmt::format("\"{}\":{}}}", name, json);
}

void AppearanceReader::endData() {
  const Data data = std::exchange(data_, Data::None);
  if (data == Data::Material && front_ && !targets_.empty()) {
    const std::int32_t material = table_.material(std::move(material_));
    for (std::uint64_t target : targets_) links_->setMaterial(target, material);
  } else if (data == Data::Georeferenced && !uri_.empty() && !targets_.empty()) {
    for (std::uint64_t target : targets_) links_->setTexture(target, currentTexture());
    reports_.once(Code::AppearanceBad,
                  "GeoreferencedTexture has no coordinates for surfaces: its image is named, not placed");
  }
}

}  // namespace lodestone::citygml
