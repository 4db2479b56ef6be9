// Ctrl-C and SIGTERM as a stop token.
#pragma once

#include <stop_token>
#include <thread>

namespace lodestone::cli {

/// Blocks the two signals in this thread and all it starts later, and waits for them in a thread of its own,
/// since little may be done in a signal handler. A second signal ends the process at once; half-written files
/// go with it.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread waiter_;
};

}  // namespace lodestone::cli
