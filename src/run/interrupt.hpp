// Ctrl-C as a request to stop, not as an end in the middle of a step.
#pragma once

namespace softwet {

/// What a command says when it is asked to stop.
struct StopSentences {
  const char* first;   ///< of the first signal
  const char* second;  ///< of the one that ends it at once
};

/// From now on the first SIGINT, SIGTERM, SIGHUP (a closed terminal; not under nohup), SIGUSR1 (which a launcher of
/// several processes passes on) or SIGXCPU (the limit of processor time) only sets `stop_requested()`, and the first
/// process says so. Another one ends the program as usual, after a sentence; within a second of the first it is taken
/// for the same wish, because shells and launchers send it twice, and SIGXCPU, which the system repeats, ends nothing.
void hear_signals(const StopSentences&);

/// From now on the program goes on when nobody reads what it says any more.
void outlive_readers();

/// Whether this process has been asked to stop.
bool stop_requested();

}  // namespace softwet
