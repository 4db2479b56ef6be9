// Simplification of a made-up building of 400 touching components and about 100,000 triangles to half of its
// triangles, beside peers in the same run (meshoptimizer, OpenMesh's decimater and, where VTK is built,
// vtkQuadricDecimation), and of a made-up city of LoD2 houses with one thread and with two. Arguments: --rate
// R, --houses N, --stage building|city|profile-topology|profile-qem.
#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <thread>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <fmt/format.h>
#include <tbb/global_control.h>

#ifdef LODESTONE_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif
#ifdef LODESTONE_HAS_VTK
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#endif

#include "algorithms/geometry/components.h"
#include "algorithms/simplification/city_simplification.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/simplification.h"

#include "measuring.h"
#include "simplification_models.h"

namespace lodestone {
namespace {

struct Timing {
  double seconds = 0;
  std::size_t triangles = 0;  ///< that are left
};

/// The fastest of three.
Timing best(const std::function<std::size_t()>& work) {
  Timing timing{std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i < 3; ++i)
    timing.seconds = std::min(timing.seconds, seconds([&] { timing.triangles = work(); }));
  return timing;
}

void print(const std::string& name, const Timing& timing, const ComponentMesh& mesh, double unit) {
  fmt::print("{:<34} {:>8.1f} {:>10} {:>9.2f} {:>8.2f}\n", name, 1000 * timing.seconds, timing.triangles,
             mesh.triangleCount() / timing.seconds / 1e6, unit / timing.seconds);
}

#ifdef LODESTONE_HAS_VTK
std::size_t decimateByVtk(const ComponentMesh& mesh, double rate) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& v : mesh.vertices) points->InsertNextPoint(v.data());
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b, c] : mesh.triangles) cells->InsertNextCell({a, b, c});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(data);
  decimation->SetTargetReduction(rate);
  decimation->Update();
  return static_cast<std::size_t>(decimation->GetOutput()->GetNumberOfPolys());
}
#endif

#ifdef LODESTONE_HAS_MESHOPTIMIZER
std::size_t simplifyByMeshoptimizer(const ComponentMesh& mesh, double rate) {
  std::vector<float> positions;
  for (const Vec3& v : mesh.vertices) {
    for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>(v[i]));
  }
  std::vector<unsigned> indices;
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  std::vector<unsigned> left(indices.size());
  const auto target = static_cast<std::size_t>((1 - rate) * mesh.triangleCount()) * 3;
  return meshopt_simplify(left.data(), indices.data(), indices.size(), positions.data(), mesh.vertexCount(),
                          3 * sizeof(float), target, 1) /
         3;
}
#endif

std::size_t decimateByOpenMesh(const ComponentMesh& mesh, double rate) {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  Mesh half;
  half.request_face_status();
  half.request_edge_status();
  half.request_vertex_status();
  half.request_face_normals();
  for (const Vec3& v : mesh.vertices)
    half.add_vertex({static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())});
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto handle = [](std::uint32_t v) { return Mesh::VertexHandle(static_cast<int>(v)); };
    (void)half.add_face(handle(a), handle(b), handle(c));
  }
  half.update_normals();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(half);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  (void)decimater.decimate_to_faces(0, static_cast<std::size_t>((1 - rate) * mesh.triangleCount()));
  half.garbage_collection();
  return half.n_faces();
}

ComponentMesh meshOf(const CityModel& city) {
  const std::uint32_t first = 0;
  return makeComponentMesh(city, {&first, 1});
}

void compareBuilding(double rate) {
  const ComponentMesh mesh = meshOf(test::manyPartedBuilding());
  const ComponentMesh textured = test::boxMapped(mesh);
  fmt::print("{} triangles, {} components, rate {}\n", mesh.triangleCount(), mesh.components.size(), rate);
  fmt::print("{:<34} {:>8} {:>10} {:>9} {:>8}\n", "", "ms", "left", "Mtri/s", "x peer");
  double unit = 0;
  const auto row = [&](const std::string& name, const std::function<std::size_t()>& work) {
    const Timing timing = best(work);
    if (unit == 0) unit = timing.seconds;
    print(name, timing, mesh, unit);
  };
#ifdef LODESTONE_HAS_VTK
  row("vtkQuadricDecimation (peer)", [&] { return decimateByVtk(mesh, rate); });
#endif
  row("OpenMesh decimater", [&] { return decimateByOpenMesh(mesh, rate); });
#ifdef LODESTONE_HAS_MESHOPTIMIZER
  row("meshoptimizer", [&] { return simplifyByMeshoptimizer(mesh, rate); });
#endif
  for (const std::size_t threads : {2, 1}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const std::string suffix = threads == 1 ? ", one thread" : "";
    row("Lodestone, classes alone" + suffix, [&] {
      (void)classify(mesh);
      return mesh.triangles.size();
    });
    for (const SimplifyMethod method : {SimplifyMethod::Topology, SimplifyMethod::Qem}) {
      const std::string name = method == SimplifyMethod::Qem ? "Lodestone, qem" : "Lodestone, topology";
      row(name + suffix,
          [&] { return simplify(mesh, {.method = method, .rate = rate}).mesh.triangles.size(); });
      row(name + ", textured" + suffix,
          [&] { return simplify(textured, {.method = method, .rate = rate}).mesh.triangles.size(); });
    }
  }
}

/// The best of some rounds of each number of threads by turns: the machine is not the same for long.
void simplifyHouses(int houses) {
  const auto city = std::make_shared<const CityModel>(test::rowsOfHouses(houses));
  std::array<double, 2> times{1e9, 1e9};
  std::size_t left = 0;
  for (int round = 0; round < 3; ++round) {
    for (std::size_t threads = 1; threads <= times.size(); ++threads) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      const double time = seconds([&] { left = simplifyCity(city, {})->report.trianglesAfter; });
      times[threads - 1] = std::min(times[threads - 1], time);
    }
  }
  fmt::print(
      "{} houses: {} triangles left; one thread {:.2f} s, two {:.2f} s ({:.3f} ms a house), speed-up "
      "{:.2f}\n",
      houses, left, times[0], times[1], 1000 * times[1] / houses, times[0] / times[1]);
}

/// Runs for a profiler to look at.
void profile(SimplifyMethod method, double rate) {
  const ComponentMesh mesh = meshOf(test::manyPartedBuilding());
  for (int i = 0; i < 20; ++i) (void)simplify(mesh, {.method = method, .rate = rate});
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  double rate = 0.5;
  int houses = 10000;
  std::string stage;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--rate") rate = std::atof(argv[i + 1]);
    if (name == "--houses") houses = std::atoi(argv[i + 1]);
    if (name == "--stage") stage = argv[i + 1];
  }
  if (stage == "profile-topology") lodestone::profile(lodestone::SimplifyMethod::Topology, rate);
  if (stage == "profile-qem") lodestone::profile(lodestone::SimplifyMethod::Qem, rate);
  if (stage.empty() || stage == "building") lodestone::compareBuilding(rate);
  if (stage.empty() || stage == "city") lodestone::simplifyHouses(houses);
  return 0;
}
