// Fuzz target of the CityGML reader: any bytes give a model whose indices hold, or a diagnostic.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <cpl_vsi.h>

#include "model/io/citygml/citygml.h"

namespace {

using lodestone::Geometry;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

template <class Starts>
void requireStarts(const Starts& starts, std::size_t last, const char* what) {
  require(!starts.empty() && starts.front() == 0 && starts.back() == last, what);
  for (std::size_t i = 1; i < starts.size(); ++i) require(starts[i - 1] <= starts[i], what);
}

void requireWhole(const Geometry& g, std::size_t materials, std::size_t textures) {
  requireStarts(g.ringStart, g.ringVertices.size(), "ringStart");
  requireStarts(g.surfaceStart, g.ringCount(), "surfaceStart");
  require(g.surfaceStart.size() == g.surfaceCount() + 1, "surfaces");
  for (const std::uint32_t v : g.ringVertices) require(v < g.vertices.size(), "ringVertices");
  for (const auto& p : g.vertices) require(p.allFinite(), "vertices");
  for (const auto& surface : g.surfaces) {
    require(surface.material < static_cast<std::int64_t>(materials), "material");
    require(surface.texture < static_cast<std::int64_t>(textures), "texture");
  }
  require(g.textureCoordinates.empty() || g.textureCoordinates.size() == g.ringVertices.size(),
          "textureCoordinates");
  require(g.isSolid() != g.shellStart.empty(), "shells");
  if (!g.isSolid()) return;
  requireStarts(g.shellStart, g.surfaceCount(), "shellStart");
  requireStarts(g.solidStart, g.shellStart.size() - 1, "solidStart");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char* name = "/vsimem/fuzz.gml";
  VSIFCloseL(VSIFileFromMemBuffer(name, const_cast<GByte*>(data), size, FALSE));
  const auto result = lodestone::cityGmlFormat().read(name, {}, {});
  VSIUnlink(name);
  require(result.ok() || lodestone::hasErrors(result.diagnostics), "a failure without an error");
  if (!result) return 0;
  lodestone::forEachObjectOf(*result, [&](const lodestone::CityObject& object) {
    require(!object.id.empty(), "id");
    for (const Geometry& g : object.geometries)
      requireWhole(g, result->materials.size(), result->textures.size());
  });
  return 0;
}
