#include "app/interrupt.hpp"

#include <csignal>

namespace softwet {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

extern "C" void request_stop(int signal) {
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  stop_requested = 0;
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  hangup_ = std::signal(SIGHUP, SIG_IGN) != SIG_IGN;
  if (hangup_) std::signal(SIGHUP, request_stop);
  std::signal(SIGUSR1, request_stop);  // what a launcher of several processes passes on
  std::signal(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGUSR1, SIG_DFL);
  if (hangup_) std::signal(SIGHUP, SIG_DFL);
  std::signal(SIGPIPE, SIG_DFL);
}

bool InterruptGuard::requested() { return stop_requested != 0; }

}  // namespace softwet
