#include "algorithms/simplification/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <vector>

#include "algorithms/geometry/parallel.h"
#include "algorithms/geometry/triangle_distance.h"
#include "algorithms/geometry/triangle_tree.h"

namespace lodestone {
namespace {

constexpr int kMostCuts = 1 << 20;
constexpr std::size_t kGrain = 64;  // vertices or triangles

/// A point of the surface that is measured, and the closest triangle of the other one.
struct Probe {
  Vec3 at = Vec3::Zero();
  std::uint32_t triangle = 0;
  double distance = 0;
};

/// A triangle or a part of one.
struct Piece {
  std::array<Probe, 3> corners;
  double bound = 0;  ///< no point of it is farther
  bool operator<(const Piece& other) const { return bound < other.bound; }
};

class Farthest {
 public:
  Farthest(const ComponentMesh& from, const ComponentMesh& to, double accuracy)
      : from_(from),
        to_(to),
        tree_(to.vertices, to.triangles),
        accuracy_(accuracy),
        probes_(from.vertices.size()) {}

  /// The distance; `least` where it is no greater.
  double run(const Progress& progress, double least = 0) {
    most_ = least;
    forPieces(0, probes_.size(), kGrain, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) probes_[v] = probe(from_.vertices[v]);
    });
    progress.checkpoint();
    for (const Probe& known : probes_) most_ = std::max(most_, known.distance);
    std::vector<Piece> pieces(from_.triangles.size());
    forPieces(0, pieces.size(), kGrain, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        const auto& [a, b, c] = from_.triangles[t];
        pieces[t] = bounded({probes_[a], probes_[b], probes_[c]});
      }
    });
    progress.checkpoint();
    return cutFarthest(std::move(pieces), progress);
  }

 private:
  [[nodiscard]] Probe probe(const Vec3& at) const {
    const TriangleTree::Closest closest = tree_.closest(at);
    return {at, closest.triangle, std::sqrt(closest.squared)};
  }

  /// Halfway between two probes: the closest triangle of one of them is a good guess.
  [[nodiscard]] Probe between(const Probe& a, const Probe& b) const {
    const Vec3 at = (a.at + b.at) / 2;
    const double guess = distanceTo(a.triangle, at);
    const TriangleTree::Closest closer = tree_.closest(at, guess * guess);
    if (closer.squared >= guess * guess) return {at, a.triangle, guess};
    return {at, closer.triangle, std::sqrt(closer.squared)};
  }

  [[nodiscard]] double distanceTo(std::uint32_t triangle, const Vec3& p) const {
    const auto& [a, b, c] = to_.triangles[triangle];
    return (closestPoint({to_.vertices[a], to_.vertices[b], to_.vertices[c]}, p) - p).norm();
  }

  [[nodiscard]] Piece bounded(const std::array<Probe, 3>& corners) const {
    double longest = 0;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, (corners[i].at - corners[(i + 1) % 3].at).norm());
      most = std::max(most, corners[i].distance);
    }
    // every point of a triangle is as near as this to one of its corners
    Piece piece{corners, most + longest / std::sqrt(3.0)};
    for (std::size_t i = 0; i < 3 && piece.bound > most_ + accuracy_; ++i)
      tighten(piece, corners[i].triangle);
    return piece;
  }

  /// By the distance of the corners to one triangle, which no point between them exceeds.
  void tighten(Piece& piece, std::uint32_t triangle) const {
    double greatest = 0;
    for (const Probe& corner : piece.corners) {
      greatest =
          std::max(greatest, corner.triangle == triangle ? corner.distance : distanceTo(triangle, corner.at));
    }
    piece.bound = std::min(piece.bound, greatest);
  }

  /// Always cuts the piece that may hold the farthest point, until none can hold one that matters. In one
  /// thread: what is cut next depends on what was found.
  double cutFarthest(std::vector<Piece> pieces, const Progress& progress) {
    std::erase_if(pieces, [&](const Piece& piece) { return piece.bound <= most_ + accuracy_; });
    std::priority_queue<Piece> queue({}, std::move(pieces));
    for (int cuts = 0; !queue.empty() && queue.top().bound > most_ + accuracy_ && cuts < kMostCuts; ++cuts) {
      if (cuts % 256 == 0) progress.checkpoint();
      const std::array<Probe, 3> corners = queue.top().corners;
      queue.pop();
      std::array<Probe, 3> middles;
      for (std::size_t i = 0; i < 3; ++i) {
        middles[i] = between(corners[i], corners[(i + 1) % 3]);
        most_ = std::max(most_, middles[i].distance);
      }
      for (const auto& part :
           {std::array{corners[0], middles[0], middles[2]}, std::array{corners[1], middles[1], middles[0]},
            std::array{corners[2], middles[2], middles[1]}, middles}) {
        Piece piece = bounded(part);
        if (piece.bound > most_ + accuracy_) queue.push(piece);
      }
    }
    return most_;
  }

  const ComponentMesh& from_;
  const ComponentMesh& to_;
  TriangleTree tree_;
  double accuracy_;
  std::vector<Probe> probes_;  ///< by vertex
  double most_ = 0;            ///< that was found so far
};

}  // namespace

namespace {

/// Both ways, the way back from a least value that the way there gives.
template <class Least>
Deviation bothWays(const ComponentMesh& first, const ComponentMesh& second, double accuracy,
                   const Progress& progress, const Least& leastBack) {
  if (first.triangles.empty() && second.triangles.empty()) return {};
  const double diagonal = std::max(bounds(first).size().norm(), bounds(second).size().norm());
  if (first.triangles.empty() || second.triangles.empty()) return {diagonal, diagonal};
  if (accuracy <= 0) accuracy = diagonal / 400;
  Deviation result;
  result.forward = Farthest(first, second, accuracy).run(progress);
  progress.report(0.5);
  result.backward = Farthest(second, first, accuracy).run(progress, leastBack(result.forward));
  progress.report(1);
  return result;
}

}  // namespace

Deviation deviation(const ComponentMesh& first, const ComponentMesh& second, double accuracy,
                    const Progress& progress) {
  return bothWays(first, second, accuracy, progress, [](double) { return 0.0; });
}

double hausdorffDistance(const ComponentMesh& first, const ComponentMesh& second, double accuracy,
                         const Progress& progress) {
  return bothWays(first, second, accuracy, progress, [](double forward) { return forward; }).hausdorff();
}

}  // namespace lodestone
