#include "observe/host/table_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "case/error.hpp"
#include "observe/host/atomic_file.hpp"
#include "observe/host/number_text.hpp"
#include "observe/host/path_state.hpp"

namespace softwet {
namespace {

std::string header_line(const std::vector<std::string>& columns) {
  std::string line;
  for (const std::string& column : columns) line += (line.empty() ? "" : ",") + column;
  return line + "\n";
}

/// The whole file; empty where there is none.
std::string existing_text(const std::string& path) {
  if (const std::string kind = no_regular_file(path); !kind.empty())
    throw Error(Exit::invalid_input, path + ": is " + kind +
                                         " and no table; put back the file that the run wrote, or "
                                         "start anew with --overwrite in place of --resume");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    if (errno == ENOENT || errno == ENOTDIR) return "";
    throw_disk_error(path, "cannot be read", errno);
  }
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) throw_disk_error(path, "cannot be read", errno);
  return text.str();
}

/// The step number of a row that has a cell for each column.
double step_of(const std::string& path, const std::string& line, std::size_t line_number, std::size_t columns) {
  const auto refuse = [&](const std::string& problem) {
    throw Error(Exit::invalid_input, path + ":" + std::to_string(line_number) + ": " + problem +
                                         "; remove the row or the file, or start anew without --resume");
  };
  const std::size_t cells = 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
  double step = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), step);
  const bool whole_cell = end == line.data() + line.size() || *end == ',' || *end == '\n';
  if (error != std::errc() || !whole_cell || !std::isfinite(step)) refuse("the row does not start with a step number");
  if (cells != columns)
    refuse("the row has " + std::to_string(cells) + " cells for " + std::to_string(columns) + " columns");
  return step;
}

/// The rows up to `step`, header included; the last line only when it is whole.
std::string rows_until(const std::string& path, const std::string& text, const std::string& header, double step) {
  if (text.compare(0, header.size(), header) != 0) {
    throw Error(Exit::invalid_input, path + ":1: the header is '" + text.substr(0, text.find('\n')) +
                                         "' where this run writes '" + header.substr(0, header.size() - 1) +
                                         "'; resume with the case that wrote it, move the file away, or start anew "
                                         "without --resume");
  }
  const std::size_t columns = 1 + static_cast<std::size_t>(std::count(header.begin(), header.end(), ','));
  std::string kept = header;
  std::size_t line_number = 2;
  for (std::size_t begin = header.size(); begin < text.size(); ++line_number) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;
    const std::string line = text.substr(begin, end + 1 - begin);
    if (step_of(path, line, line_number, columns) <= step) kept += line;
    begin = end + 1;
  }
  return kept;
}

}  // namespace

TableFile::TableFile(const std::string& path, const std::vector<std::string>& columns, const char* mode)
    : path_(path), columns_(columns), last_flush_(std::chrono::steady_clock::now()) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) throw_disk_error(folder.string(), "the folder cannot be made", error.value());
  file_.reset(std::fopen(path.c_str(), mode));
  if (file_ == nullptr) throw_disk_error(path, "cannot be written", errno);
}

TableFile TableFile::create(const std::string& path, const std::vector<std::string>& columns) {
  ::unlink(path.c_str());  // a pipe of that name would be waited for
  TableFile table(path, columns, "w+b");
  table.pending_ = header_line(columns);
  table.flush();
  return table;
}

TableFile TableFile::append_after(const std::string& path, const std::vector<std::string>& columns, double step) {
  const std::string text = existing_text(path);
  if (text.empty()) return create(path, columns);
  const std::string kept = rows_until(path, text, header_line(columns), step);
  if (kept != text) write_text_atomically(path, kept);
  return TableFile(path, columns, "a+b");
}

TableFile::~TableFile() {
  try {
    if (file_ != nullptr) flush();
  } catch (const Error&) {
    // A destructor cannot tell; callers that need to know call flush() first.
  }
}

void TableFile::row(const std::vector<std::optional<double>>& values) {
  if (values.size() != columns_.size()) {
    throw Error(Exit::computation_failed, path_ + ": a row has " + std::to_string(values.size()) + " values for " +
                                              std::to_string(columns_.size()) +
                                              " columns; this is an error in softwet, please report it");
  }
  std::string line;
  for (std::size_t column = 0; column < values.size(); ++column) {
    if (column > 0) line += ',';
    if (!values[column]) continue;
    if (!std::isfinite(*values[column])) {
      throw Error(Exit::computation_failed, path_ + ": not written: column '" + columns_[column] + "' is " +
                                                number_text(*values[column]) + " at " + columns_[0] + " " +
                                                number_text(values[0].value_or(NAN)) +
                                                "; the computation has diverged: take shorter time steps");
    }
    line += number_text(*values[column]);
  }
  pending_ += line + "\n";
  if (std::chrono::steady_clock::now() - last_flush_ >= std::chrono::seconds(1)) flush();
}

void TableFile::flush() {
  last_flush_ = std::chrono::steady_clock::now();
  if (pending_.empty()) return;
  errno = 0;
  const bool written =
      std::fwrite(pending_.data(), 1, pending_.size(), file_.get()) == pending_.size() && std::fflush(file_.get()) == 0;
  pending_.clear();
  if (!written) throw_disk_error(path_, "rows cannot be written", errno);
}

bool TableFile::in_place() const { return leads_to(path_, ::fileno(file_.get())); }

void TableFile::put_back() {
  flush();
  std::rewind(file_.get());
  std::string text, part(1 << 16, '\0');
  while (const std::size_t length = std::fread(part.data(), 1, part.size(), file_.get())) text.append(part, 0, length);
  if (std::ferror(file_.get())) throw_disk_error(path_, "was removed or replaced, and cannot be read again", errno);
  if (std::rename(path_.c_str(), (path_ + ".replaced").c_str()) != 0 && errno != ENOENT)
    throw_disk_error(path_, "was replaced, and what has its name cannot be moved away", errno);
  write_text_atomically(path_, text);
}

}  // namespace softwet
