#include "model/io/dendrogram_json.h"

#include <cmath>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/io/atomic_file.h"
#include "model/io/json_writing.h"

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;

std::string choiceText(const ClusterOptions& options, const char* name) {
  for (const auto& [field, value] : values(options)) {
    if (field == name) return toText(value);
  }
  return {};
}

// Infinity (clusters that nothing joins) has no JSON number.
std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}
double numberFrom(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

std::string point(const Vec3& p) {
  return fmt::format("[{}, {}, {}]", p.x(), p.y(), p.z());
}

std::string drawnLine(const DrawnNode& drawn) {
  std::string line = fmt::format("{{\"node\": {}, \"role\": \"{}\"", drawn.node, toString(drawn.role));
  if (drawn.role == DrawRole::Landmark) line += fmt::format(", \"of\": {}", drawn.of);
  if (drawn.role == DrawRole::Cluster) {
    line += fmt::format(", \"box_pixels\": {}, \"alpha_height\": {}", number(drawn.boxPixels),
                        number(drawn.alphaHeight));
  }
  return line + "}";
}

/// \throw nlohmann::json::exception
LoadedDendrogram dendrogramFrom(const Json& json) {
  LoadedDendrogram loaded;
  Dendrogram& d = loaded.dendrogram;
  loaded.buildings = json.at("buildings").get<std::vector<std::string>>();
  d.leafCount = static_cast<std::uint32_t>(loaded.buildings.size());
  (void)setValues(d.options, {{"linkage", json.at("linkage").get<std::string>()},
                              {"distance", json.at("distance").get<std::string>()},
                              {"neighbours", json.at("neighbours").get<std::int64_t>()}});
  for (const Json& entry : json.at("merges")) {
    d.merges.push_back({entry.at("a").get<NodeId>(), entry.at("b").get<NodeId>(),
                        numberFrom(entry.at("distance")), numberFrom(entry.at("weight")),
                        numberFrom(entry.at("cost")), entry.at("size").get<std::uint32_t>()});
  }
  return loaded;
}

/// Every node but the last is the child of exactly one later node.
bool isTree(const Dendrogram& d) {
  std::vector<bool> used(d.nodeCount(), false);
  NodeId node = d.leafCount;
  for (const Merge& merge : d.merges) {
    for (const NodeId child : {merge.a, merge.b}) {
      if (child >= node || used[child]) return false;
      used[child] = true;
    }
    ++node;
  }
  return d.merges.size() + 1 == d.leafCount || d.leafCount == 0;
}

}  // namespace

void writeDendrogram(const Dendrogram& d, const std::vector<std::string>& buildingIds,
                     const std::filesystem::path& path) {
  AtomicFile file(path);
  std::ostream& out = file.stream();
  out << fmt::format(
      "{{\"type\": \"dendrogram\", \"version\": 1, \"linkage\": \"{}\", \"distance\": \"{}\", "
      "\"neighbours\": {},\n",
      choiceText(d.options, "linkage"), choiceText(d.options, "distance"), d.options.neighbours);
  out << " \"buildings\": [";
  for (std::size_t i = 0; i < buildingIds.size(); ++i)
    out << (i ? ",\n  " : "\n  ") << jsonQuoted(buildingIds[i]);
  out << "],\n \"depth\": " << d.depth << ",\n \"merges\": [";
  for (std::size_t j = 0; j < d.merges.size(); ++j) {
    const Merge& m = d.merges[j];
    out << (j ? ",\n  " : "\n  ")
        << fmt::format(
               "{{\"a\": {}, \"b\": {}, \"distance\": {}, \"weight\": {}, \"cost\": {}, \"size\": {}}}", m.a,
               m.b, number(m.distance), number(m.weight), number(m.cost), m.size);
  }
  out << "]}\n";
  file.commit();
}

Result<LoadedDendrogram> readDendrogram(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return diagnose(Code::FileNotFound, path.string());
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || json.value("type", Json()) != "dendrogram") {
    return diagnose(Code::FileMalformed, path.string() + " is not a dendrogram");
  }
  try {
    LoadedDendrogram loaded = dendrogramFrom(json);
    if (!isTree(loaded.dendrogram))
      return diagnose(Code::FileMalformed, path.string() + ": the merges make no tree");
    loaded.dendrogram.depth = depthOf(loaded.dendrogram);
    return loaded;
  } catch (const nlohmann::json::exception& error) {
    return diagnose(Code::FileMalformed, path.string() + ": " + error.what());
  }
}

void writeCut(const Cut& cut, const std::filesystem::path& path) {
  AtomicFile file(path);
  std::ostream& out = file.stream();
  out << fmt::format("{{\"type\": \"cut\", \"version\": 1, \"epsilon\": {}, \"alpha\": {},\n",
                     cut.options.epsilon, cut.options.alpha);
  out << fmt::format(" \"camera\": {{\"eye\": {}, \"target\": {}, \"fov\": {}, \"size\": [{}, {}]}},\n",
                     point(cut.camera.eye), point(cut.camera.target), cut.camera.fov, cut.camera.width,
                     cut.camera.height);
  out << fmt::format(" \"polygons\": {}, \"triangles\": {},\n \"drawn\": [", cut.faces.polygons,
                     cut.faces.triangles);
  for (std::size_t i = 0; i < cut.drawn.size(); ++i) out << (i ? ",\n  " : "\n  ") << drawnLine(cut.drawn[i]);
  out << "],\n \"culled\": [";
  for (std::size_t i = 0; i < cut.culled.size(); ++i) out << (i ? ", " : "") << cut.culled[i];
  out << "]}\n";
  file.commit();
}

}  // namespace lodestone
