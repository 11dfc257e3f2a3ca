// What a run does where somebody moves or removes its folder or a table.
#include <utility>

#include "case/error.hpp"
#include "case/text.hpp"
#include "field/ranks.hpp"
#include "field/together.hpp"
#include "run/journal.hpp"

namespace softwet {
template <int D, int P>
void Journal<D, P>::require_folder() {
  finish_files();
  const std::string place = options_.place ? options_.place() : options_.out;
  enum Found { in_place, moved, removed };
  const Found found = place == options_.out ? in_place : place.empty() ? removed : moved;
  const std::string when = " during the run, which has stopped at t = " + short_text(output_time(), 6);
  switch (static_cast<Found>(ranks::of_root(found))) {  // which has the folder
    case in_place:
      return require_tables();
    case removed:
      throw Error(Exit::machine_failed, options_.out + ": the output folder was removed" + when +
                                            "; its results and its last state are gone with it: start the run again");
    case moved:
      const std::string before = std::exchange(options_.out, place);
      if (history_) history_->moved_to(path("history.csv"));
      if (interface_) interface_->moved_to(path("interface.csv"));
      write_state();
      record("stopped: its folder was moved");
      throw Error(Exit::machine_failed, before + ": the output folder was moved" + when +
                                            "; its results and its last state are in " + place +
                                            "; to go on, give the same command with --resume --out " + place);
  }
}

template <int D, int P>
void Journal<D, P>::require_tables() {
  std::string lost;
  on_root([&] {
    for (std::optional<TableFile>* table : {&history_, &interface_}) {
      if ((*table)->in_place()) continue;
      (*table)->put_back();
      lost += (lost.empty() ? "" : " and ") + (*table)->path();
    }
  });
  if (ranks::of_root(lost.empty() ? 0 : 1) == 0) return;
  write_state();
  record("stopped: a table was removed");
  throw Error(Exit::machine_failed, lost + " was removed or replaced during the run, which has stopped at t = " +
                                        short_text(output_time(), 6) +
                                        "; its rows have been written again (what stood in their place has the ending "
                                        ".replaced), and the last state is in " +
                                        path("checkpoint.h5") + "; to go on, give the same command with --resume");
}

template void Journal<SOFTWET_DIMENSION, SOFTWET_DEGREE>::require_folder();
template void Journal<SOFTWET_DIMENSION, SOFTWET_DEGREE>::require_tables();

}  // namespace softwet
