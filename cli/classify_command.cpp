#include <algorithm>

#include <fmt/format.h>

#include "algorithms/simplification/city_classification.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "model/io/classification_json.h"
#include "model/io/places/georeference.h"

namespace lodestone::cli {
namespace {

struct Arguments {
  CityInput city;
  double gap = 0.01;
  std::string output;
};

void work(const Arguments& args, Run& run) {
  const auto city = args.city.load(run);
  const ClassifiedCity classified = run.take(run.stage(
      "classify", [&](const Progress& progress) { return classifyCity(*city, args.gap, progress); }));
  const auto& [mesh, classes] = classified;
  std::vector<Vec3> positions = mesh.vertices;
  if (city->crs.kind != CrsKind::Geographic)
    toWorld(*city, positions);  // there metres from the centre, as cameras
  writeClassification(mesh, classes, positions, args.output);
  const auto count = [&](VertexClass wanted) {
    return std::count(classes.vertices.begin(), classes.vertices.end(), wanted);
  };
  run.figures["components"] = mesh.components.size();
  run.figures["triangles"] = mesh.triangleCount();
  run.figures["vertices"] = mesh.vertexCount();
  run.figures["boundary_vertices"] = count(VertexClass::Boundary);
  run.figures["hole_vertices"] = count(VertexClass::Hole);
  run.figures["boundary_edges"] = classes.edges.size();
  run.figures["contacts"] = classes.contacts.size();
  run.output["files"] = {args.output};
  if (run.options().quiet) return;
  fmt::print(
      "components  {}, {} contacts\ntriangles   {}\nvertices    {}: {} boundary, {} hole, {} ordinary\n",
      mesh.components.size(), classes.contacts.size(), mesh.triangleCount(), mesh.vertexCount(),
      count(VertexClass::Boundary), count(VertexClass::Hole), count(VertexClass::Ordinary));
}

}  // namespace

void addClassify(CLI::App& app, Chosen& chosen) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("classify", "Components and vertex classes of a model of many parts");
  args->city.addTo(*command);
  command
      ->add_option("--gap", args->gap,
                   "Share of its length by which each end of an edge is lengthened (default 0.01)")
      ->check(CLI::Range(0.0, 0.2));
  command->add_option("-o,--output", args->output, "Classification, JSON")->required();
  command->callback([args, &chosen] { chosen = {"classify", [args](Run& run) { work(*args, run); }}; });
}

}  // namespace lodestone::cli
