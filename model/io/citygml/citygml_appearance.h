// CityGML appearances: materials and textures, and which surfaces and rings they belong to.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/city_model.h"
#include "model/io/citygml/citygml_names.h"
#include "model/io/citygml/citygml_pool.h"
#include "model/io/citygml/citygml_reports.h"
#include "model/io/image_path.h"

namespace lodestone::citygml {

/// The model's materials and textures, each once.
class AppearanceTable {
 public:
  /// Images are looked for beside `file` (a virtual path); `allowOutside` lets them lie elsewhere.
  AppearanceTable(const std::string& file, bool allowOutside, Reports& reports);

  [[nodiscard]] std::int32_t material(Material material);
  [[nodiscard]] std::int32_t texture(const std::string& uri, const std::string& wrap,
                                     const std::string& type);
  void moveTo(CityModel& model);

 private:
  [[nodiscard]] Texture located(const std::string& uri);
  ImagePaths images_;
  Reports& reports_;
  std::vector<Material> materials_;
  std::vector<Texture> textures_;
  std::unordered_map<std::string, std::int32_t> materialNumbers_;
  std::unordered_map<std::string, std::int32_t> textureNumbers_;
};

/// What appearances say of surfaces and rings, by the hashes of their ids. Where several themes colour one
/// surface, the first in the document holds.
class AppearanceLinks {
 public:
  void clear();
  [[nodiscard]] bool empty() const { return surfaces_.empty() && rings_.empty(); }
  void setMaterial(std::uint64_t target, std::int32_t material);
  void setTexture(std::uint64_t target, std::int32_t texture);
  /// `matrix` maps (x, y, z, 1) to (s, t, q); texture coordinates are s/q and t/q.
  void setProjection(std::uint64_t target, const std::array<double, 12>& matrix);
  void setCoordinates(std::uint64_t ring, std::int32_t texture, const std::vector<double>& numbers);

  /// Gives the pool's surfaces their materials and textures. Surfaces that have one keep it.
  void apply(GeometryPool& pool, Reports& reports, const std::string& object) const;
  /// True when something is said about these ids.
  [[nodiscard]] bool mentions(const GeometryPool& pool) const;

 private:
  struct OfSurface {
    std::int32_t material = -1;
    std::int32_t texture = -1;
    std::int32_t projection = -1;
  };
  struct OfRing {
    std::int32_t texture = -1;
    std::uint32_t begin = 0;
    std::uint32_t count = 0;
  };
  void applyToSurface(GeometryPool& pool, std::uint32_t surface, const OfSurface& found) const;
  void applyToRing(GeometryPool& pool, PoolRing& ring, const OfRing& found, Reports& reports,
                   const std::string& object) const;
  void project(GeometryPool& pool, const PoolSurface& surface, const std::array<double, 12>& matrix) const;

  std::unordered_map<std::uint64_t, OfSurface> surfaces_;
  std::unordered_map<std::uint64_t, OfRing> rings_;
  std::vector<Vec2f> coordinates_;
  std::vector<std::array<double, 12>> projections_;
};

/// Reads the elements inside one Appearance.
class AppearanceReader {
 public:
  AppearanceReader(AppearanceTable& table, Reports& reports) : table_(table), reports_(reports) {}
  void begin(AppearanceLinks& links) { links_ = &links; }
  void startElement(const Tag& tag, const XmlAttributes& attributes);
  /// \pre matches the start; `text` is the element's own.
  void endElement(std::string_view local, std::string_view text);

 private:
  enum class Data { None, Material, Parameterized, Georeferenced };
  void startData(Data data);
  void endData();
  void endMaterialField(std::string_view local, std::string_view text);
  void endTarget(std::string_view text);
  void endCoordinates(std::string_view text);
  void addExtra(std::string_view name, const std::string& json);
  [[nodiscard]] std::int32_t currentTexture();

  AppearanceTable& table_;
  Reports& reports_;
  AppearanceLinks* links_ = nullptr;
  Data data_ = Data::None;
  Material material_;
  bool front_ = true;
  std::vector<std::uint64_t> targets_;
  std::string uri_, wrap_, type_;
  std::int32_t texture_ = -1;
  std::uint64_t target_ = 0;  ///< of the TexCoordList being read
  std::uint64_t ring_ = 0;
  /// CityGML 3 lists coordinates and rings in turn, in either order.
  std::vector<std::vector<double>> waitingCoordinates_;
  std::vector<std::uint64_t> waitingRings_;
  std::vector<double> numbers_;
};

}  // namespace lodestone::citygml
