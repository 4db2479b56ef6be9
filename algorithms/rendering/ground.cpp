#include "algorithms/rendering/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lodestone {
namespace {

constexpr int kCells = 128;
constexpr double kFlat = 0.3;  // metres of difference that do not make a hill
constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Fills unknown nodes from coarser and coarser means of the known ones (pull-push).
void fillUnknown(std::vector<double>& heights, int nodes) {
  if (nodes < 2 || std::none_of(heights.begin(), heights.end(), [](double h) { return h == kUnknown; }))
    return;
  const int half = (nodes + 1) / 2;
  std::vector<double> coarse(static_cast<std::size_t>(half) * half, kUnknown);
  for (int y = 0; y < half; ++y) {
    for (int x = 0; x < half; ++x) {
      double sum = 0;
      int count = 0;
      for (int v = 2 * y; v < std::min(2 * y + 2, nodes); ++v) {
        for (int u = 2 * x; u < std::min(2 * x + 2, nodes); ++u) {
          const double h = heights[static_cast<std::size_t>(v) * nodes + u];
          if (h == kUnknown) continue;
          sum += h;
          ++count;
        }
      }
      if (count > 0) coarse[static_cast<std::size_t>(y) * half + x] = sum / count;
    }
  }
  fillUnknown(coarse, half);
  for (int y = 0; y < nodes; ++y) {
    for (int x = 0; x < nodes; ++x) {
      double& h = heights[static_cast<std::size_t>(y) * nodes + x];
      if (h == kUnknown) h = coarse[static_cast<std::size_t>(y / 2) * half + x / 2];
    }
  }
}

void smooth(std::vector<double>& heights, int nodes) {
  const std::vector<double> before = heights;
  const auto at = [&](int x, int y) { return before[static_cast<std::size_t>(y) * nodes + x]; };
  for (int y = 1; y + 1 < nodes; ++y) {
    for (int x = 1; x + 1 < nodes; ++x) {
      heights[static_cast<std::size_t>(y) * nodes + x] =
          (4 * at(x, y) + 2 * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1)) + at(x - 1, y - 1) +
           at(x + 1, y - 1) + at(x - 1, y + 1) + at(x + 1, y + 1)) /
          16;
    }
  }
}

/// Lowest base of the objects over each node's cells.
std::vector<double> lowestBases(const Ground& ground, const std::vector<ObjectStand>& stands) {
  std::vector<double> lowest(static_cast<std::size_t>(ground.nodes) * ground.nodes, kUnknown);
  const auto index = [&](double offset) {
    return std::clamp(static_cast<int>(std::floor(offset / ground.cell)), 0, ground.nodes - 2);
  };
  for (const ObjectStand& stand : stands) {
    const Box2 plan = bounds(stand.outline);
    if (plan.empty()) continue;
    const int right = index(plan.max.x() - ground.min.x()) + 1;
    const int top = index(plan.max.y() - ground.min.y()) + 1;
    for (int y = index(plan.min.y() - ground.min.y()); y <= top; ++y) {
      for (int x = index(plan.min.x() - ground.min.x()); x <= right; ++x) {
        double& h = lowest[static_cast<std::size_t>(y) * ground.nodes + x];
        h = std::min(h, stand.base);
      }
    }
  }
  return lowest;
}

void addQuad(LevelMesh& mesh, const std::array<Vec3, 4>& corners, std::uint8_t paint, std::uint32_t object) {
  const auto first = static_cast<std::uint32_t>(mesh.soup.vertices.size());
  for (const Vec3& p : corners) mesh.soup.vertices.push_back((p - mesh.origin).cast<float>());
  mesh.soup.triangles.push_back({first, first + 1, first + 2});
  mesh.soup.triangles.push_back({first, first + 2, first + 3});
  mesh.paint.insert(mesh.paint.end(), 2, paint);
  mesh.object.insert(mesh.object.end(), 2, object);
}

Vec3 withHeight(const Vec2& p, double z) {
  return {p.x(), p.y(), z};
}

}  // namespace

double Ground::heightAt(const Vec2& p) const {
  if (nodes == 0) return level;
  const Vec2 at = (p - min) / cell;
  if (at.minCoeff() < 0 || at.maxCoeff() > nodes - 1) return level;
  const int x = std::min(static_cast<int>(at.x()), nodes - 2);
  const int y = std::min(static_cast<int>(at.y()), nodes - 2);
  const double u = at.x() - x;
  const double v = at.y() - y;
  const auto h = [&](int i, int j) { return heights[static_cast<std::size_t>(j) * nodes + i]; };
  return (h(x, y) * (1 - u) + h(x + 1, y) * u) * (1 - v) + (h(x, y + 1) * (1 - u) + h(x + 1, y + 1) * u) * v;
}

Ground makeGround(const std::vector<ObjectStand>& stands, const Box3& box) {
  Ground ground;
  std::vector<double> bases;
  for (const ObjectStand& stand : stands) {
    if (!stand.outline.empty()) bases.push_back(stand.base);
  }
  if (bases.empty()) {
    ground.level = box.empty() ? 0 : box.min.z();
    return ground;
  }
  std::sort(bases.begin(), bases.end());
  if (bases.back() - bases.front() < kFlat) {
    ground.level = bases.front();
    return ground;
  }
  ground.level = bases[bases.size() / 10];
  const double side = std::max(box.size().x(), box.size().y()) * 1.3 + 20;
  ground.cell = side / kCells;
  ground.nodes = kCells + 1;
  ground.min = box.center().head<2>() - Vec2::Constant(side / 2);

  const std::vector<double> lowest = lowestBases(ground, stands);
  ground.heights = lowest;
  for (int i = 0; i < ground.nodes; ++i) {
    for (int edge : {0, ground.nodes - 1}) {
      ground.heights[static_cast<std::size_t>(edge) * ground.nodes + i] = ground.level;
      ground.heights[static_cast<std::size_t>(i) * ground.nodes + edge] = ground.level;
    }
  }
  fillUnknown(ground.heights, ground.nodes);
  for (int pass = 0; pass < 8; ++pass) smooth(ground.heights, ground.nodes);
  for (std::size_t i = 0; i < lowest.size(); ++i) ground.heights[i] = std::min(ground.heights[i], lowest[i]);
  return ground;
}

void addGround(LevelMesh& mesh, const Ground& ground, std::uint8_t groundPaint, std::uint8_t wallPaint) {
  if (ground.nodes == 0) return;
  constexpr double kGap = 0.02;  // metres under a wall that nobody sees
  for (std::size_t o = 0; o < mesh.stands.size(); ++o) {
    const auto& [outline, base] = mesh.stands[o];
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2& a = outline[i];
      const Vec2& b = outline[(i + 1) % outline.size()];
      const double low = std::min(ground.heightAt(a), ground.heightAt(b)) - 1;
      if (base - low < 1 + kGap) continue;
      addQuad(mesh, {withHeight(a, low), withHeight(b, low), withHeight(b, base), withHeight(a, base)},
              wallPaint, static_cast<std::uint32_t>(o));
    }
  }
  const auto node = [&](int x, int y) {
    return withHeight(ground.min + Vec2(x, y) * ground.cell,
                      ground.heights[static_cast<std::size_t>(y) * ground.nodes + x]);
  };
  for (int y = 0; y + 1 < ground.nodes; ++y) {
    for (int x = 0; x + 1 < ground.nodes; ++x) {
      addQuad(mesh, {node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)}, groundPaint,
              std::numeric_limits<std::uint32_t>::max());
    }
  }
}

}  // namespace lodestone
