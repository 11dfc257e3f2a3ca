// Ctrl-C as a wish to stop, not as an end in the middle of a step.
#pragma once

namespace softwet {

/// From now on the first SIGINT, SIGTERM, SIGHUP (a closed terminal; not under nohup), SIGUSR1 (which a launcher of
/// several processes passes on) or SIGXCPU (the limit of processor time) only sets `stop_requested()`, and the first
/// process says so. Another one ends the program as usual, after a sentence; within a second of the first it is taken
/// for the same wish, because shells and launchers send it twice, and SIGXCPU, which the system repeats, ends nothing.
/// A run also goes on when nobody reads its progress any more.
void hear_signals();

/// Whether this process has been asked to stop.
bool stop_requested();

}  // namespace softwet
