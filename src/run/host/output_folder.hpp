// The output folder of a run: made only for a valid case, never mixed with older results, removed when nothing came.
#pragma once

#include <optional>
#include <string>

#include "case/case.hpp"
#include "case/physical.hpp"

namespace softwet {

enum class OldResult { refuse, resume, overwrite };

class OutputFolder {
 public:
  /// Makes the folder where it is missing; a result in it stays. Throws Error: invalid_input when an old result is in
  /// the way, there is nothing to resume or another run has the folder, machine_failed when it cannot be written.
  /// @param laboratory  with its units the folder gets units.json, and case.toml the table [laboratory]
  OutputFolder(const std::string& path, const Case& c, OldResult old, std::optional<Laboratory> laboratory = {});
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Removes the old result that is to be replaced and writes case.toml, of a resumed run too, whose end or output may
  /// have changed. For a run that nothing can refuse any more.
  void begin();

  /// Where the folder is now, for a run that is under way: its path; another one where somebody has moved it; empty
  /// where it was removed.
  std::string place() const;

  /// Takes back what this object made, for a run that ended before its first row. An old result stays until begin().
  void discard();

 private:
  /// A lock on the folder, held while it is open.
  struct Lock {
    int descriptor = -1;
    ~Lock();
  };
  void lock();

  std::string path_;
  std::string made_;  ///< the topmost folder this object made; empty: the folder was there
  const Case& case_;
  OldResult old_;
  std::optional<Laboratory> laboratory_;
  bool begun_ = false;
  Lock lock_;
};

}  // namespace softwet
