#include "model/session.h"

namespace lodestone {
namespace {
constexpr std::size_t kLongestHistory = 200;
}

void Session::tellListeners(const ProjectState& before) const {
  for (const Listener& listener : listeners_) listener(before, state());
}

void Session::commit(ProjectState next, std::string what, const std::string& mergeKey) {
  const ProjectState before = state();
  if (savedPosition_ != kNowhere && savedPosition_ > position_) savedPosition_ = kNowhere;
  history_.resize(position_ + 1);
  const bool merges = !mergeKey.empty() && history_.back().mergeKey == mergeKey && position_ > 0;
  if (merges) {
    history_.back().state = std::move(next);
    if (savedPosition_ == position_) savedPosition_ = kNowhere;
  } else {
    history_.push_back({std::move(next), std::move(what), mergeKey});
    ++position_;
  }
  if (history_.size() > kLongestHistory) {
    history_.erase(history_.begin());
    --position_;
    savedPosition_ = savedPosition_ == kNowhere || savedPosition_ == 0 ? kNowhere : savedPosition_ - 1;
  }
  tellListeners(before);
}

void Session::amend(ProjectState next) {
  const ProjectState before = state();
  history_[position_].state = std::move(next);
  tellListeners(before);
}

void Session::reset(ProjectState next) {
  const ProjectState before = state();
  history_.assign(1, Step{std::move(next), {}, {}});
  position_ = 0;
  savedPosition_ = 0;
  tellListeners(before);
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
