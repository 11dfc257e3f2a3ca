#include "io/table_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "case/error.hpp"
#include "io/atomic_file.hpp"
#include "io/number_text.hpp"
#include "io/path_state.hpp"
#include "io/table_rows.hpp"

namespace softwet {
namespace {

/// The whole file, if there is one.
std::optional<std::string> existing_text(const std::string& path) {
  if (const std::string kind = no_regular_file(path); !kind.empty())
    throw Error(
        Exit::invalid_input,
        path + ": is " + kind +
            " and no table; put back the file that the run wrote, or start anew with --overwrite in place of --resume");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    throw_disk_error(path, "cannot be read", errno);
  }
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) throw_disk_error(path, "cannot be read", errno);
  return text.str();
}

}  // namespace

void TableMark::add(const std::string& lines) {
  bytes += static_cast<std::int64_t>(lines.size());
  rows += std::count(lines.begin(), lines.end(), '\n');
  for (const char c : lines) checksum = (checksum ^ static_cast<unsigned char>(c)) * 16777619u;
}

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
  table.begin_after(table.pending_);
  table.flush();
  return table;
}

void TableFile::begin_after(const std::string& lines) {
  all_.add(lines);
  all_.rows -= 1;  // the header
  keep();
}

TableFile TableFile::go_on(const std::string& path, const std::vector<std::string>& columns, const std::string& text,
                           const std::string& kept) {
  if (kept != text) write_text_atomically(path, kept);
  TableFile table(path, columns, "a+b");
  table.begin_after(kept);
  return table;
}

TableFile TableFile::append_after(const std::string& path, const std::vector<std::string>& columns,
                                  const TableMark& mark) {
  const std::optional<std::string> text = existing_text(path);
  if (!text) refuse_table(path, "is missing, with " + std::to_string(mark.rows) + " rows that the run had written");
  if (text->empty()) return create(path, columns);
  return go_on(path, columns, *text, rows_up_to_mark(path, *text, columns, mark));
}

TableFile::~TableFile() {
  try {
    if (file_ != nullptr) flush();
  } catch (const Error&) {
    // A destructor cannot report; callers that need to know call flush() first.
  }
}

void TableFile::row(const TableRow& row) {
  const std::vector<TableRow::Cell> values = row.in_order_of(columns_);
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
  line += "\n";
  pending_ += line;
  all_.add(line);
  if (std::chrono::steady_clock::now() - last_flush_ >= std::chrono::seconds(1)) flush();
}

void TableFile::flush() {
  last_flush_ = std::chrono::steady_clock::now();
  if (failed_ == 0 && !pending_.empty()) {
    errno = 0;
    const bool written = std::fwrite(pending_.data(), 1, pending_.size(), file_.get()) == pending_.size() &&
                         std::fflush(file_.get()) == 0;
    pending_.clear();
    if (!written) failed_ = errno != 0 ? errno : EIO;
  }
  if (failed_ != 0) throw_disk_error(path_, "rows cannot be written", failed_);
}

void TableFile::bring_to_disk() {
  flush();
  const int failed = ::fsync(::fileno(file_.get())) != 0 ? errno : 0;
  // Some network and in-memory file systems do not know fsync: nothing more can be done there.
  if (failed != 0 && failed != EINVAL && failed != ENOTSUP)
    throw_disk_error(path_, "rows did not reach the disk", failed);
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
