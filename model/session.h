// The state of a project as an immutable value, and its history.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/artifacts.h"
#include "model/chain_options.h"
#include "model/import_options.h"
#include "model/perceive_options.h"
#include "model/sight_options.h"
#include "model/simplify_options.h"

namespace lodestone {

/// Where the drawn cut of the tree comes from.
enum class CutMode {
  Camera,     ///< ε, α and the camera that is looked through
  Weight,     ///< a height of the dendrogram
  Tolerance,  ///< metres of error, as a level of a chain has
  Original,   ///< no cut: every building itself
};
struct CutChoice {
  CutMode mode = CutMode::Camera;
  double value = 0;  ///< weight or metres
  bool operator==(const CutChoice&) const = default;
};

/// What a cluster tree was made with, beside the city. The same recipe makes the same tree again.
struct TreeRecipe {
  ClusterOptions clusterOptions;
  MergeOptions mergeOptions;
  std::vector<std::string> barriers;
  bool operator==(const TreeRecipe&) const = default;
};

/// Everything a project holds. Copies share the heavy parts; nothing in them is ever changed.
struct ProjectState {
  /// Which of the projects in a history this is a state of: “open instead” begins another, and undo comes
  /// back to the one before.
  std::uint32_t project = 0;
  std::vector<std::string> sources;  ///< absolute paths
  std::vector<std::string> barriers;
  ImportOptions importOptions;
  ClusterOptions clusterOptions;
  MergeOptions mergeOptions;
  ChainOptions chainOptions;  ///< of the drawn cut too
  CutChoice cutChoice;
  SimplifyOptions simplifyOptions;  ///< of the Simplification view
  /// What it is compared with there.
  SimplifyOptions comparedOptions{.method = SimplifyMethod::Qem};
  PerceiveOptions perceiveOptions;  ///< of the pictures there
  SightOptions sight;               ///< from where visibility is analysed there
  Camera camera;
  std::string looks;  ///< how layers look, JSON as the workbench keeps it; empty: as at first

  std::shared_ptr<const CityModel> city;
  std::shared_ptr<const ClusterTree> tree;  ///< of `city` with the options above; null until made
  std::vector<std::string> treeBarriers;    ///< the barriers that `tree` was made with
  /// Set where a tree belongs here that is not made yet: one that the history dropped to save memory, or that
  /// of a project just opened.
  std::optional<TreeRecipe> droppedTree;
};

/// History of states. Not thread-safe: it lives on the GUI thread; workers get a copy of the state.
/// Memory is bounded: at most kLongestHistory steps; their kKeptTrees trees nearest to the present, and of
/// farther ones the recipe; and the last kKeptCities cities, older steps being forgotten.
class Session {
 public:
  static constexpr std::size_t kLongestHistory = 200;
  static constexpr std::size_t kKeptTrees = 3;
  static constexpr std::size_t kKeptCities = 3;

  using Listener = std::function<void(const ProjectState& before, const ProjectState& after)>;

  [[nodiscard]] const ProjectState& state() const { return history_[position_].state; }
  /// Makes `next` the current state; what was undone is forgotten. Commits with the same non-empty `mergeKey`
  /// one after the other become one step (a slider being dragged); the saved state stays a step of its own.
  void commit(ProjectState next, std::string what, const std::string& mergeKey = {});
  /// Hands a tree that was made again to every step of `city` that dropped it: they hold the same recipe.
  /// Null, where it cannot be made: these steps have no tree from here on. No step of its own.
  void giveTree(const std::shared_ptr<const CityModel>& city, const TreeRecipe& recipe,
                const std::shared_ptr<const ClusterTree>& tree);
  /// Forgets the history: a new or loaded project.
  void reset(ProjectState state);

  [[nodiscard]] bool canUndo() const { return position_ > 0; }
  [[nodiscard]] bool canRedo() const { return position_ + 1 < history_.size(); }
  [[nodiscard]] const std::string& undoText() const { return history_[position_].what; }
  [[nodiscard]] const std::string& redoText() const { return history_[position_ + 1].what; }
  void undo();
  void redo();
  /// True when the state differs from the one last marked as saved of its project.
  [[nodiscard]] bool modified() const { return !history_[position_].saved; }
  void markSaved();
  void listen(Listener listener) { listeners_.push_back(std::move(listener)); }

 private:
  struct Step {
    ProjectState state;
    std::string what;
    std::string mergeKey;
    bool saved = false;  ///< at most one step of a project is
  };
  void moveTo(std::size_t position);
  void tellListeners(const ProjectState& before) const;
  void forgetOldest();
  void boundMemory();

  std::vector<Step> history_{Step{{}, {}, {}, true}};
  std::size_t position_ = 0;
  std::vector<Listener> listeners_;
};

}  // namespace lodestone
