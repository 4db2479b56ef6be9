#include "algorithms/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/parallel.h"
#include "algorithms/triangle_distance.h"
#include "algorithms/triangle_tree.h"

namespace lodestone {
namespace {

constexpr int kMostCuts = 4096;
constexpr std::size_t kGrain = 64;  // vertices or triangles

/// A point of the surface that is measured, and the closest triangle of the other one.
struct Probe {
  Vec3 at = Vec3::Zero();
  std::uint32_t triangle = 0;
  double distance = 0;
};

using Piece = std::array<Probe, 3>;  ///< a triangle or a part of one

class Farthest {
 public:
  Farthest(const ComponentMesh& from, const ComponentMesh& to, double accuracy)
      : from_(from),
        to_(to),
        tree_(to.vertices, to.triangles),
        accuracy_(accuracy),
        probes_(from.vertices.size()) {}

  double run(const Progress& progress) {
    forPieces(0, probes_.size(), kGrain, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) probes_[v] = probe(from_.vertices[v]);
    });
    progress.checkpoint();
    for (const Probe& known : probes_) atVertices_ = std::max(atVertices_, known.distance);
    // each triangle starts from the vertices' distance, not from each other's, so that threads do not matter
    std::vector<double> most(from_.triangles.size(), 0);
    forPieces(0, most.size(), kGrain, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) most[t] = farthestOf(from_.triangles[t]);
    });
    progress.checkpoint();
    return most.empty() ? 0 : *std::max_element(most.begin(), most.end());
  }

 private:
  [[nodiscard]] Probe probe(const Vec3& at) const {
    const TriangleTree::Closest closest = tree_.closest(at);
    return {at, closest.triangle, std::sqrt(closest.squared)};
  }

  [[nodiscard]] double distanceTo(std::uint32_t triangle, const Vec3& p) const {
    const auto& [a, b, c] = to_.triangles[triangle];
    return (closestPoint({to_.vertices[a], to_.vertices[b], to_.vertices[c]}, p) - p).norm();
  }

  /// No point of the piece is farther than this.
  [[nodiscard]] double bound(const Piece& piece) const {
    double longest = 0;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, (piece[i].at - piece[(i + 1) % 3].at).norm());
      most = std::max(most, piece[i].distance);
    }
    // every point of a triangle is as near as this to one of its corners
    double least = most + longest / std::sqrt(3.0);
    for (const Probe& corner : piece) {
      double greatest = 0;
      for (const Probe& other : piece) {
        greatest =
            std::max(greatest, other.triangle == corner.triangle ? other.distance
                                                                 : distanceTo(corner.triangle, other.at));
      }
      least = std::min(least, greatest);
    }
    return least;
  }

  [[nodiscard]] double farthestOf(const ComponentMesh::Triangle& triangle) const {
    double most = atVertices_;
    std::vector<Piece> pieces{{probes_[triangle[0]], probes_[triangle[1]], probes_[triangle[2]]}};
    for (int cuts = 0; !pieces.empty() && cuts < kMostCuts; ++cuts) {
      const Piece piece = pieces.back();
      pieces.pop_back();
      if (bound(piece) <= most + accuracy_) continue;
      std::array<Probe, 3> middles;
      for (std::size_t i = 0; i < 3; ++i) {
        middles[i] = probe((piece[i].at + piece[(i + 1) % 3].at) / 2);
        most = std::max(most, middles[i].distance);
      }
      pieces.push_back({piece[0], middles[0], middles[2]});
      pieces.push_back({piece[1], middles[1], middles[0]});
      pieces.push_back({piece[2], middles[2], middles[1]});
      pieces.push_back(middles);
    }
    return most;
  }

  const ComponentMesh& from_;
  const ComponentMesh& to_;
  TriangleTree tree_;
  double accuracy_;
  std::vector<Probe> probes_;  ///< by vertex
  double atVertices_ = 0;
};

}  // namespace

Deviation deviation(const ComponentMesh& first, const ComponentMesh& second, double accuracy,
                    const Progress& progress) {
  if (first.triangles.empty() && second.triangles.empty()) return {};
  const double diagonal = std::max(bounds(first).size().norm(), bounds(second).size().norm());
  if (first.triangles.empty() || second.triangles.empty()) return {diagonal, diagonal};
  if (accuracy <= 0) accuracy = diagonal / 1000;
  Deviation result;
  result.forward = Farthest(first, second, accuracy).run(progress);
  progress.report(0.5);
  result.backward = Farthest(second, first, accuracy).run(progress);
  progress.report(1);
  return result;
}

}  // namespace lodestone
