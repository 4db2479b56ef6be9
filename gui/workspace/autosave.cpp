#include "gui/workspace/autosave.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>

namespace lodestone {
namespace {
constexpr int kIntervalMs = 30'000;
QString lockOf(const QString& path) {
  return path + QStringLiteral(".lock");
}
}  // namespace

Autosave::Autosave(const QString& folder, std::function<bool()> wanted,
                   std::function<bool(const QString&)> save, QObject* parent)
    : QObject(parent), folder_(folder), wanted_(std::move(wanted)), save_(std::move(save)) {
  QDir().mkpath(folder_);
  path_ = QDir(folder_).filePath(QStringLiteral("autosave-%1-%2.lodestone")
                                     .arg(QCoreApplication::applicationPid())
                                     .arg(QDateTime::currentMSecsSinceEpoch()));
  lock_ = std::make_unique<QLockFile>(lockOf(path_));
  lock_->setStaleLockTime(0);
  lock_->tryLock(0);
  timer_.setInterval(kIntervalMs);
  connect(&timer_, &QTimer::timeout, this, &Autosave::saveNow);
  timer_.start();
}

Autosave::~Autosave() {
  forget();
}

bool Autosave::saveNow() {
  if (wanted_()) return save_(path_);
  forget();
  return false;
}

void Autosave::forget() {
  QFile::remove(path_);
}

std::optional<QString> Autosave::leftBehind() const {
  const QDir folder(folder_);
  const QStringList files =
      folder.entryList({QStringLiteral("autosave-*.lodestone")}, QDir::Files, QDir::Time);
  for (const QString& name : files) {
    const QString path = folder.filePath(name);
    if (path == path_) continue;
    QLockFile other(lockOf(path));
    other.setStaleLockTime(0);
    if (other.tryLock(0)) return path;  // released again here: its owner is gone
  }
  return std::nullopt;
}

void Autosave::discard(const QString& path) {
  QFile::remove(path);
}

}  // namespace lodestone
