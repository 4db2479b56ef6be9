#include "cli/interrupt.h"

#include <csignal>
#include <cstdlib>
#include <ctime>

#include "model/io/unfinished.h"

namespace lodestone::cli {
namespace {

sigset_t handledSignals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

void waitForSignals(const std::stop_token& ended, std::stop_source stop) {
  const sigset_t set = handledSignals();
  constexpr timespec kPatience{0, 50'000'000};
  while (!ended.stop_requested()) {
    const int signal = sigtimedwait(&set, nullptr, &kPatience);
    if (signal < 0) continue;
    if (stop.stop_requested()) {
      removeAllUnfinished();
      std::_Exit(128 + signal);
    }
    stop.request_stop();
  }
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = handledSignals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ = std::jthread([stop = source_](const std::stop_token& ended) { waitForSignals(ended, stop); });
}

Interrupt::~Interrupt() = default;

}  // namespace lodestone::cli
