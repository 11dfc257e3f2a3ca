#include "field/together.hpp"

#include <new>
#include <string>

#include "case/error.hpp"
#include "field/ranks.hpp"

namespace softwet {
namespace {

/// What became of the work of this process.
struct Outcome {
  Exit code = Exit::done;
  std::string problem;
};

Outcome outcome_of(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const Error& error) {
    return {error.code(), error.what()};
  } catch (const std::bad_alloc&) {
    return {Exit::machine_failed, "out of memory; 'softwet check CASE' shows how much a case needs"};
  } catch (const std::exception& error) {
    return {Exit::machine_failed, error.what()};
  }
}

}  // namespace

void together(const std::function<void()>& work) {
  if (ranks::count() == 1) return work();
  const Outcome mine = outcome_of(work);
  const int failed = static_cast<int>(ranks::least(mine.code == Exit::done ? ranks::count() : ranks::mine()));
  if (failed == ranks::count()) return;
  double code = static_cast<double>(mine.code);
  ranks::share(&code, sizeof code, failed);
  const std::string problem = ranks::shared(mine.problem, failed);
  throw Error(static_cast<Exit>(static_cast<int>(code)),
              failed == 0 ? problem : "process " + std::to_string(failed) + ": " + problem);
}

void on_root(const std::function<void()>& work) {
  together([&work] {
    if (ranks::root()) work();
  });
}

}  // namespace softwet
