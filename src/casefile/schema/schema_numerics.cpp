// Schema, third part: sides, time steps and solver.
#include "casefile/schema/binding.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {
namespace {

constexpr Range fraction{0, 1, true, true};

/// Axis of a side: left/right, front/back (3D), bottom/top (the last axis).
enum class Pair { left_right, front_back, bottom_top };

Key side_key(const char* name, Pair pair, std::size_t end, const char* help, const char* example = "") {
  const auto place = [pair, end](Case& c, std::size_t) -> Side& {
    const std::size_t vertical = c.dimension() == 3 ? 2 : 1;
    const std::size_t axis = pair == Pair::left_right ? 0 : pair == Pair::front_back ? 1 : vertical;
    return c.boundary.side[axis][end];
  };
  return {.name = name,
          .kind = Kind::choice,
          .choices = words_of(Side{}),
          .example = example,
          .help = help,
          .bind = at(place),
          .only_in = pair == Pair::front_back ? 3 : 0};
}

std::vector<Key> boundary_keys() {
  std::vector<Key> keys{
      side_key("boundary.left", Pair::left_right, 0,
               "Low end of the first axis; periodic only together with right. 'softwet explain boundary' shows what "
               "each kind prescribes."),
      side_key("boundary.right", Pair::left_right, 1,
               "High end of the first axis; periodic only together with left. 'softwet explain boundary' shows what "
               "each kind prescribes."),
      side_key("boundary.front", Pair::front_back, 0,
               "Low end of the second axis in 3D; periodic only together with back."),
      side_key("boundary.back", Pair::front_back, 1,
               "High end of the second axis in 3D; periodic only together with front."),
      side_key("boundary.bottom", Pair::bottom_top, 0,
               "Below the solid; without a solid it is the rigid wall, where the contact angle holds."),
      side_key("boundary.top", Pair::bottom_top, 1, "Above the fluid, or above a solid without a fluid.",
               "\"no_slip\""),
  };
  keys.back().default_note = "\"no_slip\" with a fluid, \"free\" for a solid alone";
  return keys;
}

std::vector<Key> time_keys() {
  return {
      {.name = "time.scheme",
       .kind = Kind::choice,
       .choices = words_of(TimeScheme{}),
       .help =
           "Time scheme. generalized_alpha is implicit and takes steps of any size; it is the one for slow motion. The "
           "others are explicit: their steps are limited by sound, capillarity, elasticity and the viscosity of the "
           "vapour. kick_drift is of second order and evaluates the equations once a step; it is the one for fast "
           "motion. rkl2 is ssp_rk3 with viscosity treated apart, in half steps with as many stages as these need to "
           "be stable: for a vapour so thin that its viscosity would limit the step. ssp_rk3 is of third order with "
           "three evaluations, for fast flow with almost no viscosity. automatic takes kick_drift where it needs at "
           "most 1300 "
           "steps to time.end, or 2000 in 3D, and generalized_alpha elsewhere; it says which.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.scheme; })},
      {.name = "time.mass",
       .kind = Kind::choice,
       .choices = words_of(MassKind{}),
       .help =
           "Mass matrices of the explicit schemes. lumped takes their row sums: the error in space is of second order. "
           "corrected follows that by three products with the masses, which takes nearly all of this error away and "
           "makes steps 1.6 to 1.9 times shorter. consistent solves with the masses by conjugate gradients: many "
           "times more expensive, to compare with. In violent flow of a thin vapour, where rkl2 takes steps that are "
           "many "
           "times "
           "longer than viscosity allows, corrected masses let the density fall below zero; lumped ones do not.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.mass; }),
       .default_note = "\"corrected\"; \"lumped\" with rkl2"},
      {.name = "time.safety",
       .range = {0, 10, true, false},
       .help = "Largest step of the explicit schemes, as a part of the largest stable step by a bound from the state. "
               "Above 1 the computation becomes unstable; such values are for experiments.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.safety; })},
      {.name = "time.start",
       .kind = Kind::choice,
       .choices = words_of(StartState{}),
       .help =
           "State that the computation begins with. initial is the state of the case file, which moves until it is at "
           "rest. equilibrium brings it to rest first, without loads, by implicit steps that grow quickly and are not "
           "accurate in time; the computation then begins when the first load does. Not for scenes that are to move "
           "from the beginning.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.start; })},
      {.name = "time.rho_inf",
       .range = {0, 1, false, false},
       .example = "0.5",
       .help =
           "Damping of generalized-alpha: the factor by which one very large step multiplies an oscillation. 1 damps "
           "nothing, 0 damps high frequencies most.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.rho_inf; })},
      {.name = "time.end",
       .unit = "L0/sqrt(ab)",
       .range = positive,
       .required = true,
       .example = "1884.0",
       .help =
           "Time t at which the computation ends. t is the time of all results: 0 when the first load begins, negative "
           "before (load[].start is a run time, which counts from the beginning of the computation).",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.end; })},
      {.name = "time.dt_initial",
       .unit = "L0/sqrt(ab)",
       .range = positive,
       .help = "First time step.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.dt_initial; })},
      {.name = "time.dt_min",
       .unit = "L0/sqrt(ab)",
       .range = positive,
       .help =
           "Smallest time step; a step that fails at this size ends the computation, and so does an explicit scheme "
           "whose longest stable step is shorter. A step may be shorter than this in order to end at a field time, "
           "at time.end, or at the start or end of a ramp.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.dt_min; })},
      {.name = "time.dt_max",
       .unit = "L0/sqrt(ab)",
       .range = positive,
       .help = "Largest time step. No step is longer.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.dt_max; })},
      {.name = "time.tolerance",
       .range = positive,
       .help =
           "Local error that sets the size of the time step. Steps longer than an oscillation of the largest droplet "
           "have less, down to a quarter (docs/theory.md).",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.tolerance; })},
      {.name = "time.max_steps",
       .kind = Kind::integer,
       .range = {1, 1e15, false, false},
       .help = "Most accepted time steps.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.time.max_steps; })},
      {.name = "time.wall_clock",
       .unit = "hours of wall time",
       .range = {0, infinity, false, true},
       .help =
           "Wall time that the run may take, such as the limit of a job on a cluster. Before it is over "
           "the run stops with a checkpoint, from which --resume continues with the same bits and a new limit. Each "
           "start "
           "with --resume takes one step or more. 0 means no limit.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.wall_clock; })},
  };
}

std::vector<Key> solver_keys() {
  return {
      {.name = "solver.newton.rtol",
       .range = fraction,
       .help = "Newton stops at this fraction of the first residual. With time.rho_inf above 0.9, where hardly any "
               "error is damped, "
               "the default is at most 1e-6.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.newton_rtol; })},
      {.name = "solver.newton.atol",
       .range = positive,
       .help =
           "Newton also stops at this residual per volume, however large the first residual was, but not before the "
           "first "
           "iteration, unless the residual is below 1e-10. With a solid whose lambda + 2 G is above 1, both bounds are "
           "multiplied by it.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.newton_atol; })},
      {.name = "solver.newton.max",
       .kind = Kind::integer,
       .range = {1, 1000, false, false},
       .help = "Most Newton iterations of a time step; more rejects the step.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.newton_max; }),
       .default_note = "10; 25 where contact lines have friction or hysteresis"},
      {.name = "solver.newton.undershoot",
       .unit = "b",
       .range = {0, 1, false, false},
       .help = "How far a control value of the density may fall below 0 in a step that is accepted. The density itself "
               "falls less far, and the free energy is continued smoothly below 0.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.newton_undershoot; })},
      {.name = "solver.krylov.rtol",
       .range = fraction,
       .help = "Reduction of the true residual by each linear solve.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.krylov_rtol; })},
      {.name = "solver.krylov.restart",
       .kind = Kind::integer,
       .range = {2, 1000, false, false},
       .help = "Vectors GMRES keeps before it restarts.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.krylov_restart; })},
      {.name = "solver.krylov.max",
       .kind = Kind::integer,
       .range = {1, 100000, false, false},
       .help = "Most iterations of one linear solve.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.krylov_max; })},
      {.name = "solver.krylov.jacobian",
       .kind = Kind::choice,
       .choices = words_of(JacobianKind{}),
       .help = "Jacobian-vector product: exact (dual numbers), or a finite difference of residuals.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.jacobian; })},
      {.name = "solver.krylov.preconditioner",
       .kind = Kind::choice,
       .choices = words_of(PreconditionerKind{}),
       .former = {{"umfpack", "lu", "computes in double precision where a matrix needs it"}},
       .help =
           "Lagged LU by nested dissection (lu), multilevel Schwarz (schwarz), none, or automatic: lu in 2D and up to "
           "3000 unknowns in 3D, schwarz above. Several processes refuse lu.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.preconditioner; })},
      {.name = "solver.krylov.launch",
       .kind = Kind::choice,
       .choices = words_of(Launch{}),
       .help =
           "How a GPU starts the preconditioner and the steps of kick_drift: kernel by kernel (kernels), or recorded "
           "and started as one (graph). On the one GPU tested a graph was hardly faster for preconditioners; "
           "for steps of small scenes, which are bound by their launches, it was not measured. On a processor, where "
           "several processes share a scene, with other explicit schemes and with consistent masses both are the same.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.launch; })},
      {.name = "solver.precision",
       .kind = Kind::choice,
       .choices = words_of(PrecisionChoice{}),
       .help =
           "Precision of the linear solves of Newton's method with generalized_alpha: their products of the Jacobian "
           "and their vectors. mixed: single precision. The results have the accuracy of double. automatic: mixed, "
           "except for explicit schemes, for solver.krylov.jacobian = \"difference\" and for solver.krylov.rtol below "
           "1e-5, which need double precision. States, residuals and integrals are always in double precision, and "
           "preconditioners in single.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.solver.precision; })},
  };
}

}  // namespace

std::vector<Key> numerics_keys() {
  std::vector<Key> keys;
  for (auto part : {boundary_keys, time_keys, solver_keys}) {
    for (Key& key : part()) keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace softwet
