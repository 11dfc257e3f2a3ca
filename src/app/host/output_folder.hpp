// The output folder of a run: made only for a valid case, never mixed with older results, removed when nothing came.
#pragma once

#include <string>

#include "app/case.hpp"

namespace softwet {

enum class OldResult { refuse, resume, overwrite };

class OutputFolder {
 public:
  /// Makes the folder and, unless the run resumes, writes case.toml into it. Throws Error: invalid_input when an old
  /// result is in the way or there is nothing to resume, machine_failed when the folder cannot be written.
  OutputFolder(const std::string& path, const Case& c, OldResult old);

  /// Takes back what the constructor made, for a run that was refused before it computed anything.
  void discard();

  /// Writes case.toml of a resumed run, whose end or output may have changed.
  void finish(const Case& c);

 private:
  std::string path_;
  std::string made_;  ///< the topmost folder this object made; empty: the folder was there
  OldResult old_;
};

}  // namespace softwet
