#include "field/ranks.hpp"

#include <cstdlib>
#include <cstring>

#ifdef SOFTWET_HAVE_MPI
#include <mpi.h>

#include <chrono>
#include <thread>
#endif

namespace softwet {
namespace {

int my_rank = 0, all_ranks = 1;
Traffic told;

}  // namespace

namespace ranks {

int mine() { return my_rank; }
int count() { return all_ranks; }
const Traffic& traffic() { return told; }

}  // namespace ranks

#ifdef SOFTWET_HAVE_MPI

namespace {

constexpr double patience = 2;  ///< seconds, for processes that may be at their end too

MPI_Comm endings = MPI_COMM_NULL;  ///< for `all_end`, whatever else is still on its way

/// A program that no launcher has started computes alone, without waking MPI.
bool launched() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "MPI_LOCALRANKID"})
    if (std::getenv(name)) return true;
  return false;
}

double reduced(double number, MPI_Op operation) {
  if (all_ranks == 1) return number;
  ++told.reductions;
  MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_DOUBLE, operation, MPI_COMM_WORLD);
  return number;
}

/// Where the part of each process begins among all.
std::vector<int> begins(const std::vector<int>& bytes) {
  std::vector<int> begin(bytes.size(), 0);
  for (std::size_t r = 1; r < bytes.size(); ++r) begin[r] = begin[r - 1] + bytes[r - 1];
  return begin;
}

}  // namespace

Job::Job(int& argc, char**& argv) {
  if (!launched()) return;
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &my_rank);
  MPI_Comm_size(MPI_COMM_WORLD, &all_ranks);
  MPI_Comm_dup(MPI_COMM_WORLD, &endings);
}

Job::~Job() {
  int begun = 0, ended = 0;
  MPI_Initialized(&begun);
  MPI_Finalized(&ended);
  if (begun && !ended) MPI_Finalize();
}

namespace ranks {

bool has_mpi() { return true; }

void add(double* numbers, int count) {
  if (all_ranks == 1) return;
  ++told.reductions;
  MPI_Allreduce(MPI_IN_PLACE, numbers, count, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}
double largest(double number) { return reduced(number, MPI_MAX); }
double least(double number) { return reduced(number, MPI_MIN); }
void largest(double* numbers, int count) {
  if (all_ranks == 1) return;
  ++told.reductions;
  MPI_Allreduce(MPI_IN_PLACE, numbers, count, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
}
double of_root(double number) {
  share(&number, sizeof number, 0);
  return number;
}
void share(void* data, std::size_t bytes, int from) {
  if (all_ranks > 1) MPI_Bcast(data, static_cast<int>(bytes), MPI_BYTE, from, MPI_COMM_WORLD);
}

void exchange(const std::vector<Message>& messages) {
  if (all_ranks == 1) return;
  std::vector<MPI_Request> requests(2 * messages.size());
  std::size_t next = 0;
  for (const Message& m : messages)
    MPI_Irecv(m.receive, static_cast<int>(m.receive_bytes), MPI_BYTE, m.rank, 0, MPI_COMM_WORLD, &requests[next++]);
  for (const Message& m : messages) {
    MPI_Isend(m.send, static_cast<int>(m.send_bytes), MPI_BYTE, m.rank, 0, MPI_COMM_WORLD, &requests[next++]);
    ++told.messages;
    told.bytes += static_cast<double>(m.send_bytes);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

void gather(const void* part, const std::vector<int>& bytes, void* all) {
  const std::vector<int> begin = begins(bytes);
  ++told.collections;
  told.collected += static_cast<double>(begin.back()) + bytes.back();
  MPI_Allgatherv(part, bytes[my_rank], MPI_BYTE, all, bytes.data(), begin.data(), MPI_BYTE, MPI_COMM_WORLD);
}

void gather_on_root(const void* part, const std::vector<int>& bytes, void* all) {
  const std::vector<int> begin = begins(bytes);
  ++told.collections;
  if (root()) told.collected += static_cast<double>(begin.back()) + bytes.back();
  MPI_Gatherv(part, bytes[my_rank], MPI_BYTE, all, bytes.data(), begin.data(), MPI_BYTE, 0, MPI_COMM_WORLD);
}

bool all_end() {
  if (all_ranks == 1) return true;
  MPI_Request request;
  MPI_Ibarrier(endings, &request);
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) return true;
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > patience) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void abort(int code) {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::_Exit(code);
}

}  // namespace ranks

#else

Job::Job(int&, char**&) {}
Job::~Job() = default;

namespace ranks {

bool has_mpi() { return false; }
void add(double*, int) {}
double largest(double number) { return number; }
double least(double number) { return number; }
void largest(double*, int) {}
double of_root(double number) { return number; }
void share(void*, std::size_t, int) {}
void exchange(const std::vector<Message>&) {}
void gather(const void* part, const std::vector<int>& bytes, void* all) { std::memcpy(all, part, bytes[0]); }
void gather_on_root(const void* part, const std::vector<int>& bytes, void* all) { gather(part, bytes, all); }
bool all_end() { return true; }
void abort(int code) { std::_Exit(code); }

}  // namespace ranks

#endif

}  // namespace softwet
