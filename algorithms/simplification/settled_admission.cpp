#include "algorithms/simplification/settled_admission.h"

#include <algorithm>
#include <set>
#include <utility>

#include "algorithms/perception/viewpoints.h"
#include "algorithms/rendering/model_rendering.h"
#include "algorithms/simplification/contacts.h"
#include "algorithms/simplification/simplification.h"

namespace lodestone {
namespace {

constexpr int kMostRounds = 8;

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

  [[nodiscard]] bool isNeeded() const { return !eyes_.empty() || !isSeen_.empty(); }
  [[nodiscard]] Admission take() { return std::move(admission_); }

  /// Whether nothing had to be taken back.
  bool tryOnce(const Progress& progress) {
    const Simplified level = simplify(mesh_, classes_, options_, progress.part(0, 0.5), admission_);
    const std::size_t before = admitted();
    if (!eyes_.empty()) holdWhatCameToLight(level, progress.part(0.5, 0.9));
    if (!isSeen_.empty()) holdWhatCameApart(level, progress.part(0.9, 1));
    return admitted() == before;
  }

 private:
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

  const ComponentMesh& mesh_;
  const Classification& classes_;
  const Perception& perception_;
  const SimplifyOptions& options_;
  Admission admission_;
  std::vector<Vec3> eyes_;    ///< empty where the unseen stay
  std::vector<bool> isSeen_;  ///< by component; empty where contacts do not count
};

}  // namespace

Admission settledAdmission(const ComponentMesh& mesh, const Classification& classes,
                           const Perception& perception, const SimplifyOptions& options,
                           const Progress& progress) {
  Settling settling(mesh, classes, perception, options);
  for (int round = 0; settling.isNeeded() && round < kMostRounds; ++round) {
    if (settling.tryOnce(progress.part(round / double{kMostRounds}, (round + 1) / double{kMostRounds})))
      break;
  }
  progress.report(1);
  return settling.take();
}

}  // namespace lodestone
