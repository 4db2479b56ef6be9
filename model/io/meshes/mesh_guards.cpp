#include "model/io/meshes/mesh_guards.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <expat.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/io/input_file.h"

namespace lodestone {
namespace {

/// Looks through a COLLADA file for what assimp takes on trust.
class ColladaCheck {
 public:
  /// What is wrong; empty when nothing is.
  std::string operator()(const std::string& text) {
    const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                              &XML_ParserFree);
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(
        parser.get(),
        [](void* self, const char* name, const char** attributes) {
          static_cast<ColladaCheck*>(self)->begin(name, attributes);
        },
        [](void* self, const char*) { static_cast<ColladaCheck*>(self)->inIndices_ = false; });
    XML_SetCharacterDataHandler(parser.get(), [](void* self, const char* data, int size) {
      static_cast<ColladaCheck*>(self)->read({data, static_cast<std::size_t>(size)});
    });
    if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_ERROR)
      return XML_ErrorString(XML_GetErrorCode(parser.get()));
    for (const Accessor& accessor : accessors_) {
      const auto array = arraySize_.find(accessor.source);
      if (array == arraySize_.end() || accessor.end() > array->second)
        return fmt::format("an accessor beyond the end of array '{}'", accessor.source);
    }
    return trouble_;
  }

 private:
  /// Values of an array that stand for something: count × stride of them, `params` named in each.
  struct Accessor {
    std::string source;
    double count = 0;
    double stride = 1;
    double offset = 0;
    double params = 0;
    [[nodiscard]] double end() const {
      return count <= 0 ? 0 : offset + (count - 1) * stride + std::max(params, 1.0);
    }
  };

  void begin(std::string_view name, const char** attributes) {
    inIndices_ = name == "p";
    if (name == "param" && !accessors_.empty()) ++accessors_.back().params;
    if (!name.ends_with("_array") && name != "accessor") return;
    Accessor found;
    std::string id;
    for (; *attributes; attributes += 2) {
      const std::string_view key = attributes[0];
      const char* const value = attributes[1];
      if (key == "id") id = value;
      if (key == "source") found.source = value[0] == '#' ? value + 1 : value;
      if (key == "count") found.count = numberOf(value);
      if (key == "stride") found.stride = numberOf(value);
      if (key == "offset") found.offset = numberOf(value);
    }
    if (name == "accessor")
      accessors_.push_back(found);
    else
      arraySize_[id] = found.count;
  }

  double numberOf(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 0 || value > 1e9)
      trouble_ = fmt::format("'{}' where a count should be", text);
    return value;
  }

  void read(std::string_view text) {
    if (inIndices_ && text.find_first_not_of("0123456789+- \t\r\n") != std::string_view::npos)
      trouble_ = "an index that is no whole number";
  }

  std::vector<Accessor> accessors_;
  std::unordered_map<std::string, double> arraySize_;
  bool inIndices_ = false;
  std::string trouble_;
};

/// The version that a glTF file, binary or not, claims; empty where it says none.
std::string gltfVersion(const std::string& bytes) {
  if (bytes.starts_with("glTF")) return bytes.size() > 4 ? std::to_string(static_cast<int>(bytes[4])) : "";
  const auto json = nlohmann::json::parse(bytes, nullptr, false);
  if (!json.is_object() || !json.contains("asset") || !json["asset"].is_object()) return {};
  const auto version = json["asset"].find("version");
  return version != json["asset"].end() && version->is_string() ? version->get<std::string>() : std::string();
}

}  // namespace

std::optional<Diagnostic> whyRefused(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == ".dae") {
    const std::string trouble = ColladaCheck()(readWholeFile(path));
    return trouble.empty() ? std::nullopt
                           : std::optional(diagnose(Code::FileMalformed, trouble, {}, path.string()));
  }
  if (ending != ".gltf" && ending != ".glb") return std::nullopt;
  const std::string version =
      gltfVersion(ending == ".glb" && readHead(path, 4) == "glTF" ? readHead(path, 8) : readWholeFile(path));
  if (version.starts_with("2")) return std::nullopt;
  return version.empty() ? diagnose(Code::FileMalformed, "it names no glTF version", {}, path.string())
                         : diagnose(Code::VersionUnsupported, "glTF " + version, {}, path.string());
}

}  // namespace lodestone
