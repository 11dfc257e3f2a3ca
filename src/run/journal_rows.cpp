// What a run writes from step to step, beside the next steps where it may: rows and field files.
#include <algorithm>
#include <memory>

#include "casefile/checks/field_times.hpp"
#include "field/together.hpp"
#include "observe/interface_table.hpp"
#include "observe/output_fields.hpp"
#include "run/journal.hpp"

namespace softwet {

template <int D, int P>
void Journal<D, P>::write_row(const StepReport& report, RowIs row) {
  finish_row();
  Stopwatch watch(seconds_.observers);
  const auto reading = std::make_shared<const RowReading<D>>(
      scalars_.read(stepper_.counts().steps, report, stepper_.state(), stage_at(scene_.layout(), stepper_.state())));
  row_writer_.start([this, reading, row] {  // whoever needs one of these waits before (finish_row)
    next_row_ = scalars_.row_of(*reading);
    on_root([this] { history_->row(next_row_); });
    if (row == RowIs::last) return;
    scalars_.keep();
    if (history_) history_->keep();
  });
  if (!row_writer_.running()) take_row();
}

template <int D, int P>
void Journal<D, P>::finish_row() {
  if (!row_writer_.running()) return;
  Stopwatch watch(seconds_.observers);
  row_writer_.wait();
  take_row();
}

template <int D, int P>
void Journal<D, P>::take_row() {
  last_row_ = next_row_;
  tell_events();
}

template <int D, int P>
void Journal<D, P>::tell_events() {
  for (; told_ < scalars_.events().size(); ++told_) progress_.tell(sentence(scalars_.events()[told_]));
}

template <int D, int P>
void Journal<D, P>::write_fields_due() {
  for (double time : field_times_)
    if (same_time(output_time(), time) || stepper_.passes(case_.clock_zero() + time)) write_fields(time);
}

template <int D, int P>
void Journal<D, P>::write_fields(double time) {
  if (std::any_of(written_.begin(), written_.end(), [time](double t) { return same_time(t, time); })) return;
  require_folder();
  Stopwatch watch(seconds_.output);
  std::vector<double> all = written_;
  all.push_back(time);
  const auto snapshot = std::make_shared<const Snapshot<D>>(scene_.layout(), stepper_.state());
  const auto traction =
      wall_traction(scene_.regions(), scene_.equations(), stage_at(scene_.layout(), stepper_.state()));
  const auto write = [this, snapshot, traction, all] {  // whoever changes one of these waits before (finish_files)
    write_field_files(options_.out, origin_of(case_), case_.output.field_select, case_, scene_.coefficients(),
                      *snapshot, all);
    add_interface_rows<D>(*interface_, *snapshot, traction, all.back());
    interface_->keep();
  };
  on_root([&] { writer_.start(write); });
  written_ = all;  // with all that belongs to it: a run that is resumed does not write it again
}

template <int D, int P>
void Journal<D, P>::finish_files() {
  finish_row();
  Stopwatch watch(seconds_.output);
  try {
    wall_clock_.file(writer_.wait());
  } catch (...) {
    written_.pop_back();  // nothing of it is there
    throw;
  }
}

template void Journal<SOFTWET_DIMENSION, SOFTWET_DEGREE>::write_row(const StepReport&, RowIs);
template void Journal<SOFTWET_DIMENSION, SOFTWET_DEGREE>::write_fields_due();
template void Journal<SOFTWET_DIMENSION, SOFTWET_DEGREE>::write_fields(double);
template void Journal<SOFTWET_DIMENSION, SOFTWET_DEGREE>::finish_files();

}  // namespace softwet
