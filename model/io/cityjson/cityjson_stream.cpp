#include "model/io/cityjson/cityjson_stream.h"

#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/io/input_file.h"
#include "model/io/json_writing.h"
#include "model/io/texture_image.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

bool staysInside(const fs::path& relative) {
  return !relative.empty() && relative.is_relative() && *relative.begin() != "..";
}

std::string metadata(const CityModel& model, const CityJsonPlacement& placement,
                     const std::string& description) {
  std::string text;
  const std::string title = model.sources.empty() ? std::string() : model.sources.front().title;
  if (!title.empty()) text += "\"title\":" + jsonQuoted(title) + ",";
  if (!placement.referenceSystem().empty())
    text += "\"referenceSystem\":" + jsonQuoted(placement.referenceSystem()) + ",";
  return "\"metadata\":{" + text + "\"lodestone\":" + description + "}";
}

/// What the sources declare of extensions, for their types and attributes that start with "+"; of two that
/// share a name the first counts.
std::string extensions(const CityModel& model) {
  using Json = nlohmann::ordered_json;
  Json all = Json::object();
  for (const Source& source : model.sources) {
    const Json declared = Json::parse(source.extensions, nullptr, false);
    if (declared.is_object()) all.insert(declared.begin(), declared.end());
  }
  return all.empty() ? std::string()
                     : "\"extensions\":" + all.dump(-1, ' ', false, Json::error_handler_t::replace) + ",";
}

}  // namespace

CityJsonStream::CityJsonStream(const CityModel& model, const fs::path& path, CityJsonLayout layout)
    : model_(model),
      path_(path),
      layout_(layout),
      placement_(model),
      encoder_(model, placement_),
      file_(files_.add(path)) {
  nameImages(model);
  if (layout == CityJsonLayout::Document) {
    vertices_ = std::make_unique<AtomicFile>(path.parent_path() / (path.filename().string() + ".vertices"));
  }
}

/// Images below the file's folder are named from there; others get a place in a folder of their own beside
/// the file.
void CityJsonStream::nameImages(const CityModel& model) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(path_, error).parent_path(), error);
  const std::string ownFolder = path_.stem().stem().string() + ".textures";
  for (std::size_t i = 0; i < model.textures.size(); ++i) {
    const Texture& texture = model.textures[i];
    const fs::path image = texture.path;
    const fs::path relative = image.lexically_relative(folder);
    if (texture.missing) {
      imageNames_.push_back(texture.path);
    } else if (!texture.embedded && staysInside(relative)) {
      imageNames_.push_back(relative.generic_string());
    } else {
      imageNames_.push_back(fmt::format("{}/{}-{}", ownFolder, i, image.filename().string()));
    }
  }
}

void CityJsonStream::begin(const std::string& description) {
  file_.stream() << R"({"type":"CityJSON","version":"2.0",)" << extensions(model_) << placement_.transform()
                 << "," << metadata(model_, placement_, description) << ",\"CityObjects\":{";
  if (layout_ == CityJsonLayout::Sequence) file_.stream() << "},\"vertices\":[]}\n";
}

void CityJsonStream::add(const CityJsonEncoder::Entry& entry) {
  if (layout_ == CityJsonLayout::Sequence) return addFeature(entry);
  std::string text = first_ ? "\n" : ",\n";
  first_ = false;
  encoder_.append(text, entry);
  file_.stream() << text;
  vertices_->stream() << encoder_.takeVertices();
}

void CityJsonStream::addFeature(const CityJsonEncoder::Entry& entry) {
  encoder_.reset();
  std::string text =
      "{\"type\":\"CityJSONFeature\",\"id\":" + jsonQuoted(entry.object->id) + ",\"CityObjects\":{";
  encoder_.append(text, entry);
  text += '}';
  const std::string appearance = encoder_.appearance(imageNames_);
  if (!appearance.empty()) text += "," + appearance;
  text += ",\"vertices\":[" + encoder_.takeVertices() + "]}\n";
  file_.stream() << text;
  imagesUsed_.insert(encoder_.texturesUsed().begin(), encoder_.texturesUsed().end());
}

std::vector<fs::path> CityJsonStream::finish() {
  if (layout_ == CityJsonLayout::Document) {
    imagesUsed_.insert(encoder_.texturesUsed().begin(), encoder_.texturesUsed().end());
    const std::string appearance = encoder_.appearance(imageNames_);
    file_.stream() << "\n}" << (appearance.empty() ? "" : ",\n") << appearance << ",\n\"vertices\":[";
    vertices_->stream().flush();
    std::ifstream spooled(vertices_->temporaryPath(), std::ios::binary);
    // An empty stream copied into another one counts as a failure there.
    if (spooled.peek() != std::ifstream::traits_type::eof()) file_.stream() << spooled.rdbuf();
    file_.stream() << "]}\n";
    if (!vertices_->stream()) file_.stream().setstate(std::ios::badbit);
  }
  file_.close();
  copyImages();
  return files_.commit();
}

void CityJsonStream::copyImages() {
  for (const std::int32_t index : imagesUsed_) {
    const Texture& texture = model_.textures[static_cast<std::size_t>(index)];
    const fs::path target = path_.parent_path() / imageNames_[static_cast<std::size_t>(index)];
    std::error_code error;
    if (texture.missing || (!texture.embedded && fs::equivalent(target, texture.path, error))) continue;
    files_.add(target, readImage(texture));
  }
}

}  // namespace lodestone
