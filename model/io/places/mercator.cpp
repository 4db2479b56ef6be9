#include "model/io/places/mercator.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include <cpl_conv.h>
#include <ogr_spatialref.h>

namespace lodestone {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// PROJ's words name all the variants alike, where WKT has a method for each.
std::string projWords(const OGRSpatialReference& srs) {
  char* text = nullptr;
  std::string words;
  if (srs.exportToProj4(&text) == OGRERR_NONE && text) words = std::string(" ") + text + " ";
  CPLFree(text);
  return words;
}

double number(const std::string& words, const char* name, double otherwise) {
  const std::string key = std::string(" +") + name + "=";
  const std::size_t at = words.find(key);
  return at == std::string::npos ? otherwise : std::strtod(words.c_str() + at + key.size(), nullptr);
}

}  // namespace

std::optional<Mercator> Mercator::from(const OGRSpatialReference& srs) {
  if (!srs.IsProjected()) return std::nullopt;
  const std::string words = projWords(srs);
  if (words.find(" +proj=merc ") == std::string::npos) return std::nullopt;
  const double radius = number(words, "a", srs.GetSemiMajor());
  const double inverse = srs.GetInvFlattening();
  const bool sphere = inverse <= 0 || number(words, "b", 0) == radius;
  const double flattening = sphere ? 0 : 1 / inverse;
  double scale = number(words, "k", number(words, "k_0", 1));
  if (const double parallel = number(words, "lat_ts", 0) * kDegree; parallel != 0) {
    const double eccentric = std::sqrt(flattening * (2 - flattening)) * std::sin(parallel);
    scale = std::cos(parallel) / std::sqrt(1 - eccentric * eccentric);
  }
  if (!(radius > 0) || !(scale > 0)) return std::nullopt;
  return Mercator(GeographicLib::Ellipsoid(radius, flattening), scale * radius * kDegree,
                  {number(words, "x_0", 0), number(words, "y_0", 0)});
}

Vec2 Mercator::toDegrees(const Vec2& metres) const {
  const Vec2 isometric = (metres - falseOrigin_) / metresPerDegree_;
  return {isometric.x(), ellipsoid_.InverseIsometricLatitude(isometric.y())};
}

Vec2 Mercator::toMetres(const Vec2& degrees) const {
  const Vec2 isometric(degrees.x(), ellipsoid_.IsometricLatitude(degrees.y()));
  return isometric * metresPerDegree_ + falseOrigin_;
}

}  // namespace lodestone
