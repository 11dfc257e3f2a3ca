// What a run writes: rows of its tables, field files, checkpoints and its record.
#include "case/text.hpp"
#include "casefile/checks/field_times.hpp"
#include "field/together.hpp"
#include "machine/memory.hpp"
#include "observe/interface_table.hpp"
#include "observe/output_fields.hpp"
#include "run/machine.hpp"
#include "run/simulation.hpp"

namespace softwet {

template <int D, int P>
void Simulation<D, P>::observe(const StepReport& report) {
  const long step = stepper_.counts().steps;
  if (step % case_.output.history_every == 0) {
    write_row(report);
    scalars_.keep();
    if (history_) history_->keep();
  }
  write_fields_due();
  if (step > 0) progress_->step(output_time(), step, report.dt, last_row_, time_left_.seconds());
}

template <int D, int P>
void Simulation<D, P>::write_row(const StepReport& report) {
  Stopwatch watch(seconds_.observers);
  last_row_ =
      scalars_.evaluate(stepper_.counts().steps, report, stepper_.state(), stage_at(model_.layout(), stepper_.state()));
  on_root([this] { history_->row(last_row_); });
  tell_events();
}

template <int D, int P>
void Simulation<D, P>::tell_events() {
  for (; told_ < scalars_.events().size(); ++told_) progress_->tell(sentence(scalars_.events()[told_]));
}

template <int D, int P>
void Simulation<D, P>::write_fields_due() {
  for (double time : field_times_) {
    if (!same_time(output_time(), time) || (!written_.empty() && same_time(written_.back(), time))) continue;
    require_folder();
    Stopwatch watch(seconds_.output);
    std::vector<double> all = written_;
    all.push_back(time);
    const Snapshot<D> snapshot(model_.layout(), stepper_.state());
    const auto traction = wall_traction(model_, stage_at(model_.layout(), stepper_.state()));
    on_root([&] {
      write_field_files<D, P>(options_.out, origin_of(case_), case_.output.field_select, model_, snapshot, all);
      add_interface_rows<D>(*interface_, snapshot, traction, time);
      interface_->keep();
    });
    written_ = all;  // with all that belongs to it: a run that is resumed does not write it again
  }
}

template <int D, int P>
void Simulation<D, P>::write_state() {
  Stopwatch watch(seconds_.output);
  const double before = since_start();
  WrittenFiles files{{}, {}, written_};
  on_root([&] {
    history_->bring_to_disk();
    interface_->bring_to_disk();
    files.history = history_->kept();
    files.interface = interface_->kept();
  });
  seconds_.total = seconds_before_ + since_start();
  write_checkpoint<D, P>(path("checkpoint.h5"), case_, stepper_, scalars_.memory(), files, seconds_);
  record("running");
  wall_clock_.save(since_start() - before);
}

template <int D, int P>
void Simulation<D, P>::record(const std::string& reason) {
  seconds_.total = seconds_before_ + since_start();
  const std::vector<double> memory = peak_memory_of_processes();
  on_root([&] { write_record(reason, memory); });
}

template <int D, int P>
void Simulation<D, P>::write_record(const std::string& reason, const std::vector<double>& memory) {
  RunRecord run = describe_run<D, P>(case_, model_, stepper_, seconds_, first_step_);
  for (double of_process : memory)
    if (memory.size() > 1) run["peak_memory_of_processes_mib"].append(of_process);
  add_status(run, {reason, output_time(), seconds_.started, time_left_.seconds(), scalars_.events()});
  for (const std::string& column : scalars_.columns())
    if (const TableRow::Cell cell = last_row_.cell(column)) run["last_row"][column] = *cell;
  if (relaxation_) record_rest(run);
  run.write(path("run.json"));
}

template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::observe(const StepReport&);
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::write_row(const StepReport&);
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::tell_events();
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::write_fields_due();
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::write_state();
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::record(const std::string&);
template void Simulation<SOFTWET_DIMENSION, SOFTWET_DEGREE>::write_record(const std::string&,
                                                                          const std::vector<double>&);

}  // namespace softwet
