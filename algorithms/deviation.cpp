#include "algorithms/deviation.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "algorithms/triangle_tree.h"

namespace lodestone {
namespace {

/// Most points strewn over one triangle's side: a ground plate beside a door handle.
constexpr double kMostSteps = 64;

/// Greatest squared distance of points of one triangle from the tree.
double farthestOf(const std::array<Vec3, 3>& t, const TriangleTree& tree, double step, double most) {
  const double longest = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
  const auto steps = static_cast<unsigned>(std::clamp(std::ceil(longest / step), 1.0, kMostSteps));
  for (unsigned i = 0; i <= steps; ++i) {
    for (unsigned j = 0; i + j <= steps; ++j) {
      const Vec3 p = t[0] + (t[1] - t[0]) * (static_cast<double>(i) / steps) +
                     (t[2] - t[0]) * (static_cast<double>(j) / steps);
      most = std::max(most, tree.closest(p).squared);
    }
  }
  return most;
}

double farthest(const ComponentMesh& from, const ComponentMesh& to, double step, const Progress& progress) {
  const TriangleTree tree(to.vertices, to.triangles);
  const double squared = tbb::parallel_reduce(
      tbb::blocked_range<std::uint32_t>(0, from.triangleCount(), 32), 0.0,
      [&](const tbb::blocked_range<std::uint32_t>& piece, double most) {
        for (std::uint32_t t = piece.begin(); t < piece.end() && !progress.stopRequested(); ++t) {
          const auto& [a, b, c] = from.triangles[t];
          most = farthestOf({from.vertices[a], from.vertices[b], from.vertices[c]}, tree, step, most);
        }
        return most;
      },
      [](double a, double b) { return std::max(a, b); });
  progress.checkpoint();
  return std::sqrt(squared);
}

}  // namespace

Deviation deviation(const ComponentMesh& first, const ComponentMesh& second, double step,
                    const Progress& progress) {
  if (first.triangles.empty() && second.triangles.empty()) return {};
  const double diagonal = std::max(bounds(first).size().norm(), bounds(second).size().norm());
  if (first.triangles.empty() || second.triangles.empty()) return {diagonal, diagonal};
  if (step <= 0) step = diagonal / 200;
  Deviation result;
  result.forward = farthest(first, second, step, progress);
  progress.report(0.5);
  result.backward = farthest(second, first, step, progress);
  progress.report(1);
  return result;
}

}  // namespace lodestone
