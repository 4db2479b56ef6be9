#include "model/io/classification_json.h"

#include <fmt/format.h>

#include "model/io/atomic_file.h"
#include "model/io/json_writing.h"

namespace lodestone {
namespace {

struct Counts {
  std::uint32_t boundary = 0;
  std::uint32_t hole = 0;
};

Counts countsOf(const Classification& classes, const Component& component) {
  Counts counts;
  for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v) {
    counts.boundary += classes.vertices[v] == VertexClass::Boundary ? 1 : 0;
    counts.hole += classes.vertices[v] == VertexClass::Hole ? 1 : 0;
  }
  return counts;
}

std::string componentLine(const ComponentMesh& mesh, const Classification& classes, std::size_t c) {
  const Component& component = mesh.components[c];
  const Counts counts = countsOf(classes, component);
  return fmt::format(
      "{{\"id\": {}, \"source\": {}, \"vertices\": {}, \"triangles\": {}, \"boundary\": {}, \"hole\": {}}}",
      c, jsonQuoted(mesh.objects[component.object].id), component.vertexCount, component.triangleCount,
      counts.boundary, counts.hole);
}

std::string vertexLine(const ComponentMesh& mesh, const Classification& classes, const Vec3& p,
                       std::uint32_t v) {
  return fmt::format("{{\"component\": {}, \"position\": [{}, {}, {}], \"class\": \"{}\", \"planes\": {}}}",
                     componentOfVertex(mesh, v), p.x(), p.y(), p.z(), toString(classes.vertices[v]),
                     classes.planeCount(v));
}

std::string insideOf(const BoundaryEdge& edge) {
  if (edge.fromInside && edge.toInside) return "[\"from\", \"to\"]";
  return edge.fromInside ? "[\"from\"]" : edge.toInside ? "[\"to\"]" : "[]";
}

std::string edgeLine(const ComponentMesh& mesh, const Classification& classes, const BoundaryEdge& edge) {
  return fmt::format(
      "{{\"from\": {}, \"to\": {}, \"inside\": {}, {}\"rule\": \"{}\", \"other\": {}, \"triangles\": [{}], "
      "\"angle\": {{\"from_to\": {:.6g}, \"to_from\": {:.6g}}}}}",
      edge.from, edge.to, insideOf(edge), edge.passesThrough ? "\"passes_through\": true, " : "",
      toString(edge.rule), edge.other, fmt::join(edge.triangles, ", "),
      edgeComponentAngle(mesh, classes, edge.from, edge.to),
      edgeComponentAngle(mesh, classes, edge.to, edge.from));
}

}  // namespace

void writeClassification(const ComponentMesh& mesh, const Classification& classes,
                         std::span<const Vec3> positions, const std::filesystem::path& path) {
  AtomicFile file(path);
  std::ostream& out = file.stream();
  out << fmt::format("{{\"type\": \"classification\", \"version\": 1, \"gap\": {},\n \"components\": [",
                     classes.gap);
  for (std::size_t c = 0; c < mesh.components.size(); ++c)
    out << (c ? ",\n  " : "\n  ") << componentLine(mesh, classes, c);
  out << "],\n \"vertices\": [";
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v)
    out << (v ? ",\n  " : "\n  ") << vertexLine(mesh, classes, positions[v], v);
  out << "],\n \"edges\": [";
  for (std::size_t e = 0; e < classes.edges.size(); ++e)
    out << (e ? ",\n  " : "\n  ") << edgeLine(mesh, classes, classes.edges[e]);
  out << "]}\n";
  file.commit();
}

}  // namespace lodestone
