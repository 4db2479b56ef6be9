// GML geometry elements, as they come, into the pool.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/io/citygml/citygml_names.h"
#include "model/io/citygml/citygml_pool.h"
#include "model/io/citygml/citygml_reports.h"

namespace lodestone::citygml {

/// Reads a subtree that starts with a GML geometry. The owner sends it every start and end until depth() is 0
/// again.
class GeometryReader {
 public:
  /// `object` names the city object being read, for diagnostics.
  GeometryReader(GeometryPool& pool, Reports& reports, std::function<std::string()> object)
      : pool_(pool), reports_(reports), object_(std::move(object)) {}

  /// Type of the surfaces that follow.
  void setSurfaceType(SurfaceType type) { type_ = type; }
  [[nodiscard]] SurfaceType surfaceType() const { return type_; }
  /// Dimension of coordinates where nothing nearer tells: 2 or 3.
  void setDimension(int dimension) { dimension_ = dimension; }

  [[nodiscard]] static bool isGeometry(Kind kind) {
    return kind == Kind::Aggregate || kind == Kind::Solid || kind == Kind::Polygon;
  }
  /// Returns true when the element's text is wanted.
  bool startElement(const Tag& tag, const XmlAttributes& attributes);
  void endElement(std::string_view text);
  [[nodiscard]] std::size_t depth() const { return steps_.size(); }
  /// A link in place of a geometry; refused when it leads out of the file.
  void addLink(std::string_view reference);
  /// The first srsName seen in any geometry.
  [[nodiscard]] const std::string& srsName() const { return srsName_; }

 private:
  enum class Place : std::uint8_t {
    Aggregate,
    Member,
    Solid,
    Polygon,
    Boundary,
    Ring,
    InRing,
    Numbers,
    Skipped
  };
  struct Step {
    Place place = Place::Skipped;
    Kind kind = Kind::Unknown;
    bool interior = false;
    bool flip = false;
    std::int8_t dimension = 0;  ///< to return to
    std::uint32_t item = 0;     ///< first item, target and ring of it
    std::uint32_t target = 0;
    std::uint64_t id = 0;
  };

  void startGeometry(Step& step, const Tag& tag, const XmlAttributes& attributes);
  void readDimension(const XmlAttributes& attributes);
  void startRing(const XmlAttributes& attributes);
  void endPolygon(const Step& step);
  void endRing(const Step& boundary);
  void endNumbers(Kind kind, std::string_view text);
  void addPoints(int dimension);
  [[nodiscard]] bool hasThreePoints(const PoolRing& ring) const;
  void spoil(Code code, const std::string& text);
  void noteUnsupported(const Tag& tag);

  GeometryPool& pool_;
  Reports& reports_;
  std::function<std::string()> object_;
  std::vector<Step> steps_;
  std::vector<double> numbers_;
  std::string srsName_;
  SurfaceType type_ = SurfaceType::Unknown;
  int dimension_ = 0;     ///< 0: nothing says
  bool spoiled_ = false;  ///< the surface being read cannot be kept
};

}  // namespace lodestone::citygml
