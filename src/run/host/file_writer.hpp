// Files that are written while the next steps run.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <system_error>
#include <utility>

namespace softwet {

/// When files are written: while the computation waits for them, or by a thread beside the next steps.
enum class Writes { in_turn, beside_steps };

/// Writes files, one task after the other. A task owns what it writes. HDF5 is not made for several threads, so that
/// whoever opens a file of it waits before; so does whoever needs the files.
/// Tested: tests/unit/run/host/test_file_writer.cpp
class FileWriter {
 public:
  /// @param enter  called first in each thread
  explicit FileWriter(Writes when, std::function<void()> enter = {}) : when_(when), enter_(std::move(enter)) {}
  FileWriter(const FileWriter&) = delete;
  /// Ends when the last task has. What that has thrown is lost here: who wants to know waits before.
  ~FileWriter() = default;

  /// Waits for the task before, and throws what that has thrown. Then runs this one, or starts it.
  void start(std::function<void()> task) {
    wait();
    if (when_ == Writes::in_turn) return task();
    try {
      running_ = std::async(std::launch::async, [enter = enter_, task] {
        if (enter) enter();
        return seconds_of(task);
      });
    } catch (const std::system_error&) {  // the machine has no thread left
      task();
    }
  }
  /// Whether a task was started that nobody has waited for.
  bool running() const { return running_.valid(); }
  /// Waits for the last task, and throws what it has thrown, once.
  /// @return  the seconds that it has taken; 0 where none was running
  double wait() { return running_.valid() ? running_.get() : 0; }

 private:
  static double seconds_of(const std::function<void()>& task) {
    const auto start = std::chrono::steady_clock::now();
    task();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Writes when_;
  std::function<void()> enter_;
  std::future<double> running_;  ///< its end waits for the thread
};

}  // namespace softwet
