// Ctrl-C as a wish to stop, not as an end in the middle of a step.
#pragma once

namespace softwet {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP (a closed terminal; not under nohup) only sets
/// `requested()`; a second one ends the program as usual. A run also goes on when nobody reads its progress any more.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  static bool requested();

 private:
  bool hangup_ = false;  ///< SIGHUP is heard
};

}  // namespace softwet
