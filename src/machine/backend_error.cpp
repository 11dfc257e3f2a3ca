#include "machine/backend_error.hpp"

namespace softwet {

Error backend_error(const std::string& problem) {
  const bool memory = problem.find("failed to allocate") != std::string::npos;
  return Error(Exit::machine_failed, problem + (memory ? "; 'softwet check CASE' shows how much a case needs"
                                                       : "; no setting of a case helps: run it again, and if it fails "
                                                         "again report it with what 'softwet info' prints"));
}

}  // namespace softwet
