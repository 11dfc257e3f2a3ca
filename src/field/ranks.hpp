// The processes that compute a scene together, and what they tell each other. Without MPI there is one.
#pragma once

#include <cstddef>
#include <vector>

namespace softwet {

/// Joins the other processes of the job, where a launcher of MPI has started this one. Leaves them with its scope.
class Job {
 public:
  Job(int& argc, char**& argv);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job();
};

/// What the processes have told each other since the start; of this process.
struct Traffic {
  long messages = 0, reductions = 0, collections = 0;
  double bytes = 0;      ///< sent to neighbours
  double collected = 0;  ///< bytes of what all processes have collected
};

namespace ranks {

int mine();
int count();
inline bool root() { return mine() == 0; }
bool has_mpi();  ///< of this build
const Traffic& traffic();

/// Adds up numbers over all processes. Exact where all but one process have zeros, whatever the order.
void add(double* numbers, int count);
double largest(double);
double least(double);
/// The number that the first process has.
double of_root(double);

/// What is sent to a process and received from it.
struct Message {
  int rank;
  const void* send;
  std::size_t send_bytes;
  void* receive;
  std::size_t receive_bytes;
};
void exchange(const std::vector<Message>&);

/// Collects the parts of all processes, one after the other; `bytes` of each.
void gather(const void* part, const std::vector<int>& bytes, void* all);

/// Waits a little while until all processes are at their end. False: some are not, for they have not heard of a failure.
bool all_end();
/// Ends all processes at once, with this exit code.
[[noreturn]] void abort(int code);

}  // namespace ranks
}  // namespace softwet
