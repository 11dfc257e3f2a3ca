#include "run/interrupt.hpp"

#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "field/ranks.hpp"

namespace softwet {
namespace {

constexpr long never = -1, same_wish = 1000;  // milliseconds

std::atomic<long> asked_at = never;
static_assert(std::atomic<long>::is_always_lock_free);  // a handler of signals may use it

StopSentences sentences{"", ""};
bool on_terminal = false;  ///< there the line of the progress is still open

// What follows is called in a handler: it may use write, clock_gettime and its like alone.

void tell(const char* sentence) {
  if (!ranks::root()) return;
  if (on_terminal && ::write(STDERR_FILENO, "\n", 1) < 0) return;
  if (::write(STDERR_FILENO, sentence, std::strlen(sentence)) < 0) return;
}

long now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1000 * static_cast<long>(time.tv_sec) + time.tv_nsec / 1000000;
}

extern "C" void request_stop(int signal) {
  const int kept = errno;
  long first = never;
  if (asked_at.compare_exchange_strong(first, now())) {
    tell(sentences.first);
  } else if (signal != SIGXCPU && now() - first > same_wish) {
    tell(sentences.second);
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // takes effect when this handler returns
  }
  errno = kept;
}

}  // namespace

void hear_signals(const StopSentences& chosen) {
  sentences = chosen;
  on_terminal = isatty(STDERR_FILENO) != 0;
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESTART;
  for (int signal : {SIGINT, SIGTERM, SIGUSR1, SIGXCPU}) sigaction(signal, &action, nullptr);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

void outlive_readers() { std::signal(SIGPIPE, SIG_IGN); }

bool stop_requested() { return asked_at != never; }

}  // namespace softwet
