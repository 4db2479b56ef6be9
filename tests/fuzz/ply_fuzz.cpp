// Whatever the bytes, the PLY reader ends, and what it gives fits together.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "model/io/meshes/ply.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const lodestone::PlyMesh mesh = lodestone::parsePly({reinterpret_cast<const char*>(data), size});
    require(mesh.vertices.size() <= size && mesh.corners.size() <= size);
    require(mesh.vertexCoordinates.empty() || mesh.vertexCoordinates.size() == mesh.vertices.size());
    require(mesh.cornerCoordinates.empty() || mesh.cornerCoordinates.size() == mesh.corners.size());
    require(mesh.faceStart.front() == 0 && mesh.faceStart.back() == mesh.corners.size());
  } catch (const std::runtime_error&) {
  } catch (const std::length_error&) {
  }
  return 0;
}
