// What a side of a child hides from an edge of the hull.
#pragma once

#include <array>

#include "algorithms/geometry/predicates.h"

namespace lodestone {

/// Seen from an edge a→b, the points p for which the open triangle a‑p‑b meets a given side c–d. With the
/// angles at a and at b as coordinates (a projective map, so that sides stay straight) a point hides all
/// those with both angles larger; a side therefore hides an intersection of at most three half planes, and a
/// box lies in the shadow when its corners do.
class Shadow {
 public:
  /// Keeps references to the points. \pre c or d lies left of a→b, and c–d does not cross the open segment
  /// a–b.
  Shadow(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const int sideOfC = orientation(a, b, c);
    const int sideOfD = orientation(a, b, d);
    if (sideOfC > 0 && sideOfD > 0) {
      fromFront(a, b, c, d);
    } else {
      const Vec2& front = sideOfC > 0 ? c : d;
      const Vec2& behind = sideOfC > 0 ? d : c;
      // It meets the line of the edge beyond a or beyond b, where one of the angles is larger than any.
      if (orientation(front, behind, b) > 0) {
        leftOf(a, front);
        leftOf(behind, front);
      } else {
        leftOf(front, b);
        leftOf(front, behind);
      }
    }
  }

  [[nodiscard]] bool covers(const Vec2& p) const {
    for (int i = 0; i < count_; ++i) {
      if (orientation(*planes_[i].from, *planes_[i].to, p) <= 0) return false;
    }
    return true;
  }

  [[nodiscard]] bool covers(const Box2& box) const {
    for (int i = 0; i < count_; ++i) {
      if (orientation(*planes_[i].from, *planes_[i].to,
                      rightmostCorner(box, *planes_[i].from, *planes_[i].to)) <= 0)
        return false;
    }
    return true;
  }

  /// The corner of a box that lies furthest to the right of from→to.
  [[nodiscard]] static Vec2 rightmostCorner(const Box2& box, const Vec2& from, const Vec2& to) {
    return {to.y() >= from.y() ? box.max.x() : box.min.x(), to.x() >= from.x() ? box.min.y() : box.max.y()};
  }

 private:
  void leftOf(const Vec2& from, const Vec2& to) { planes_[count_++] = {&from, &to}; }

  void fromFront(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const int atA = orientation(a, c, d);  // > 0: d has the larger angle at a
    const int atB = orientation(b, d, c);  // > 0: d has the larger angle at b
    if (atA <= 0 && atB <= 0) {            // d hides nothing that c does not
      pointShadow(a, b, d);
    } else if (atA >= 0 && atB >= 0) {
      pointShadow(a, b, c);
    } else if (atA > 0) {  // d is hidden less at b, c less at a
      leftOf(a, c);
      leftOf(d, b);
      beyond(a, b, c, d);
    } else {
      leftOf(a, d);
      leftOf(c, b);
      beyond(a, b, c, d);
    }
  }

  void pointShadow(const Vec2& a, const Vec2& b, const Vec2& q) {
    leftOf(a, q);
    leftOf(q, b);
  }

  /// The side of the line c–d that is turned away from the edge.
  void beyond(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const int side = orientation(c, d, a) != 0 ? orientation(c, d, a) : orientation(c, d, b);
    if (side > 0) {
      leftOf(d, c);
    } else {
      leftOf(c, d);
    }
  }

  struct Plane {
    const Vec2* from;
    const Vec2* to;
  };
  std::array<Plane, 3> planes_{};
  int count_ = 0;
};

}  // namespace lodestone
