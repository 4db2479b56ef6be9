// Whatever the bytes, the CityJSON reader must neither crash nor make a model whose indices lead nowhere.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "model/io/cityjson/cityjson_reader.h"

namespace {

using namespace lodestone;

void require(bool condition) {
  if (!condition) std::abort();
}

bool rises(const std::vector<std::uint32_t>& starts, std::size_t last) {
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    if (starts[i] >= starts[i + 1]) return false;
  }
  return starts.empty() || (starts.front() == 0 && starts.back() == last);
}

void checkGeometry(const CityModel& city, const Geometry& geometry) {
  require(!geometry.surfaces.empty());
  require(rises(geometry.ringStart, geometry.ringVertices.size()));
  require(rises(geometry.surfaceStart, geometry.ringCount()));
  require(geometry.surfaceStart.size() == geometry.surfaceCount() + 1);
  require(rises(geometry.shellStart, geometry.surfaceCount()));
  require(rises(geometry.solidStart, geometry.shellStart.empty() ? 0 : geometry.shellStart.size() - 1));
  require(geometry.isSolid() == !geometry.solidStart.empty());
  for (const std::uint32_t vertex : geometry.ringVertices) require(vertex < geometry.vertices.size());
  for (const Vec3& vertex : geometry.vertices) require(vertex.allFinite());
  const std::size_t coordinates = geometry.textureCoordinates.size();
  require(coordinates == 0 || coordinates == geometry.ringVertices.size());
  for (const SurfaceInfo& surface : geometry.surfaces) {
    require(surface.material < static_cast<std::int32_t>(city.materials.size()));
    require(surface.texture < static_cast<std::int32_t>(city.textures.size()));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto city =
      parseCityJson(std::string(reinterpret_cast<const char*>(data), size), "fuzz.city.json", "cityjson");
  require(city || !city.diagnostics.empty());
  if (!city) return 0;
  forEachObjectOf(*city, [&](const CityObject& object) {
    for (const Geometry& geometry : object.geometries) checkGeometry(*city, geometry);
  });
  return 0;
}
