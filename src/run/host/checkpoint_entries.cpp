#include "run/host/checkpoint_entries.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "case/error.hpp"
#include "run/host/fingerprint.hpp"

namespace softwet {
namespace {

std::string count_of(const std::string& list) { return list + "/count"; }

}  // namespace

void EntriesToFile::list(const std::string& name, std::vector<double>& values) {
  file_.value(count_of(name), static_cast<std::int64_t>(values.size()));
  file_.array(name + "/values", values);
}

void EntriesToFile::refuse(const std::string& name, const std::string& found, const std::string& needed) const {
  throw std::logic_error("checkpoint: '" + name + "' " + found + ", not " + needed);
}

void EntriesFromFile::require_case(const Case& c) const { check_fingerprint(path_, file_.text("case"), c); }

void EntriesFromFile::number(const std::string& name, double& value) {
  value = file_.number(name);
  if (!std::isfinite(value)) refuse(name, fmt::format("is {}", value), "a finite number");
}

void EntriesFromFile::count(const std::string& name, std::int64_t& value) {
  value = file_.integer(name);
  if (value < 0) refuse(name, fmt::format("is {}", value), "a count, 0 or more");
}

void EntriesFromFile::list(const std::string& name, std::vector<double>& values) {
  std::int64_t size = 0;
  count(count_of(name), size);
  values = array(name + "/values", static_cast<std::size_t>(size));
}

void EntriesFromFile::refuse(const std::string& name, const std::string& found, const std::string& needed) const {
  throw Error(Exit::invalid_input, fmt::format("{}: '{}' {} where a checkpoint holds {}; put back the checkpoint.h5 "
                                               "that this case wrote, or start anew without --resume",
                                               path_, name, found, needed));
}

std::vector<double> EntriesFromFile::array(const std::string& name, std::size_t size) const {
  std::vector<double> values = file_.array(name, size);
  for (std::size_t i = 0; i < size; ++i)
    if (!std::isfinite(values[i])) refuse(name, fmt::format("has {} at entry {}", values[i], i), "finite numbers");
  return values;
}

bool EntriesFromFile::says(const std::string& name, const std::string& text) const {
  return file_.has(name) && file_.text(name) == text;
}

}  // namespace softwet
