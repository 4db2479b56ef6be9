#include "algorithms/simplification/component_collapses.h"

#include <algorithm>

namespace lodestone {

double costOfCollapse(const CollapseCost& cost, const CollapsingMesh& mesh, bool optimal, std::uint32_t v1,
                      std::uint32_t v2, bool open, double most) {
  if (optimal) return cost.contraction(v1, v2).cost;
  const double byPlanes = cost(v1, v2, open, most);
  if (!mesh.hasCharts()) return byPlanes;
  // What the texture says takes longest to find: it is asked where the answer can matter.
  const double byLength = cost.byLength(v1, v2, most);
  if (std::min(byPlanes, byLength) > most) return CollapseCost::kNever;
  return mesh.changesLook(v1, v2) ? byLength : byPlanes;
}

ComponentCollapses::ComponentCollapses(const ComponentMesh& mesh, BoundaryPlanes planes,
                                       const SimplifyOptions& options, const Vec3& origin, Scope scope)
    : vertices_(mesh.vertexCount()),
      optimal_(options.method == SimplifyMethod::QemOptimal),
      error_(needsPerception(options.method) ? options.error : 0),
      scope_(std::move(scope)),
      cost_(mesh, std::move(planes), options, origin),
      mesh_(mesh, cost_),
      queue_(vertices_ + 1),
      best_(vertices_) {
  for (std::uint32_t v = 0; v < vertices_; ++v) renew(v);
  if (queue_.empty()) offerRemoval();
}

/// Its cost may be kNever where it is above `most`.
ComponentCollapses::Collapse ComponentCollapses::collapseOf(std::uint32_t v1, std::uint32_t v2, bool open,
                                                            double most) const {
  Collapse collapse{v1, v2, costOfCollapse(cost_, mesh_, optimal_, v1, v2, open, most),
                    (position(v2) - position(v1)).squaredNorm()};
  if (error_ > 0 && cost_.meanDistance(v1, v2, position(v2)) > error_) collapse.cost = CollapseCost::kNever;
  return collapse;
}

/// Calls visit(collapse) for all that v can be moved onto at a cost up to `most`, which may fall meanwhile.
template <class Visit>
void ComponentCollapses::forEachCollapse(std::uint32_t v, bool open, const double& most,
                                         const Visit& visit) const {
  if (scope_.holds(v)) return;
  mesh_.forEachTarget(v, [&](std::uint32_t to) {
    const Collapse collapse = collapseOf(v, to, open, most);
    if (collapse.cost < CollapseCost::kNever) visit(collapse);
  });
}

/// All that v can be moved onto, the cheapest first.
void ComponentCollapses::listCollapses(std::uint32_t v, std::vector<Collapse>& list) const {
  list.clear();
  forEachCollapse(v, isAtRim(v), CollapseCost::kNever,
                  [&](const Collapse& collapse) { list.push_back(collapse); });
  std::sort(list.begin(), list.end(), [](const Collapse& a, const Collapse& b) { return a.before(b); });
}

bool ComponentCollapses::isLegal(const Collapse& collapse) {
  at_ = optimal_ ? cost_.contraction(collapse.v1, collapse.v2).at : position(collapse.v2);
  return mesh_.mayCollapse(collapse.v1, collapse.v2, at_, optimal_);
}

/// Puts v in the queue at its cheapest collapse, legal or not: legality is asked when its turn comes.
void ComponentCollapses::renew(std::uint32_t v) {
  Waiting found{{}, true, isAtRim(v)};
  forEachCollapse(v, found.open, found.collapse.cost, [&](const Collapse& collapse) {
    if (found.collapse.cost == CollapseCost::kNever || collapse.before(found.collapse))
      found.collapse = collapse;
  });
  if (found.collapse.cost == CollapseCost::kNever)
    queue_.remove(v);
  else
    wait(v, found);
}

/// renew() after v1 went into v2, a neighbour of v. Without charts the costs of v's other collapses stand:
/// the quadric and the place of v2 alone have changed.
void ComponentCollapses::renewBeside(std::uint32_t v, std::uint32_t v1, std::uint32_t v2) {
  const Waiting& known = best_[v];
  const bool stands = queue_.contains(v) && known.cheapest && known.collapse.v2 != v1 &&
                      known.collapse.v2 != v2 && !mesh_.hasCopies(v) && known.open == isAtRim(v) &&
                      !mesh_.hasCharts();
  if (!stands) return renew(v);
  const Collapse collapse = collapseOf(v, v2, known.open, known.collapse.cost);
  if (collapse.cost < CollapseCost::kNever && collapse.before(known.collapse))
    wait(v, {collapse, true, known.open});
}

void ComponentCollapses::wait(std::uint32_t v, const Waiting& what) {
  best_[v] = what;
  queue_.set(v, what.collapse.cost);
}

void ComponentCollapses::step() {
  const std::uint32_t v = queue_.top();
  if (v < vertices_) return tryCollapse(v);
  removeWhole();
}

void ComponentCollapses::removeWhole() {
  queue_.clear();
  mesh_.removeAll();
  ++operations_;
}

void ComponentCollapses::tryCollapse(std::uint32_t v) {
  const Waiting& known = best_[v];
  if (known.cheapest && isLegal(known.collapse)) return perform(known.collapse);
  listCollapses(v, list_);
  for (const Collapse& candidate : list_) {
    if (!isLegal(candidate)) continue;
    if (candidate.cost > queue_.cost(v))
      wait(v, {candidate, false, false});
    else
      perform(candidate);
    return;
  }
  queue_.remove(v);
  if (queue_.empty()) rescan();
}

void ComponentCollapses::perform(Collapse collapse) {  // a copy: what it stands in is made anew on the way
  mesh_.collapse(collapse.v1, collapse.v2, at_);
  cost_.collapsed(collapse.v1, collapse.v2, at_);
  queue_.remove(collapse.v1);
  ++operations_;
  mesh_.listNeighbours(collapse.v2, ring_);
  renew(collapse.v2);
  for (const std::uint32_t neighbour : ring_) renewBeside(neighbour, collapse.v1, collapse.v2);
  if (queue_.empty()) rescan();
}

/// All vertices were found without a legal collapse at their turn; what went on since may have freed one.
/// When none is, the component itself comes up for removal.
void ComponentCollapses::rescan() {
  for (std::uint32_t v = 0; v < vertices_; ++v) {
    listCollapses(v, list_);
    const auto legal = std::find_if(list_.begin(), list_.end(),
                                    [&](const Collapse& candidate) { return isLegal(candidate); });
    if (legal != list_.end()) wait(v, {*legal, false, false});
  }
  if (queue_.empty()) offerRemoval();
}

/// A component that touches others is held as its vertices are.
void ComponentCollapses::offerRemoval() {
  if (!scope_.mayGo) return;
  bool touches = false;
  for (std::uint32_t v = 0; v < vertices_ && !touches; ++v) touches = cost_.isBoundary(v);
  queue_.set(vertices_, (touches ? cost_.a() : 1) * mesh_.extent());
}

}  // namespace lodestone
