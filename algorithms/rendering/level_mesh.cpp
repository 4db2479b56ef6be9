#include "algorithms/rendering/level_mesh.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "model/level_colours.h"

namespace lodestone {
namespace {

constexpr std::size_t kObjectsATask = 512;
constexpr std::size_t kSurfaceTypes = static_cast<std::size_t>(SurfaceType::Generic) + 1;

std::uint8_t paintOf(DrawRole role, SurfaceType type) {
  return static_cast<std::uint8_t>(static_cast<std::size_t>(role) * kSurfaceTypes +
                                   static_cast<std::size_t>(type));
}

std::vector<std::array<float, 3>> allColours() {
  std::vector<std::array<float, 3>> colours;
  for (DrawRole role : {DrawRole::Cluster, DrawRole::Building, DrawRole::Landmark}) {
    for (std::size_t type = 0; type < kSurfaceTypes; ++type) {
      colours.push_back(surfaceColour(role, static_cast<SurfaceType>(type)));
    }
  }
  return colours;
}

/// The triangles of some consecutive objects, in the level's coordinates.
struct Piece {
  Box3 box;
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint8_t> paint;
  std::vector<std::uint32_t> object;
  std::vector<ObjectStand> stands;

  void add(const LevelObject& source, std::uint32_t index) {
    for (std::size_t g = 0; g < source.geometries.size(); ++g) {
      const Geometry& geometry = source.geometries[g];
      const auto first = static_cast<std::uint32_t>(vertices.size());
      vertices.insert(vertices.end(), geometry.vertices.begin(), geometry.vertices.end());
      for (const Vec3& p : geometry.vertices) box.add(p);
      for (const LevelObject::Triangle& t : source.triangles[g]) {
        const SurfaceType type = geometry.surfaces[t.surface].type;
        if (type == SurfaceType::Ground) continue;
        triangles.push_back({first + t.vertices[0], first + t.vertices[1], first + t.vertices[2]});
        paint.push_back(paintOf(source.role, type));
        object.push_back(index);
      }
    }
    stands.push_back({source.footprint.empty() ? Ring{} : source.footprint.front().outer, source.base});
  }
};

void append(LevelMesh& mesh, Piece& piece) {
  const auto first = static_cast<std::uint32_t>(mesh.soup.vertices.size());
  for (const Vec3& p : piece.vertices) mesh.soup.vertices.push_back((p - mesh.origin).cast<float>());
  for (const auto& t : piece.triangles)
    mesh.soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  mesh.paint.insert(mesh.paint.end(), piece.paint.begin(), piece.paint.end());
  mesh.object.insert(mesh.object.end(), piece.object.begin(), piece.object.end());
  std::move(piece.stands.begin(), piece.stands.end(), std::back_inserter(mesh.stands));
  piece = {};
}

}  // namespace

LevelMesh levelMesh(const LodLevel& level, const Progress& progress) {
  std::vector<Piece> pieces((level.objectCount + kObjectsATask - 1) / kObjectsATask);
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t p) {
    const std::size_t end = std::min(level.objectCount, (p + 1) * kObjectsATask);
    for (std::size_t i = p * kObjectsATask; i < end && !progress.stopRequested(); ++i) {
      pieces[p].add(level.object(i), static_cast<std::uint32_t>(i));
    }
    progress.report(static_cast<double>(p) / static_cast<double>(pieces.size()));
  });
  progress.checkpoint();

  LevelMesh mesh;
  mesh.colours = allColours();
  for (const Piece& piece : pieces) mesh.box.add(piece.box);
  if (!mesh.box.empty()) mesh.origin = mesh.box.center();
  for (Piece& piece : pieces) append(mesh, piece);
  return mesh;
}

}  // namespace lodestone
