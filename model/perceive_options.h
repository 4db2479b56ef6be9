// Options of perception analysis (Du, Zhu and Zhao; resources/docs/methods.md, section 5).
#pragma once

#include "model/options.h"

namespace lodestone {

/// Where a model is looked at from.
enum class ViewpointSet {
  Sphere,  ///< from all directions, from below too
  Upper,   ///< from the directions above the horizon
  Street,  ///< from a person's height, all around
};

struct PerceiveOptions {
  ViewpointSet viewpoints = ViewpointSet::Sphere;
  int views = 26;
  int size = 1024;  ///< pixels of each side of a picture
  // The display that somebody looks at, and from how far: they give the pixels per degree.
  double screenWidth = 0.53;    ///< metres
  int screenResolution = 1920;  ///< pixels across
  double distance = 0.6;        ///< metres
  double csf = 0.114;           ///< c of the contrast sensitivity function
  // Least difference of each class, grey levels of 0–255; 0: found by maximum likelihood.
  double slight = 0;
  double moderate = 0;
  double dramatic = 0;
  bool operator==(const PerceiveOptions&) const = default;

  [[nodiscard]] double pixelsPerDegree() const;
};

template <>
const std::vector<Field<PerceiveOptions>>& fields<PerceiveOptions>();

}  // namespace lodestone
