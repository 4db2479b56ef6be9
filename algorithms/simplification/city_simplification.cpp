#include "algorithms/simplification/city_simplification.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include "algorithms/geometry/components.h"
#include "algorithms/geometry/parallel.h"
#include "algorithms/perception/perceived_model.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/measured_simplification.h"

namespace lodestone {
namespace {

/// Triangles of one source object as surfaces of their own.
Geometry geometryOf(const ComponentMesh& mesh, std::uint32_t object) {
  Geometry geometry;
  geometry.lod = mesh.objects[object].lod;
  for (const Component& component : mesh.components) {
    if (component.object != object) continue;
    const auto first = static_cast<std::uint32_t>(geometry.vertices.size());
    geometry.vertices.insert(geometry.vertices.end(), mesh.vertices.begin() + component.firstVertex,
                             mesh.vertices.begin() + component.endVertex());
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        geometry.ringVertices.push_back(first + mesh.triangles[t][i] - component.firstVertex);
        if (!mesh.textureCoordinates.empty())
          geometry.textureCoordinates.push_back(mesh.textureCoordinates[t][i]);
      }
      geometry.ringStart.push_back(static_cast<std::uint32_t>(geometry.ringVertices.size()));
      geometry.finishSurface(mesh.surfaces[t]);
    }
  }
  return geometry;
}

/// Writes what is left of a group into copies of its buildings; returns those that have nothing left.
std::vector<std::uint32_t> replaceGeometries(const ComponentMesh& mesh, const CityModel& city,
                                             const std::vector<std::uint32_t>& group,
                                             std::vector<Building>& buildings) {
  std::vector<std::uint32_t> gone;
  std::uint32_t next = 0;  // source objects stand in the order of the buildings' exteriors
  for (const std::uint32_t b : group) {
    std::unordered_map<const CityObject*, std::uint32_t> meshObject;
    for (const ExteriorObject& exterior : drawnObjects(city.buildings[b]))
      meshObject.emplace(exterior.object, next++);
    std::vector<const CityObject*> originals;
    forEachObject(city.buildings[b].object, [&](const CityObject& object) { originals.push_back(&object); });
    std::size_t place = 0;
    std::size_t left = 0;
    forEachObject(buildings[b].object, [&](CityObject& object) {
      object.geometries.clear();
      const auto found = meshObject.find(originals[place++]);
      if (found == meshObject.end()) return;
      Geometry geometry = geometryOf(mesh, found->second);
      if (geometry.surfaceCount() == 0) return;
      object.geometries.push_back(std::move(geometry));
      ++left;
    });
    if (left == 0 && !meshObject.empty()) gone.push_back(b);
  }
  return gone;
}

/// Leaves out buildings, ascending: their footprints would be drawn as blocks, as if nothing had been
/// removed.
void leaveOut(std::vector<Building>& buildings, const std::vector<std::uint32_t>& gone) {
  std::size_t place = 0;
  std::erase_if(buildings, [&, next = gone.begin()](const Building&) mutable {
    const bool leaves = next != gone.end() && *next == place;
    if (leaves) ++next;
    ++place;
    return leaves;
  });
}

struct GroupResult {
  SimplifyReport report;
  std::vector<std::uint32_t> gone;
  Diagnostics diagnostics;
};

/// What there is to say where less was done than asked for.
void tellShortfall(const SimplifyOptions& options, const Admission& admission, const ComponentMesh& mesh,
                   const Simplified& simplified, const std::string& building, Diagnostics& diagnostics) {
  const std::uint32_t before = mesh.triangleCount();
  const std::uint32_t after = simplified.mesh.triangleCount();
  if (simplified.heldByCharts > 0)
    diagnostics.push_back(
        diagnose(Code::ChartsInTheWay, fmt::format("{} contractions", simplified.heldByCharts), building));
  const auto isUnseen = [](const Diagnostic& other) { return other.code == Code::ModelNotSeen; };
  if (admission.isEmpty()) {
    if (std::any_of(diagnostics.begin(), diagnostics.end(), isUnseen)) return;  // that says why
    diagnostics.push_back(diagnose(Code::NothingAdmitted, {}, building));
  } else if (fallsShort(options, before, after)) {
    diagnostics.push_back(diagnose(Code::RateNotMet,
                                   fmt::format("{} of {} triangles instead of {}", before - after, before,
                                               std::ceil(options.rate * before - 1e-9)),
                                   building));
  }
}

GroupResult simplifyGroup(TextureCache& textures, const std::vector<std::uint32_t>& group,
                          const SimplifyOptions& options, const PerceiveOptions& perceive,
                          const Progress& silent, std::vector<Building>& buildings) {
  const CityModel& city = textures.city();
  GroupResult result;
  const ComponentMesh mesh = makeComponentMesh(city, group, &result.diagnostics);
  if (mesh.triangles.empty()) return result;
  std::optional<Perception> perception;
  const std::string& name = city.buildings[group.front()].object.id;
  if (needsPerception(options.method)) {
    perception = perceiveModel(textures, mesh, perceive, &result.diagnostics, silent);
    for (Diagnostic& diagnostic : result.diagnostics) {
      if (diagnostic.code == Code::ModelNotSeen) diagnostic.object = name;
    }
  }
  const Classification classes = classify(mesh, options.gap, silent);
  const Measured measured =
      simplifyAndMeasure(mesh, classes, options, silent, perception ? &*perception : nullptr);
  result.report = reportOf(mesh, classes, measured);
  if (perception)
    result.report.stage = stageReportOf(*perception, measured.admission, measured.simplified.mesh);
  tellShortfall(options, measured.admission, mesh, measured.simplified, name, result.diagnostics);
  result.gone = replaceGeometries(measured.simplified.mesh, city, group, buildings);
  return result;
}

void append(SimplifyReport& all, const SimplifyReport& group) {
  for (ContactReport contact : group.contacts) {
    contact.first += all.componentsBefore;
    contact.second += all.componentsBefore;
    all.contacts.push_back(contact);
  }
  all.trianglesBefore += group.trianglesBefore;
  all.trianglesAfter += group.trianglesAfter;
  all.verticesBefore += group.verticesBefore;
  all.verticesAfter += group.verticesAfter;
  all.componentsBefore += group.componentsBefore;
  all.componentsAfter += group.componentsAfter;
  all.boundaryVertices += group.boundaryVertices;
  all.holeVertices += group.holeVertices;
  all.hausdorff = std::max(all.hausdorff, group.hausdorff);
  if (group.stage) all.stage = all.stage ? *all.stage + *group.stage : *group.stage;
  all.trials.resize(std::max(all.trials.size(), group.trials.size()));
  for (std::size_t i = 0; i < group.trials.size(); ++i) {
    AutoTrial& sum = all.trials[i];
    const AutoTrial& trial = group.trials[i];
    sum.a = trial.a;
    sum.widestGap = std::max(sum.widestGap, trial.widestGap);
    sum.hausdorff = std::max(sum.hausdorff, trial.hausdorff);
    sum.separated += trial.separated;
    sum.lost += trial.lost;
    sum.score += trial.score;
    sum.groups += trial.groups;
  }
}

/// A texture that several groups show, and that cannot be read, is one defect.
void addUnlessSaid(Diagnostics& all, Diagnostics&& group) {
  for (Diagnostic& diagnostic : group) {
    const bool said = diagnostic.code == Code::TextureBad &&
                      std::any_of(all.begin(), all.end(), [&](const Diagnostic& other) {
                        return other.code == diagnostic.code && other.place == diagnostic.place;
                      });
    if (!said) all.push_back(std::move(diagnostic));
  }
}

/// The a that most groups are best with; the one given where none was searched for.
double commonA(const SimplifyReport& report, const SimplifyOptions& options) {
  if (report.trials.empty()) return options.a;
  return std::max_element(report.trials.begin(), report.trials.end(),
                          [](const AutoTrial& a, const AutoTrial& b) { return a.groups < b.groups; })
      ->a;
}

}  // namespace

CityModel simplifiedBuildings(const CityModel& city, const std::vector<std::uint32_t>& buildings,
                              const ComponentMesh& mesh) {
  CityModel result;
  result.sources = city.sources;
  result.crs = city.crs;
  result.origin = city.origin;
  result.materials = city.materials;
  result.textures = city.textures;
  std::vector<std::uint32_t> places;
  for (const std::uint32_t b : buildings) {
    places.push_back(static_cast<std::uint32_t>(places.size()));
    result.buildings.push_back(city.buildings[b]);
  }
  const CityModel originals = result;
  leaveOut(result.buildings, replaceGeometries(mesh, originals, places, result.buildings));
  return result;
}

Result<SimplifiedCity> simplifyCity(std::shared_ptr<const CityModel> city, const SimplifyOptions& options,
                                    const Progress& progress, const GroupRate& rateOf,
                                    const PerceiveOptions& perceive, const GroupsKnown& groupsKnown) {
  const auto groups = touchingBuildings(*city, 0.01, progress.part(0, 0.1, "simplify: touching buildings"));
  if (groupsKnown) groupsKnown(groups);
  auto simplified = std::make_shared<CityModel>(*city);
  std::vector<GroupResult> results(groups.size());
  TextureCache textures(*city);
  const Progress silent({}, progress.stopToken());
  forPiecesReported(
      groups.size(), 1, progress.part(0.1, 1, "simplify"), [&](std::size_t first, std::size_t last) {
        for (std::size_t g = first; g < last; ++g) {
          SimplifyOptions own = options;
          if (rateOf) own.rate = rateOf(groups[g]);
          try {
            // Who waits for the rows of a picture begins no other group: their pictures would pile up.
            tbb::this_task_arena::isolate([&] {
              results[g] = simplifyGroup(textures, groups[g], own, perceive, silent, simplified->buildings);
            });
          } catch (const Cancelled&) {  // stays in this thread: said at the checkpoint below
          } catch (const std::exception& error) {
            results[g].diagnostics.push_back(
                diagnose(Code::Internal, error.what(), city->buildings[groups[g].front()].object.id));
          }
        }
      });
  progress.checkpoint();
  SimplifiedCity result;
  Diagnostics diagnostics;
  std::vector<std::uint32_t> gone;
  for (GroupResult& group : results) {
    append(result.report, group.report);
    gone.insert(gone.end(), group.gone.begin(), group.gone.end());
    addUnlessSaid(diagnostics, std::move(group.diagnostics));
  }
  std::sort(gone.begin(), gone.end());
  for (const std::uint32_t b : gone)
    diagnostics.push_back(diagnose(Code::BuildingGone, {}, city->buildings[b].object.id));
  leaveOut(simplified->buildings, gone);
  result.buildingsGone = gone.size();
  result.report.a = commonA(result.report, options);
  result.groups = groups.size();
  result.city = std::move(simplified);
  progress.report(1);
  return {std::move(result), std::move(diagnostics)};
}

}  // namespace lodestone
