// The processes that compute a scene together, and what they send each other. Without MPI there is one.
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

/// What the processes have sent each other since the start; of this process.
struct Traffic {
  long messages = 0, reductions = 0, collections = 0;
  double bytes = 0;      ///< sent to neighbours
  double collected = 0;  ///< bytes of what all processes have collected, or this one alone
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
/// Replaces each number by the largest number that any process has in its place.
void largest(double* numbers, int count);
/// The number that the first process has.
double of_root(double);
/// What the process `from` has in these bytes becomes what all have.
void share(void* data, std::size_t bytes, int from);
/// The text or the list that the process `from` has, however long.
template <class List>
List shared(List list, int from = 0) {
  double length = static_cast<double>(list.size());
  share(&length, sizeof length, from);
  list.resize(static_cast<std::size_t>(length));
  share(list.data(), list.size() * sizeof(list[0]), from);
  return list;
}

/// Data sent to a process, and data received from it.
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
/// Collects the parts on the first process alone; `all` has no meaning on the others.
void gather_on_root(const void* part, const std::vector<int>& bytes, void* all);

/// Waits a little while until all processes are at their end. False: some are not, for they have not heard of a
/// failure.
bool all_end();
/// Ends all processes at once, with this exit code.
[[noreturn]] void abort(int code);

}  // namespace ranks
}  // namespace softwet
