#include "model/io/footprints/footprint_finish.h"

#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "model/io/footprints/footprint_repair.h"

namespace lodestone {
namespace {

constexpr std::size_t kSaidOneByOne = 100;
constexpr double kLowestBuilding = 2;  // metres

/// What is to be said of each object: the first hundred of a code one by one, after how many there are.
class ObjectNotes {
 public:
  void add(Code code, const std::string& id, const std::string& detail = {}) {
    Notes& notes = notes_[code];
    if (++notes.count <= kSaidOneByOne) notes.first.push_back(diagnose(code, detail, id));
  }
  void moveTo(Diagnostics& diagnostics) {
    for (auto& [code, notes] : notes_) {
      if (notes.count > kSaidOneByOne) {
        diagnostics.push_back(
            diagnose(code, fmt::format("{} objects, here the first {}", notes.count, kSaidOneByOne)));
      }
      diagnostics.insert(diagnostics.end(), std::make_move_iterator(notes.first.begin()),
                         std::make_move_iterator(notes.first.end()));
    }
  }

 private:
  struct Notes {
    Diagnostics first;
    std::size_t count = 0;
  };
  std::map<Code, Notes> notes_;
};

/// What one building came to.
struct Outcome {
  std::vector<Code> codes;
  bool keep = true;
  bool notPositive = false;
  std::string heightNotUnderstood;
};

void assignHeight(Building& building, const Vec2& zRange, const HeightRule& rule, Outcome& outcome) {
  if (std::isfinite(zRange.x())) building.base = zRange.x();
  HeightRule::Found found = rule.find(building.object.attributes);
  building.height = found.height;
  building.heightSource = found.source;
  outcome.notPositive = found.notPositive;
  outcome.heightNotUnderstood = std::move(found.notUnderstood);
  const double range = zRange.y() - zRange.x();
  if (found.source == HeightSource::Default && std::isfinite(range) && range >= kLowestBuilding) {
    building.height = range;
    building.heightSource = HeightSource::Geometry;
  }
}

Outcome finishOne(Building& building, const Vec2& zRange, const HeightRule& rule) {
  Outcome outcome;
  // A body's footprint and height come from its surfaces, as those of any 3D model.
  if (!building.object.geometries.empty()) return outcome;
  RepairedFootprint repaired = repairFootprint(std::move(building.footprint));
  building.footprint = std::move(repaired.polygons);
  outcome.codes = std::move(repaired.codes);
  outcome.keep = !building.footprint.empty();
  assignHeight(building, zRange, rule, outcome);
  return outcome;
}

}  // namespace

std::vector<Building> finishFootprints(LayerFeatures features, const ImportOptions& options,
                                       Diagnostics& diagnostics, const Progress& progress) {
  const HeightRule rule(options);
  std::vector<Building>& buildings = features.buildings;
  std::vector<Outcome> outcomes(buildings.size());
  tbb::parallel_for(std::size_t{0}, buildings.size(), [&](std::size_t i) {
    if (!progress.stopRequested()) outcomes[i] = finishOne(buildings[i], features.zRange[i], rule);
  });
  progress.checkpoint();

  ObjectNotes notes;
  std::vector<Building> kept;
  kept.reserve(buildings.size());
  std::size_t withoutHeight = 0;
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    Building& building = buildings[i];
    for (const Code code : outcomes[i].codes) notes.add(code, building.object.id);
    if (!outcomes[i].keep) {
      notes.add(Code::FootprintInvalid, building.object.id);
      continue;
    }
    if (outcomes[i].notPositive) notes.add(Code::HeightNotPositive, building.object.id);
    const std::string& text = outcomes[i].heightNotUnderstood;
    if (!text.empty()) notes.add(Code::HeightNotUnderstood, building.object.id, text);
    const bool said = outcomes[i].notPositive || !text.empty();
    if (building.heightSource == HeightSource::Default && !said) ++withoutHeight;
    kept.push_back(std::move(building));
  }
  notes.moveTo(diagnostics);
  if (withoutHeight > 0) {
    diagnostics.push_back(
        diagnose(Code::HeightMissing, fmt::format("{} of {} buildings", withoutHeight, kept.size())));
  }
  return kept;
}

}  // namespace lodestone
