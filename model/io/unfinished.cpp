#include "model/io/unfinished.h"

#include <mutex>
#include <set>
#include <utility>

namespace lodestone {
namespace fs = std::filesystem;
namespace {

struct Register {
  std::mutex mutex;
  std::set<fs::path> paths;
};

/// Never destroyed: worker threads may outlive main().
Register& all() {
  static auto* const instance = new Register;
  return *instance;
}

void removeQuietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

}  // namespace

Unfinished::Unfinished(fs::path path) : path_(std::move(path)) {
  const std::scoped_lock lock(all().mutex);
  all().paths.insert(path_);
}

Unfinished::~Unfinished() {
  removeQuietly(path_);
  const std::scoped_lock lock(all().mutex);
  all().paths.erase(path_);
}

void removeAllUnfinished() {
  all().mutex.lock();
  for (const fs::path& path : all().paths) removeQuietly(path);
}

}  // namespace lodestone
