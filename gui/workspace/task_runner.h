// Long computations off the GUI thread: progress, cancel, and results that come back to it.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <list>
#include <memory>
#include <stop_token>
#include <thread>

#include "model/diagnostics.h"
#include "model/progress.h"

namespace lodestone {

/// Runs each piece of work on a thread of its own and commits its result on the GUI thread. Of several tasks
/// started with one key only the last one counts: starting it stops the one before, whose result is dropped;
/// those enqueued run one after the other instead. A cancelled task commits nothing. Cancelled, and every
/// other exception of a worker, is caught here and nowhere else.
class TaskRunner : public QObject {
  Q_OBJECT

 public:
  explicit TaskRunner(QObject* parent = nullptr);
  /// Stops all work and waits for it.
  ~TaskRunner() override;

  /// `work(progress)` runs on a worker thread and must touch nothing that changes; `done(result)` runs here.
  template <class Work, class Done>
  void start(const QString& key, const QString& title, Work work, Done done) {
    stopAll(key);
    add(key, title, jobOf(std::move(work), std::move(done)));
  }
  /// The same, after all earlier tasks with this key: none of them is stopped.
  template <class Work, class Done>
  void enqueue(const QString& key, const QString& title, Work work, Done done) {
    add(key, title, jobOf(std::move(work), std::move(done)));
  }
  /// start() for what belongs to something that is committed already, such as its picture: people cannot
  /// cancel it.
  template <class Work, class Done>
  void complete(const QString& key, const QString& title, Work work, Done done) {
    stopAll(key);
    add(key, title, jobOf(std::move(work), std::move(done)), true);
  }
  /// Asks the task, and those that wait behind it, to stop; finished() follows when they have.
  void cancel(const QString& key);
  void cancelAll();

  [[nodiscard]] bool busy() const;
  [[nodiscard]] bool busy(const QString& key) const;

 Q_SIGNALS:
  void started(const QString& key, const QString& title);
  void progressed(const QString& title, double done, const QString& stage);
  /// The last of all running tasks has ended.
  void idle();
  /// After the result was committed, or when there is none (`committed` false: cancelled or failed).
  void finished(const QString& key, bool committed);
  void diagnosed(const lodestone::Diagnostics& diagnostics);

 private:
  using Commit = std::function<void()>;
  using Job = std::function<Commit(const Progress&)>;
  struct Task {
    QString key;
    QString title;
    Job job;
    std::jthread thread;  ///< not running while the task waits for its turn
    bool stale = false;   ///< another task with its key took its place
    bool cancelled = false;
    bool completes = false;  ///< something that is committed: not to be cancelled
  };

  template <class Work, class Done>
  static Job jobOf(Work work, Done done) {
    return [work = std::move(work), done = std::move(done)](const Progress& progress) -> Commit {
      auto result = std::make_shared<decltype(work(progress))>(work(progress));
      return [result, done] { done(std::move(*result)); };
    };
  }
  void add(const QString& key, const QString& title, Job job, bool completes = false);
  void run(std::list<Task>::iterator task);
  void runNext(const QString& key);
  void stopAll(const QString& key);
  static void stop(Task& task);
  void finish(std::list<Task>::iterator task, const Commit& commit, const Diagnostics& diagnostics);

  std::list<Task> tasks_;
};

}  // namespace lodestone
