#include "algorithms/simplification/component_contractions.h"

#include <algorithm>

namespace lodestone {

CollapseCost::Placements placesToContract(const CollapseCost& cost, const Scope& scope, std::uint32_t v1,
                                          std::uint32_t v2) {
  const bool held1 = scope.holds(v1);
  const bool held2 = scope.holds(v2);
  if (held1 && held2) return {};
  if (!held1 && !held2) return cost.contractions(v1, v2);
  const Vec3& at = cost.position(held1 ? v1 : v2);
  return {{{{at, cost.qem(v1, v2, at)}}}, 1};
}

ComponentContractions::ComponentContractions(const ComponentMesh& mesh, const SimplifyOptions& options,
                                             const Vec3& origin, Scope scope)
    : vertices_(mesh.vertexCount()),
      error_(options.error),
      scope_(std::move(scope)),
      cost_(mesh, BoundaryPlanes(), options, origin),
      mesh_(mesh, cost_),
      look_(mesh_, vertices_, origin),
      edges_(mesh_.edgeCount()),
      queue_(edges_ + 1),
      waiting_(edges_),
      renewed_(edges_, 0) {
  for (std::uint32_t e = 0; e < edges_; ++e) {
    place(e);
    price(e);
  }
  if (queue_.empty()) offerRemoval();
}

std::pair<double, std::uint32_t> ComponentContractions::next() const {
  const std::uint32_t edge = queue_.top();
  return {queue_.cost(edge), edge < edges_ ? mesh_.ends(edge)[0] : vertices_};
}

ComponentContractions::Ways ComponentContractions::waysOf(std::uint32_t edge) const {
  const auto [v1, v2] = mesh_.ends(edge);
  Ways ways;
  const CollapseCost::Placements all = placesToContract(cost_, scope_, v1, v2);
  for (std::size_t i = 0; i < all.count; ++i) {
    if (error_ == 0 || cost_.meanDistance(v1, v2, all.places[i].at) <= error_)
      ways.places[ways.count++] = all.places[i];
  }
  ways.overCharts = ways.count;
  if (!mesh_.hasCharts() || (position(v2) - position(v1)).norm() > error_) return ways;
  for (const auto& [from, to] : {std::pair(v1, v2), std::pair(v2, v1)}) {
    if (!scope_.holds(from) && cost_.meanDistance(v1, v2, position(to)) <= error_)
      ways.places[ways.count++] = {position(to), cost_.byLength(from, to)};
  }
  if (ways.count == ways.overCharts + 2 &&
      ways.places[ways.count - 1].cost < ways.places[ways.count - 2].cost)
    std::swap(ways.places[ways.count - 1], ways.places[ways.count - 2]);
  return ways;
}

double ComponentContractions::priceOf(std::uint32_t edge, const CollapseCost::Placement& place) const {
  return look_(edge, place.at, place.cost).cost();
}

/// Finds an edge its best place, allowed or not: that is asked when its turn comes.
void ComponentContractions::place(std::uint32_t edge) {
  const Ways ways = waysOf(edge);
  waiting_[edge].best = ways.count == 0 ? CollapseCost::Placement() : ways.places.front();
}

/// Puts an edge in the queue at its best place.
void ComponentContractions::price(std::uint32_t edge) {
  Waiting& waiting = waiting_[edge];
  waiting.place = 0;
  waiting.heldByCharts = false;
  const double price =
      waiting.best.cost < CollapseCost::kNever ? priceOf(edge, waiting.best) : CollapseCost::kNever;
  if (price < CollapseCost::kNever)
    queue_.set(edge, price);
  else
    queue_.remove(edge);
}

void ComponentContractions::step() {
  const std::uint32_t edge = queue_.top();
  if (edge == edges_) return removeWhole();
  const Ways ways = waysOf(edge);
  Waiting& waiting = waiting_[edge];
  if (const auto contraction = allowed(edge, ways.places[waiting.place].at, waiting.place >= ways.overCharts))
    return perform(*contraction);
  ++waiting.place;
  const double price =
      waiting.place == ways.count ? CollapseCost::kNever : priceOf(edge, ways.places[waiting.place]);
  if (price < CollapseCost::kNever)
    queue_.set(edge, std::max(price, queue_.cost(edge)));
  else
    queue_.remove(edge);
  if (queue_.empty()) offerRemoval();
}

/// Either end may be the one that goes: where edges of more than two triangles were opened, it matters. The
/// one that stands at the place already stays rather.
std::optional<ComponentContractions::Contraction> ComponentContractions::allowed(std::uint32_t edge,
                                                                                 const Vec3& at,
                                                                                 bool overCharts) {
  auto [from, to] = mesh_.ends(edge);
  if (at == position(from)) std::swap(from, to);
  for (int turn = 0; turn < 2; ++turn, std::swap(from, to)) {
    if (scope_.holds(from) || !mesh_.mayCollapse(from, to, at, at != position(to))) continue;
    if (overCharts || !mesh_.changesLook(from, to, at)) return Contraction{from, to, at};
    waiting_[edge].heldByCharts = true;
  }
  return std::nullopt;
}

void ComponentContractions::perform(const Contraction& contraction) {
  const auto& [from, to, at] = contraction;
  folded_.clear();
  mesh_.forEachEdge(from, [&](std::uint32_t edge) { folded_.push_back(edge); });
  mesh_.collapse(from, to, at);
  cost_.collapsed(from, to, at);
  ++operations_;
  for (const std::uint32_t edge : folded_) {
    if (!mesh_.isEdgeLeft(edge)) queue_.remove(edge);
  }
  mesh_.listNeighbours(to, ring_);
  look_.renew(to);
  for (const std::uint32_t v : ring_) look_.renew(v);
  renewAround(to, true);
  for (const std::uint32_t v : ring_) renewAround(v, false);
  if (queue_.empty()) offerRemoval();
}

/// The cost of an edge, and whether it may contract, depend on the triangles around its ends alone; its
/// places on their quadrics and, where it has `moved`, on where they stand.
void ComponentContractions::renewAround(std::uint32_t v, bool moved) {
  mesh_.forEachEdge(v, [&](std::uint32_t edge) {
    if (renewed_[edge] == operations_) return;
    renewed_[edge] = operations_;
    if (moved) place(edge);
    price(edge);
  });
}

void ComponentContractions::offerRemoval() {
  if (scope_.mayGo) queue_.set(edges_, mesh_.extent());
}

void ComponentContractions::removeWhole() {
  queue_.clear();
  waiting_.assign(edges_, {});
  mesh_.removeAll();
  ++operations_;
}

std::uint32_t ComponentContractions::heldByCharts() const {
  std::uint32_t count = 0;
  for (std::uint32_t e = 0; e < edges_; ++e)
    count += waiting_[e].heldByCharts && mesh_.isEdgeLeft(e) && !queue_.contains(e) ? 1 : 0;
  return count;
}

}  // namespace lodestone
