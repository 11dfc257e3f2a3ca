// The output folder of a run: made only for a valid case, never mixed with older results, removed when nothing came.
#pragma once

#include <string>

#include "app/case.hpp"

namespace softwet {

enum class OldResult { refuse, resume, overwrite };

class OutputFolder {
 public:
  /// Makes the folder where it is missing; a result in it stays. Throws Error: invalid_input when an old result is in
  /// the way or there is nothing to resume, machine_failed when the folder cannot be written.
  OutputFolder(const std::string& path, const Case& c, OldResult old);

  /// Removes the old result that is to be replaced and writes case.toml. For a run that nothing can refuse any more.
  void begin();

  /// Takes back what this object made, for a run that ended before its first row. An old result stays until begin().
  void discard();

  /// Writes case.toml of a resumed run, whose end or output may have changed.
  void finish();

 private:
  std::string path_;
  std::string made_;  ///< the topmost folder this object made; empty: the folder was there
  const Case& case_;
  OldResult old_;
  bool begun_ = false;
};

}  // namespace softwet
