#include <algorithm>
#include <optional>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>

#include "tests/support/reference_hull.h"

namespace lodestone::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Polygon2 = CGAL::Polygon_2<Kernel>;

Point exact(const Vec2& p) {
  return {p.x(), p.y()};
}

Polygon2 exactPolygon(const Ring& ring) {
  Polygon2 polygon;
  for (const Vec2& p : ring) polygon.push_back(exact(p));
  return polygon;
}

class Reference {
 public:
  Reference(const std::vector<Ring>& children, std::size_t target) : target_(target) {
    for (const Ring& child : children) {
      points_.insert(points_.end(), child.begin(), child.end());
      children_.push_back(exactPolygon(child));
    }
    std::sort(points_.begin(), points_.end(), less);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  Ring run() {
    startFromConvexHull();
    while (corners(hull_) < target_ && divideLargest()) {
    }
    Ring ring;
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      if (isCorner(hull_, i)) ring.push_back(hull_[i]);
    }
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), less), ring.end());
    return ring;
  }

 private:
  static bool less(const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); }

  static bool isCorner(const Ring& ring, std::size_t i) {
    const std::size_t n = ring.size();
    return !CGAL::collinear(exact(ring[(i + n - 1) % n]), exact(ring[i]), exact(ring[(i + 1) % n]));
  }
  static std::size_t corners(const Ring& ring) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) count += isCorner(ring, i) ? 1 : 0;
    return count;
  }

  /// The ring with every vertex of the children that lies on one of its edges put in.
  [[nodiscard]] Ring withVerticesOnEdges(const Ring& ring) const {
    Ring result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      result.push_back(a);
      std::vector<Vec2> between;
      for (const Vec2& q : points_) {
        if (q != a && q != b && CGAL::are_ordered_along_line(exact(a), exact(q), exact(b)))
          between.push_back(q);
      }
      if (less(b, a)) std::reverse(between.begin(), between.end());
      result.insert(result.end(), between.begin(), between.end());
    }
    return result;
  }

  void startFromConvexHull() {
    std::vector<Point> all;
    for (const Vec2& p : points_) all.push_back(exact(p));
    std::vector<Point> convex;
    CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(convex));
    for (const Point& p : convex) hull_.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    hull_ = withVerticesOnEdges(hull_);
  }

  [[nodiscard]] bool cutsAChild(const Vec2& a, const Vec2& b, const Vec2& p) const {
    const Kernel::Triangle_2 triangle(exact(a), exact(b), exact(p));
    for (const Polygon2& child : children_) {
      if (child.bounded_side(CGAL::centroid(triangle)) == CGAL::ON_BOUNDED_SIDE) return true;
      for (auto edge = child.edges_begin(); edge != child.edges_end(); ++edge) {
        const auto common = CGAL::intersection(triangle, *edge);
        if (!common) continue;
        if (const auto* segment = boost::get<Kernel::Segment_2>(&*common)) {
          if (triangle.has_on_bounded_side(CGAL::midpoint(segment->source(), segment->target()))) return true;
        }
      }
    }
    return false;
  }

  /// The hull with the edge from vertex i divided at p, if that is allowed.
  [[nodiscard]] std::optional<Ring> divided(std::size_t i, const Vec2& p) const {
    const Vec2& a = hull_[i];
    const Vec2& b = hull_[(i + 1) % hull_.size()];
    if (!CGAL::left_turn(exact(a), exact(b), exact(p))) return std::nullopt;
    if (std::find(hull_.begin(), hull_.end(), p) != hull_.end()) return std::nullopt;
    if (cutsAChild(a, b, p)) return std::nullopt;
    Ring ring = hull_;
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i + 1), p);
    ring = withVerticesOnEdges(ring);
    Ring sorted = ring;
    std::sort(sorted.begin(), sorted.end(), less);
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return std::nullopt;
    if (!exactPolygon(ring).is_simple()) return std::nullopt;
    return ring;
  }

  /// Of each edge its largest triangle; of these the largest that does not pass the target.
  bool divideLargest() {
    struct Choice {
      double area;
      Vec2 p, a;
      Ring ring;
    };
    std::optional<Choice> best;
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      const Vec2& a = hull_[i];
      const Vec2& b = hull_[(i + 1) % hull_.size()];
      const auto areaOf = [&](const Vec2& p) {
        return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
      };
      std::vector<Vec2> order = points_;
      std::stable_sort(order.begin(), order.end(),
                       [&](const Vec2& p, const Vec2& q) { return areaOf(p) > areaOf(q); });
      for (const Vec2& p : order) {
        std::optional<Ring> ring = divided(i, p);
        if (!ring) continue;
        const Choice choice{areaOf(p), p, a, *ring};
        const bool larger = !best || choice.area > best->area ||
                            (choice.area == best->area &&
                             (less(choice.p, best->p) || (choice.p == best->p && less(a, best->a))));
        if (larger && corners(*ring) <= target_) best = choice;
        break;
      }
    }
    if (best) hull_ = best->ring;
    return best.has_value();
  }

  std::vector<Vec2> points_;
  std::vector<Polygon2> children_;
  std::size_t target_;
  Ring hull_;
};

}  // namespace

Ring referenceHull(const std::vector<Ring>& children, std::size_t targetEdges) {
  return Reference(children, targetEdges).run();
}

std::string brokenRule(const Ring& hull, const std::vector<Ring>& children, std::size_t targetEdges) {
  const Polygon2 outline = exactPolygon(hull);
  if (!outline.is_simple()) return "not simple";
  if (!outline.is_counterclockwise_oriented()) return "not counter-clockwise";
  std::vector<Point> all;
  std::size_t childEdges = 0;
  for (const Ring& child : children) {
    const Polygon2 polygon = exactPolygon(child);
    CGAL::Polygon_set_2<Kernel> rest(polygon);
    rest.difference(outline);
    if (!rest.is_empty()) return "a child is cut";
    all.insert(all.end(), polygon.vertices_begin(), polygon.vertices_end());
    childEdges += child.size();
  }
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (std::find(all.begin(), all.end(), exact(hull[i])) == all.end()) return "a vertex is nobody's";
    if (CGAL::collinear(exact(hull[(i + hull.size() - 1) % hull.size()]), exact(hull[i]),
                        exact(hull[(i + 1) % hull.size()]))) {
      return "a vertex in the middle of a straight side";
    }
  }
  std::vector<Point> convex;
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(convex));
  if (hull.size() > std::max(targetEdges, convex.size())) return "more edges than allowed";
  if (hull.size() > childEdges) return "more edges than the children";
  return {};
}

}  // namespace lodestone::test
