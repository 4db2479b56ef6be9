// Unsaved work kept aside while the program runs, and offered back when it did not end well.
#pragma once

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

namespace lodestone {

/// One file for each running program, held by a lock; a file whose lock nobody holds was left by a crash.
class Autosave : public QObject {
  Q_OBJECT

 public:
  /// `wanted()` says whether there is unsaved work, `save(path)` writes it and says whether it could.
  Autosave(const QString& folder, std::function<bool()> wanted, std::function<bool(const QString&)> save,
           QObject* parent = nullptr);
  /// A clean end: nothing is left behind.
  ~Autosave() override;

  /// Work that a crashed program left, taken over: the caller opens it or discards it.
  [[nodiscard]] std::optional<QString> leftBehind() const;
  static void discard(const QString& path);
  /// Whether the work is kept: one that cannot be written leaves what was kept before.
  bool saveNow();
  void forget();

 private:
  QString folder_;
  QString path_;
  std::unique_ptr<QLockFile> lock_;
  std::function<bool()> wanted_;
  std::function<bool(const QString&)> save_;
  QTimer timer_;
};

}  // namespace lodestone
