#include "gui/workspace/task_runner.h"

#include <algorithm>
#include <exception>

namespace lodestone {

TaskRunner::TaskRunner(QObject* parent) : QObject(parent) {}

TaskRunner::~TaskRunner() {
  for (Task& task : tasks_) stop(task);
  tasks_.clear();  // joins
}

void TaskRunner::stop(Task& task) {
  task.cancelled = true;
  task.thread.request_stop();
}

void TaskRunner::stopAll(const QString& key) {
  for (Task& task : tasks_) {
    if (task.key != key) continue;
    task.stale = true;
    stop(task);
  }
}

void TaskRunner::add(const QString& key, const QString& title, Job job, bool completes) {
  const bool waits = busy(key);
  tasks_.push_back({key, title, std::move(job), {}, false, false, completes});
  if (!waits) run(std::prev(tasks_.end()));
}

void TaskRunner::runNext(const QString& key) {
  const bool busyWithIt = std::any_of(tasks_.begin(), tasks_.end(), [&](const Task& task) {
    return task.key == key && !task.stale && task.thread.joinable();
  });
  if (busyWithIt) return;
  const auto next = std::find_if(tasks_.begin(), tasks_.end(), [&](const Task& task) {
    return task.key == key && !task.thread.joinable();
  });
  if (next != tasks_.end()) run(next);
}

void TaskRunner::run(std::list<Task>::iterator task) {
  Q_EMIT started(task->key, task->title);
  // A task that was cancelled while it waited still ends the way all do, without having begun.
  const Job job = task->cancelled ? [](const Progress&) -> Commit { throw Cancelled(); } : task->job;
  task->thread = std::jthread([this, task, title = task->title, job](const std::stop_token& stop) {
    const Progress progress(
        [this, title](double done, const std::string& stage) {
          QMetaObject::invokeMethod(
              this,
              [this, title, done, text = QString::fromStdString(stage)] {
                Q_EMIT progressed(title, done, text);
              },
              Qt::QueuedConnection);
        },
        stop);
    Commit commit;
    Diagnostics diagnostics;
    try {
      commit = job(progress);
    } catch (const Cancelled&) {
      diagnostics.push_back(diagnose(Code::Cancelled, title.toStdString()));
    } catch (const std::exception& error) {
      diagnostics.push_back(diagnose(Code::Internal, error.what()));
    }
    QMetaObject::invokeMethod(
        this, [this, task, commit, diagnostics] { finish(task, commit, diagnostics); }, Qt::QueuedConnection);
  });
}

void TaskRunner::finish(std::list<Task>::iterator task, const Commit& commit,
                        const Diagnostics& diagnostics) {
  const QString key = task->key;
  const bool stopped = task->cancelled;
  const bool stale = task->stale;
  task->thread.join();
  tasks_.erase(task);
  const bool commits = commit && !stopped;
  if (commits) commit();
  if (!stale) {
    Diagnostics said = diagnostics;
    if (stopped && said.empty()) said.push_back(diagnose(Code::Cancelled));
    if (!said.empty()) Q_EMIT diagnosed(said);
    Q_EMIT finished(key, commits);
  }
  runNext(key);
  if (tasks_.empty()) Q_EMIT idle();
}

void TaskRunner::cancel(const QString& key) {
  for (Task& task : tasks_) {
    if (task.key == key) stop(task);
  }
}

void TaskRunner::cancelAll() {
  for (Task& task : tasks_) {
    if (!task.completes) stop(task);
  }
}

bool TaskRunner::busy() const {
  return !tasks_.empty();
}

bool TaskRunner::busy(const QString& key) const {
  return std::any_of(tasks_.begin(), tasks_.end(),
                     [&](const Task& task) { return task.key == key && !task.stale; });
}

}  // namespace lodestone
