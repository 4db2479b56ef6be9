#include "model/io/read_archive.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "model/io/input_file.h"
#include "model/io/merge_models.h"
#include "model/io/places/georeference.h"

namespace lodestone {
namespace {

void append(Diagnostics& to, Diagnostics from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// "tiles.zip!udx/a.gml" for "/vsizip/{/data/tiles.zip}/udx/a.gml".
std::string nameOf(const std::filesystem::path& archive, const std::string& member) {
  const std::size_t end = member.rfind("}/");
  return archive.filename().string() + "!" + (end == std::string::npos ? member : member.substr(end + 2));
}

/// Whether coordinates in the two mean the same as they stand. Spellings of one geographic system may differ
/// in the order of their axes.
bool isSameSystem(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const Crs first = resolveCrs(a);
  const Crs second = resolveCrs(b);
  return first.kind == CrsKind::Projected && second.kind == CrsKind::Projected && first.epsg != 0 &&
         first.epsg == second.epsg && first.verticalEpsg == second.verticalEpsg;
}

/// Brings all members into the system of the first that names one.
void intoOneSystem(std::vector<CityModel>& parts, bool eastNorth, Diagnostics& diagnostics) {
  const auto named = [](const CityModel& part) { return !part.crs.source.empty(); };
  const auto first = std::find_if(parts.begin(), parts.end(), named);
  if (first == parts.end()) return;
  const std::string system = first->crs.source;
  const bool mixed = std::any_of(parts.begin(), parts.end(), [&](const CityModel& part) {
    return named(part) && !isSameSystem(part.crs.source, system);
  });
  for (CityModel& part : parts) {
    const std::string& place = part.sources.front().path;
    if (!named(part)) {
      diagnostics.push_back(diagnose(Code::CrsAssumed, system, {}, place));
      part.crs.source = system;
    }
    if (mixed) append(diagnostics, settleCrs(part, {}, eastNorth));
  }
  if (!mixed) return;
  const Crs target = first->crs;
  for (CityModel& part : parts) append(diagnostics, reproject(part, target));
}

}  // namespace

void namePlace(Diagnostics& diagnostics, const std::string& place) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.place.empty()) diagnostic.place = place;
  }
}

Result<CityModel> readArchive(const std::filesystem::path& path, const ImportOptions& options,
                              const MemberReading& reading, const Progress& progress) {
  Result<std::vector<std::string>> members = archiveMembers(path);
  if (!members) return Result<CityModel>::failure(std::move(members.diagnostics));
  Diagnostics diagnostics = std::move(members.diagnostics);
  const auto ours = std::stable_partition(members->begin(), members->end(), reading.isOurs);
  for (auto other = ours; other != members->end(); ++other)
    diagnostics.push_back(diagnose(Code::MemberSkipped, {}, {}, nameOf(path, *other)));
  members->erase(ours, members->end());

  std::vector<CityModel> parts;
  const auto count = static_cast<double>(members->size());
  for (std::size_t i = 0; i < members->size(); ++i) {
    const auto begin = static_cast<double>(i) / count;
    const std::string name = nameOf(path, (*members)[i]);
    Result<CityModel> part =
        reading.read((*members)[i], name, members->size(), progress.part(begin, begin + 1 / count));
    namePlace(part.diagnostics, name);
    append(diagnostics, std::move(part.diagnostics));
    if (!part) continue;
    part->sources.front().path = name;
    parts.push_back(std::move(*part));
  }
  if (parts.empty()) {
    if (!hasErrors(diagnostics))
      diagnostics.push_back(diagnose(Code::ArchiveEmpty, {}, {}, path.filename().string()));
    return Result<CityModel>::failure(std::move(diagnostics));
  }
  if (options.crs.empty()) intoOneSystem(parts, reading.eastNorth, diagnostics);
  const auto known = std::find_if(parts.begin(), parts.end(),
                                  [](const CityModel& part) { return !part.crs.source.empty(); });
  const Crs system = known == parts.end() ? parts.front().crs : known->crs;
  CityModel model = mergeModels(std::move(parts));
  model.crs = system;
  model.sources.resize(1);
  model.sources.front().path = path.string();
  for (Building& building : model.buildings) building.source = 0;
  return {std::move(model), std::move(diagnostics)};
}

}  // namespace lodestone
