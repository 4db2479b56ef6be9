#include "model/session.h"

#include <algorithm>

namespace lodestone {
namespace {

/// Adds what is not there yet; says whether the collection holds it afterwards, within its limit.
template <class T>
bool admit(std::vector<const T*>& kept, const std::shared_ptr<const T>& item, std::size_t limit) {
  if (!item || std::find(kept.begin(), kept.end(), item.get()) != kept.end()) return true;
  if (kept.size() == limit) return false;
  kept.push_back(item.get());
  return true;
}

void dropTree(ProjectState& state) {
  state.droppedTree = TreeRecipe{state.tree->dendrogram->options, state.tree->options, state.treeBarriers};
  state.tree.reset();
}

}  // namespace

void Session::tellListeners(const ProjectState& before) const {
  for (const Listener& listener : listeners_) listener(before, state());
}

void Session::commit(ProjectState next, std::string what, const std::string& mergeKey) {
  const ProjectState before = state();
  history_.resize(position_ + 1);
  const bool merges =
      !mergeKey.empty() && history_.back().mergeKey == mergeKey && position_ > 0 && !history_.back().saved;
  if (merges) {
    history_.back().state = std::move(next);
  } else {
    history_.push_back({std::move(next), std::move(what), mergeKey, false});
    ++position_;
  }
  boundMemory();
  tellListeners(before);
}

void Session::forgetOldest() {
  history_.erase(history_.begin());
  --position_;
}

void Session::boundMemory() {
  while (history_.size() > kLongestHistory) forgetOldest();
  std::vector<const CityModel*> cities;
  std::size_t first = history_.size();
  while (first > 0 && admit(cities, history_[first - 1].state.city, kKeptCities)) --first;
  while (first-- > 0 && position_ > 0) forgetOldest();

  std::vector<const ClusterTree*> trees;
  for (std::size_t away = 0; away < history_.size(); ++away) {
    for (const std::size_t at : {position_ - away, position_ + away}) {  // what wraps around is no step
      if (at < history_.size() && !admit(trees, history_[at].state.tree, kKeptTrees))
        dropTree(history_[at].state);
    }
  }
}

void Session::giveTree(const std::shared_ptr<const CityModel>& city, const TreeRecipe& recipe,
                       const std::shared_ptr<const ClusterTree>& tree) {
  const ProjectState before = state();
  for (Step& step : history_) {
    if (step.state.city != city || step.state.droppedTree != recipe) continue;
    step.state.tree = tree;
    step.state.treeBarriers = recipe.barriers;
    step.state.droppedTree.reset();
  }
  boundMemory();
  tellListeners(before);
}

void Session::reset(ProjectState next) {
  const ProjectState before = state();
  history_.assign(1, Step{std::move(next), {}, {}, true});
  position_ = 0;
  tellListeners(before);
}

void Session::markSaved() {
  for (Step& step : history_) {
    if (step.state.project == state().project) step.saved = false;
  }
  history_[position_].saved = true;
}

void Session::moveTo(std::size_t position) {
  const ProjectState before = state();
  position_ = position;
  history_[position_].mergeKey.clear();
  tellListeners(before);
}

void Session::undo() {
  if (canUndo()) moveTo(position_ - 1);
}

void Session::redo() {
  if (canRedo()) moveTo(position_ + 1);
}

}  // namespace lodestone
