// Why an output could not be written.
#pragma once

#include <filesystem>
#include <system_error>

#include "model/diagnostics.h"

namespace lodestone {

/// OutputDiskFull or OutputUnwritable.
[[nodiscard]] inline Diagnostic outputFailure(const std::system_error& error,
                                              const std::filesystem::path& place = {}) {
  const bool full = error.code() == std::errc::no_space_on_device;
  return diagnose(full ? Code::OutputDiskFull : Code::OutputUnwritable, error.what(), {}, place.string());
}

}  // namespace lodestone
