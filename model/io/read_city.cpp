#include "model/io/read_city.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <system_error>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "model/io/footprints/footprint_heights.h"
#include "model/io/format.h"
#include "model/io/input_file.h"
#include "model/io/merge_models.h"
#include "model/io/places/far_apart.h"
#include "model/io/places/georeference.h"
#include "model/io/read_archive.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

constexpr double kParsed = 0.8;
constexpr double kMerged = 0.85;

void append(Diagnostics& to, Diagnostics from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

// Readers name the place in the file; with several files the file must be named too.
std::optional<Diagnostic> whyNotReadable(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return diagnose(Code::FileNotFound, path.string());
  if (fs::is_directory(status))
    return diagnose(Code::FileUnreadable, path.string() + " is a folder: name the files in it");
  if (fs::file_size(path, error) == 0 && !error) return diagnose(Code::FileEmpty, path.string());
  return std::nullopt;
}

/// A file that breaks off is read up to there, and how far is said; with nothing read it is none of ours.
Result<CityModel> upToTheBreak(Result<CityModel> result, const fs::path& path) {
  if (!result || !hasErrors(result.diagnostics)) return result;
  if (result->buildings.empty() && result->others.empty())
    return Result<CityModel>::failure(std::move(result.diagnostics));
  result.diagnostics.push_back(diagnose(
      Code::InputReadInPart,
      fmt::format("{} buildings and {} other objects", result->buildings.size(), result->others.size()), {},
      path.string()));
  return result;
}

Result<CityModel> readOne(const fs::path& path, const ImportOptions& options, const Progress& progress) {
  if (auto why = whyNotReadable(path)) return *why;
  if (readHead(path, 1).empty()) return diagnose(Code::FileUnreadable, path.string());
  const Format* format = formatForReading(path);
  if (!format) return diagnose(Code::FormatUnknown, path.string());
  Result<CityModel> result = upToTheBreak(format->read(path, options, progress), path);
  if (!result) return result;
  if (result->sources.empty()) result->sources.push_back({path.string(), std::string(format->id), {}, {}});
  const bool eastNorth = format->id == "footprints";
  const bool settled = result->crs.kind != CrsKind::Unknown;  // the members of an archive had to be
  if (!settled) append(result.diagnostics, settleCrs(*result, options.crs, eastNorth));
  return result;
}

// Nothing may throw in a worker thread.
Result<CityModel> readQuietly(const fs::path& path, const ImportOptions& options, const Progress& progress) {
  try {
    return readOne(path, options, progress);
  } catch (const Cancelled&) {
    return diagnose(Code::Cancelled);
  } catch (const std::system_error& error) {
    return diagnose(Code::FileUnreadable, error.what());
  } catch (const std::bad_alloc&) {
    return diagnose(Code::CountImplausible, "more than fits into memory", {}, path.filename().string());
  } catch (const std::exception& error) {
    return diagnose(Code::Internal, error.what(), {}, path.filename().string());
  }
}

std::vector<Result<CityModel>> readAll(const std::vector<fs::path>& paths, const ImportOptions& options,
                                       const Progress& progress) {
  std::vector<Result<CityModel>> results(paths.size());
  if (paths.size() == 1) {
    results[0] = readQuietly(paths[0], options, progress);
  } else {
    std::atomic<std::size_t> done{0};
    // One file to a task: files differ much in size.
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, paths.size(), 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i != range.end() && !progress.stopRequested(); ++i) {
            // Progress of single files would run against each other on one bar.
            results[i] = readQuietly(paths[i], options, Progress({}, progress.stopToken()));
            progress.report(static_cast<double>(done.fetch_add(1) + 1) / static_cast<double>(paths.size()));
          }
        },
        tbb::simple_partitioner());
  }
  progress.checkpoint();
  return results;
}

// The first input with a known system sets the system of the model.
Crs systemOf(const std::vector<Result<CityModel>>& parts) {
  for (const Result<CityModel>& part : parts) {
    if (part && part->crs.kind != CrsKind::Unknown) return part->crs;
  }
  for (const Result<CityModel>& part : parts) {
    if (part) return part->crs;
  }
  return {};
}

// A file that names no system and whose coordinates are no degrees cannot stand beside geographic ones: taken
// as degrees it would drag the whole model off the earth.
bool isStranger(const CityModel& part, const Crs& system) {
  return system.kind == CrsKind::Geographic && part.crs.kind == CrsKind::Unknown;
}

// Beside inputs in metres one without a system is taken to be in theirs: it may be a layer of the same city,
// or lie in another country.
void sayAssumed(const std::vector<CityModel>& parts, const Crs& system, Diagnostics& diagnostics) {
  if (system.kind == CrsKind::Unknown) return;
  for (const CityModel& part : parts) {
    if (part.crs.kind != CrsKind::Unknown) continue;
    const std::string path = part.sources.front().path;
    std::erase_if(diagnostics,
                  [&](const Diagnostic& d) { return d.code == Code::CrsMissing && d.place == path; });
    diagnostics.push_back(diagnose(Code::CrsAssumed, system.name, {}, path));
  }
}

/// An option for some formats alone that none of the inputs has is a slip, or a wrong idea of the inputs.
void sayUnused(const ImportOptions& options, const std::vector<Source>& sources, Diagnostics& diagnostics) {
  const auto listens = [](const Format& format, const std::string& name) {
    return std::find(format.listensTo.begin(), format.listensTo.end(), name) != format.listensTo.end();
  };
  const OptionValues usual = values(ImportOptions{});
  const OptionValues given = values(options);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string& name = given[i].first;
    const bool forSome = std::any_of(formats().begin(), formats().end(),
                                     [&](const Format& format) { return listens(format, name); });
    const bool heard = std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
      const Format* format = formatById(source.format);
      return format && listens(*format, name);
    });
    if (forSome && !heard && given[i].second != usual[i].second)
      diagnostics.push_back(diagnose(Code::OptionUnused, name + ": " + toText(given[i].second)));
  }
}

}  // namespace

Result<CityModel> readCity(const std::vector<fs::path>& paths, const ImportOptions& options,
                           const Progress& progress) {
  if (paths.empty()) return diagnose(Code::FileNotFound, "no input given");
  if (auto why = whyNoSystem(options.crs)) return *why;
  if (auto why = HeightRule::whyNot(options)) return *why;
  std::vector<Result<CityModel>> results = readAll(paths, options, progress.part(0, kParsed, "read"));
  Diagnostics diagnostics;
  std::vector<CityModel> parts;
  const Crs system = systemOf(results);
  for (std::size_t i = 0; i < results.size(); ++i) {
    namePlace(results[i].diagnostics, paths[i].filename().string());
    append(diagnostics, std::move(results[i].diagnostics));
    if (results[i] && !isStranger(*results[i], system)) {
      parts.push_back(std::move(*results[i]));
      continue;
    }
    if (results[i]) {
      diagnostics.push_back(diagnose(
          Code::CrsTransformFailed, "it names no coordinate system, and beside geographic files it needs one",
          {}, paths[i].string()));
    }
    if (paths.size() > 1) diagnostics.push_back(diagnose(Code::InputLeftOut, {}, {}, paths[i].string()));
  }
  if (parts.empty()) return Result<CityModel>::failure(std::move(diagnostics));

  sayAssumed(parts, system, diagnostics);
  for (CityModel& part : parts) {
    append(diagnostics, reproject(part, system));
    progress.checkpoint();
  }
  CityModel model = mergeModels(std::move(parts));
  model.crs = system;
  append(diagnostics, makeIdsUnique(model));
  progress.part(kMerged, kMerged).report(1);
  append(diagnostics, localise(model, progress.part(kMerged, 1, "georeference")));
  append(diagnostics, sayFarApart(model));
  sayUnused(options, model.sources, diagnostics);
  if (model.buildings.empty() && model.others.empty() && hasErrors(diagnostics))
    return Result<CityModel>::failure(std::move(diagnostics));
  if (model.buildings.empty()) diagnostics.push_back(diagnose(Code::NoBuildings));
  return {std::move(model), std::move(diagnostics)};
}

}  // namespace lodestone
