#include <algorithm>

#include <fmt/format.h>

#include "cli/city_input.h"
#include "cli/commands.h"
#include "model/city_summary.h"
#include "model/io/footprints/footprint_layers.h"
#include "model/io/footprints/footprints.h"
#include "model/io/format.h"
#include "model/io/places/georeference.h"

namespace lodestone::cli {
namespace {

using Json = nlohmann::ordered_json;

void printFormats() {
  for (const Format& format : formats()) {
    fmt::print("{:<12} {:<5} {:<6} {}  ({})\n", format.id, format.read ? "read" : "",
               format.write ? "write" : "", format.title, fmt::join(format.extensions, " "));
  }
}

Json pointJson(const Vec3& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

template <class Count>
Json countsJson(const std::map<std::string, Count>& counts) {
  Json json = Json::object();
  for (const auto& [name, count] : counts) json[name] = count;
  return json;
}

/// In the units of the input.
Box3 inWorld(const CityModel& city, const Box3& local) {
  Box3 world;
  if (local.empty()) return world;
  const Frame frame(city);
  for (const double x : {local.min.x(), local.max.x()}) {
    for (const double y : {local.min.y(), local.max.y()}) {
      world.add(frame.toWorld(Vec3(x, y, local.min.z())));
      world.add(frame.toWorld(Vec3(x, y, local.max.z())));
    }
  }
  return world;
}

Json summaryJson(const CityModel& city, const CitySummary& summary) {
  Json sources = Json::array();
  for (const Source& source : city.sources) {
    sources.push_back({{"path", source.path},
                       {"format", source.format},
                       {"version", source.version},
                       {"title", source.title}});
  }
  const bool geographic = city.crs.kind == CrsKind::Geographic;
  const Box3 box = geographic ? summary.extent : inWorld(city, summary.extent);
  Json json = {{"sources", sources},
               {"crs",
                {{"source", city.crs.source},
                 {"name", city.crs.name},
                 {"epsg", city.crs.epsg},
                 {"local", city.crs.kind == CrsKind::Local}}},
               {geographic ? "centre" : "origin", pointJson(toWorld(city, Vec3(0, 0, 0)))},
               {"buildings", summary.buildings},
               {"building_parts", summary.parts},
               {"with_footprint", summary.withFootprint},
               {"ground_vertices", summary.groundVertices},
               {"objects", countsJson(summary.objects)},
               {"lods", countsJson(summary.lods)},
               {"heights", countsJson(summary.heights)},
               {"surfaces", summary.surfaces},
               {"triangles", summary.triangles},
               {"components", summary.components},
               {"textures",
                {{"images", summary.textures},
                 {"missing", summary.texturesMissing},
                 {"surfaces", summary.texturedSurfaces}}},
               {"materials", summary.materials},
               {"attributes", countsJson(summary.attributes)}};
  if (!box.empty()) json["extent"] = {{"min", pointJson(box.min)}, {"max", pointJson(box.max)}};
  return json;
}

/// Layers of the sources that have any.
Json layersJson(const CityModel& city, const std::string& wanted, const Progress& progress) {
  Json list = Json::array();
  for (const Source& source : city.sources) {
    if (source.format != footprintFormat().id) continue;
    for (const LayerEntry& layer : listLayers(source.path, wanted, progress)) {
      list.push_back({{"source", source.path},
                      {"name", layer.name},
                      {"geometry", layer.geometry},
                      {"features", layer.features},
                      {"read", layer.read}});
    }
  }
  return list;
}

std::string inOneLine(const Json& counts) {
  std::string line;
  for (const auto& [name, count] : counts.items()) {
    line += fmt::format("{}{} ({})", line.empty() ? "" : ", ", name.empty() ? "unnamed" : name, count.dump());
  }
  return line.empty() ? "none" : line;
}

/// The commonest first, and how many more: files from OSM have hundreds of attributes.
std::string commonestInOneLine(const Json& counts) {
  constexpr std::size_t kShown = 20;
  std::vector<std::pair<std::string, std::size_t>> ranked;
  for (const auto& [name, count] : counts.items()) ranked.emplace_back(name, count.get<std::size_t>());
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  Json shown = Json::object();
  for (std::size_t i = 0; i < std::min(kShown, ranked.size()); ++i) shown[ranked[i].first] = ranked[i].second;
  const std::string line = inOneLine(shown);
  return ranked.size() <= kShown
             ? line
             : fmt::format("{} and {} more (--json lists all)", line, ranked.size() - kShown);
}

std::string pointText(const Json& p) {
  return fmt::format("{:.3f} {:.3f} {:.3f}", p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
}

/// A line a layer, the first of them: archives of tiles have hundreds.
void printLayers(const Json& layers) {
  constexpr std::size_t kShown = 12;
  for (std::size_t i = 0; i < std::min(kShown, layers.size()); ++i) {
    const Json& layer = layers[i];
    fmt::print("  {:<16} {}: {}, {} features{}\n", i == 0 ? "layers" : "", layer["name"].get<std::string>(),
               layer["geometry"].get<std::string>(), layer["features"].dump(),
               layer["read"].get<bool>() ? " (read)" : "");
  }
  if (layers.size() > kShown)
    fmt::print("  {:<16} and {} more (--json lists all)\n", "", layers.size() - kShown);
}

std::string systemText(const Json& crs) {
  const std::string name = crs["name"].get<std::string>();
  const int epsg = crs["epsg"].get<int>();
  if (name.empty()) return "none given: metres";
  if (crs["local"].get<bool>()) return "its own: metres (" + name + ")";
  return epsg == 0 ? name : fmt::format("{} (EPSG:{})", name, epsg);
}

void printSummary(const Json& json) {
  for (const Json& source : json["sources"]) {
    fmt::print("{}: {} {}\n", source["path"].get<std::string>(), source["format"].get<std::string>(),
               source["version"].get<std::string>());
  }
  const auto row = [](const char* name, const std::string& text) { fmt::print("  {:<16} {}\n", name, text); };
  if (json.contains("layers")) printLayers(json["layers"]);
  row("CRS", systemText(json["crs"]));
  if (json.contains("centre")) {
    const Json& c = json["centre"];
    row("centre",
        fmt::format("{:.7f} {:.7f} {:.3f} (longitude, latitude, height); cameras are in metres from it",
                    c[0].get<double>(), c[1].get<double>(), c[2].get<double>()));
  }
  if (json.contains("extent")) {
    row("extent", pointText(json["extent"]["min"]) + " to " + pointText(json["extent"]["max"]) +
                      (json.contains("centre") ? " (metres from the centre)" : ""));
  }
  row("buildings", fmt::format("{} with {} parts; {} have a footprint, {} ground vertices",
                               json["buildings"].dump(), json["building_parts"].dump(),
                               json["with_footprint"].dump(), json["ground_vertices"].dump()));
  row("heights from", inOneLine(json["heights"]));
  row("objects", inOneLine(json["objects"]));
  row("LODs", inOneLine(json["lods"]));
  row("geometry", fmt::format("{} surfaces, {} triangles, {} components", json["surfaces"].dump(),
                              json["triangles"].dump(), json["components"].dump()));
  row("textures", fmt::format("{} images, {} missing, {} surfaces textured; {} materials",
                              json["textures"]["images"].dump(), json["textures"]["missing"].dump(),
                              json["textures"]["surfaces"].dump(), json["materials"].dump()));
  row("attributes", commonestInOneLine(json["attributes"]));
}

}  // namespace

void addInfo(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    CityInput city;
    bool json = false;
    bool formats = false;
  };
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("info", "What a file holds, and what is wrong with it");
  args->city.addTo(*command);
  command->get_option("INPUT")->required(false);
  command->add_flag("--json", args->json, "As JSON");
  command->add_flag("--formats", args->formats, "List the formats that can be read and written");
  command->callback([args, &chosen] {
    if (args->city.paths.empty() && !args->formats) throw CLI::RequiredError("INPUT");
    chosen = {"info", [args](Run& run) {
                if (args->formats) return printFormats();
                const auto city = args->city.load(run);
                Json json = summaryJson(*city, summarise(*city));
                Json layers = run.stage("layers", [&](const Progress& progress) {
                  return layersJson(*city, args->city.options.layer, progress);
                });
                if (!layers.empty()) json["layers"] = std::move(layers);
                run.figures = json;
                if (args->json) {
                  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
                } else {
                  printSummary(json);
                }
              }};
  });
}

}  // namespace lodestone::cli
