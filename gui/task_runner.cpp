#include "gui/task_runner.h"

#include <algorithm>
#include <exception>

namespace lodestone {

TaskRunner::TaskRunner(QObject* parent) : QObject(parent) {}

TaskRunner::~TaskRunner() {
  for (Task& task : tasks_) task.thread.request_stop();
  tasks_.clear();  // joins
}

void TaskRunner::launch(const QString& key, const QString& title,
                        std::function<Commit(const Progress&)> job) {
  for (Task& task : tasks_) {
    if (task.key != key) continue;
    task.stale = true;
    task.thread.request_stop();
  }
  tasks_.push_back({key, title, false, {}});
  const auto task = std::prev(tasks_.end());
  Q_EMIT started(key, title);
  task->thread = std::jthread([this, task, title, job = std::move(job)](const std::stop_token& stop) {
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
  const bool stopped = task->thread.get_stop_token().stop_requested();
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
  if (tasks_.empty()) Q_EMIT idle();
}

void TaskRunner::cancel(const QString& key) {
  for (Task& task : tasks_) {
    if (task.key == key) task.thread.request_stop();
  }
}

void TaskRunner::cancelAll() {
  for (Task& task : tasks_) task.thread.request_stop();
}

bool TaskRunner::busy() const {
  return !tasks_.empty();
}

bool TaskRunner::busy(const QString& key) const {
  return std::any_of(tasks_.begin(), tasks_.end(),
                     [&](const Task& task) { return task.key == key && !task.stale; });
}

}  // namespace lodestone
