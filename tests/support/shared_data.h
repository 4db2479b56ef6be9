// Real data that is not part of the repository: tests that use it skip, visibly, where it is absent.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace lodestone::test {

/// Folder of the shared data: $LODESTONE_SHARED, else ../shared beside the sources.
inline std::filesystem::path sharedRoot() {
  if (const char* given = std::getenv("LODESTONE_SHARED")) return given;
  return LODESTONE_SHARED_DATA;
}

/// Path below the shared "data" folder; empty when it is not there.
inline std::filesystem::path sharedData(const std::string& relative) {
  const std::filesystem::path path = sharedRoot() / "data" / relative;
  return std::filesystem::exists(path) ? path : std::filesystem::path();
}

}  // namespace lodestone::test
