// How the threads of a computation wait for each other.
#pragma once

namespace softwet {

/// Starts this program again with GOMP_SPINCOUNT = 3000, unless the user has set that variable or OMP_WAIT_POLICY. It
/// returns where that is not needed, or not possible.
///
/// Between two kernels threads wait for microseconds, so they look again and again before they sleep. The OpenMP runtime of
/// GCC looks 300000 times, which takes milliseconds: on a machine that others use too, a thread then holds its core to the
/// end of its turn while it waits for a thread that has none. With this number of looks it sleeps after some thirty
/// microseconds. The runtime reads the variable when it is loaded, which is before main, so that the program has to begin
/// again. docs/development/performance.md has what was measured. Tested: tests/regression/waiting.py
void choose_waiting(char** argv);

}  // namespace softwet
