#include "model/io/places/model_places.h"

#include <ogr_spatialref.h>
#include <tbb/parallel_for.h>

#include "model/io/places/georeference.h"

namespace lodestone {
namespace {

Box2 planBounds(const Places& places) {
  Box2 box;
  const auto add = [&](const Vec2& p) {
    if (p.allFinite()) box.add(p);
  };
  forEachVertex(
      places, [&](const Vec3& p) { add(p.head<2>()); }, add);
  return box;
}

}  // namespace

std::vector<Places> placesOf(CityModel& model) {
  std::vector<Places> result;
  result.reserve(model.buildings.size() + model.others.size());
  for (Building& building : model.buildings) result.push_back({&building.object, &building});
  for (CityObject& object : model.others) result.push_back({&object, nullptr});
  return result;
}

std::vector<Box2> boxesOf(const std::vector<Places>& all) {
  std::vector<Box2> boxes(all.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) { boxes[i] = planBounds(all[i]); });
  return boxes;
}

Box2 unionOf(const std::vector<Box2>& boxes, const std::vector<LineLayer>& lines) {
  Box2 all;
  for (const Box2& box : boxes) {
    if (!box.empty()) all.add(box);
  }
  if (!all.empty()) return all;
  for (const LineLayer& layer : lines) {
    for (const auto& line : layer.lines) {
      for (const Vec2& p : line) {
        if (p.allFinite()) all.add(p);
      }
    }
  }
  return all;
}

Transformation transformation(const Crs& from, const Crs& to) {
  const auto source = horizontalReference(from);
  const auto target = horizontalReference(to);
  if (!source || !target) return nullptr;
  return Transformation(OGRCreateCoordinateTransformation(source.get(), target.get()));
}

}  // namespace lodestone
