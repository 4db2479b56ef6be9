// What every benchmark measures with: time of the wall, time of the processor, memory.
#pragma once

#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

#include <malloc.h>

namespace lodestone {

/// Wall time of `work`, s.
double seconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Time of all threads together so far, s: what remains comparable on a machine that others use too.
inline double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Resident memory from /proc, in MiB: "VmRSS" now, "VmHWM" at most since resetPeak().
inline double memory(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(field + ":")) return std::stod(line.substr(field.size() + 1)) / 1024;
  }
  return 0;
}

/// Gives freed memory back first: what a former run left would hide what the next one takes.
inline void resetPeak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace lodestone
