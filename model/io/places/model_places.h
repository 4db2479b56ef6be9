// All the places of a model, for the steps of georeference.h that move them.
#pragma once

#include <memory>
#include <vector>

#include "model/city_model.h"

class OGRCoordinateTransformation;

namespace lodestone {

/// Places of one object: vertices of its geometries and of its children's, and of its footprint if it is a
/// building.
struct Places {
  CityObject* object;
  Building* building;  ///< null for others
};

/// Buildings, then the others. The model must outlive them.
[[nodiscard]] std::vector<Places> placesOf(CityModel& model);

/// Calls inSpace(Vec3&) and inPlan(Vec2&).
template <class InSpace, class InPlan>
void forEachVertex(const Places& places, const InSpace& inSpace, const InPlan& inPlan) {
  forEachObject(*places.object, [&](auto& object) {
    for (Geometry& geometry : object.geometries) {
      for (Vec3& vertex : geometry.vertices) inSpace(vertex);
    }
  });
  if (!places.building) return;
  for (Polygon& polygon : places.building->footprint) {
    for (Vec2& vertex : polygon.outer) inPlan(vertex);
    for (Ring& hole : polygon.holes) {
      for (Vec2& vertex : hole) inPlan(vertex);
    }
  }
}

/// By object, in the order of placesOf().
[[nodiscard]] std::vector<Box2> boxesOf(const std::vector<Places>& all);
/// Of the objects; of the lines where there are no objects.
[[nodiscard]] Box2 unionOf(const std::vector<Box2>& boxes, const std::vector<LineLayer>& lines);

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;
/// Between the horizontal parts; null when there is no way, or a system is unknown or local. For one thread.
[[nodiscard]] Transformation transformation(const Crs& from, const Crs& to);

}  // namespace lodestone
