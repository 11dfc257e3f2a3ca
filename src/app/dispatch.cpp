#include "app/dispatch.hpp"

#include "app/error.hpp"

namespace softwet {
void run_case(const Case&, const RunOptions&) {}
void describe_case(const Case&, std::ostream&) {}
void bench_case(const Case&, const RunOptions&, std::ostream&) {}
void describe_build(std::ostream&) {}
}  // namespace softwet
