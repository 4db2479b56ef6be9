#include "algorithms/simplification/settled_simplification.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "algorithms/perception/viewpoints.h"
#include "algorithms/rendering/model_rendering.h"
#include "algorithms/simplification/contacts.h"

namespace lodestone {
namespace {

class Settling {
 public:
  Settling(const ComponentMesh& mesh, const Classification& classes, const Perception& perception,
           const SimplifyOptions& options)
      : mesh_(mesh),
        classes_(classes),
        perception_(perception),
        options_(options),
        admission_(admissionOf(mesh, perception, options)) {
    if (options.unseen) eyes_ = closerViewpoints(bounds(mesh), perception.options);
    if (options.method == SimplifyMethod::Combined) isSeen_ = seenComponents(mesh, perception);
  }

  Settled run(const Progress& progress, int mostRounds) {
    for (int round = 0; round < mostRounds; ++round) {
      // Most models take one or two rounds, and nobody knows how many it will be.
      const Progress own = progress.part(1 - std::exp2(-round), 1 - std::exp2(-round - 1));
      const std::size_t before = admitted();
      Simplified level = simplified(own.part(0, 0.6));
      if (!eyes_.empty()) holdWhatCameToLight(level, own.part(0.6, 0.9));
      if (!isSeen_.empty()) holdWhatCameApart(level, own.part(0.9, 1));
      if (admitted() == before) return {std::move(level), std::move(admission_)};
    }
    holdAllInQuestion();
    Simplified level = simplified(Progress({}, progress.stopToken()));
    return {std::move(level), std::move(admission_)};
  }

 private:
  [[nodiscard]] Simplified simplified(const Progress& progress) const {
    return simplify(mesh_, classes_, options_, progress, admission_);
  }

  [[nodiscard]] std::size_t admitted() const {
    return static_cast<std::size_t>(
        std::count(admission_.triangles.begin(), admission_.triangles.end(), true));
  }

  /// Triangles that nobody saw of the original, and that are in sight now.
  void holdWhatCameToLight(const Simplified& level, const Progress& progress) {
    std::vector<bool> hidden(level.triangle.size());
    for (std::size_t t = 0; t < hidden.size(); ++t) hidden[t] = !perception_.isSeen(level.triangle[t]);
    const std::vector<bool> visible = ModelRenderer(level.mesh, nullptr).visibleFrom(eyes_, hidden, progress);
    for (std::size_t t = 0; t < visible.size(); ++t) {
      if (visible[t]) admission_.triangles[level.triangle[t]] = false;
    }
  }

  void holdWhatCameApart(const Simplified& level, const Progress& progress) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> apart;
    for (const ContactReport& contact : followContacts(mesh_, classes_, level, progress)) {
      if (contact.fate == ContactFate::Separated && isSeen_[contact.first] && isSeen_[contact.second])
        apart.emplace_back(contact.first, contact.second);
    }
    std::vector<bool> held(mesh_.vertexCount(), false);
    for (const BoundaryEdge& edge : classes_.edges) {
      const std::uint32_t own = componentOfVertex(mesh_, edge.from);
      if (!std::binary_search(apart.begin(), apart.end(), std::minmax({own, edge.other}))) continue;
      held[edge.from] = held[edge.to] = true;
      for (const std::uint32_t t : edge.triangles) {
        for (const std::uint32_t v : mesh_.triangles[t]) held[v] = true;
      }
    }
    std::set<std::uint32_t> components;
    for (const auto& [a, b] : apart) components.insert({a, b});
    for (const std::uint32_t c : components) holdComponent(c, held);
  }

  /// Its triangles at vertices that are `held`; all of them where these were held before.
  void holdComponent(std::uint32_t c, const std::vector<bool>& held) {
    const auto isAtHeld = [&](std::uint32_t t) {
      const ComponentMesh::Triangle& triangle = mesh_.triangles[t];
      return std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) { return held[v]; });
    };
    if (hold(mesh_.components[c], isAtHeld) == 0)
      hold(mesh_.components[c], [](std::uint32_t) { return true; });
  }

  /// How many of the admitted triangles that are `wanted` are so no longer.
  template <class Wanted>
  std::uint32_t hold(const Component& component, const Wanted& wanted) {
    std::uint32_t count = 0;
    for (std::uint32_t t = component.firstTriangle; t < component.endTriangle(); ++t) {
      if (!admission_.admits(t) || !wanted(t)) continue;
      admission_.triangles[t] = false;
      ++count;
    }
    return count;
  }

  /// What nobody sees, and all that touches.
  void holdAllInQuestion() {
    for (std::size_t t = 0; t < admission_.triangles.size() && !eyes_.empty(); ++t) {
      if (!perception_.isSeen(t)) admission_.triangles[t] = false;
    }
    if (isSeen_.empty()) return;
    for (const auto& [a, b] : classes_.contacts) {
      if (!isSeen_[a] || !isSeen_[b]) continue;
      for (const std::uint32_t c : {a, b}) hold(mesh_.components[c], [](std::uint32_t) { return true; });
    }
  }

  const ComponentMesh& mesh_;
  const Classification& classes_;
  const Perception& perception_;
  const SimplifyOptions& options_;
  Admission admission_;
  std::vector<Vec3> eyes_;    ///< empty where the unseen stay
  std::vector<bool> isSeen_;  ///< by component; empty where contacts do not count
};

}  // namespace

Settled simplifySettled(const ComponentMesh& mesh, const Classification& classes,
                        const Perception& perception, const SimplifyOptions& options,
                        const Progress& progress, int mostRounds) {
  Settled settled = Settling(mesh, classes, perception, options).run(progress, mostRounds);
  progress.report(1);
  return settled;
}

}  // namespace lodestone
