// A functional of the fields of a scene, ready to be evaluated on a region.
#pragma once

#include "scene/coordinates.hpp"
#include "scene/piece.hpp"

namespace softwet {

/// What use(task) returns for a functional in the coordinates of the scene, with the fields of an evaluation.
template <class Motion, int D, class Functional, class Use>
auto with_task_of(const Region<D>& region, const Functional& functional, const Evaluation<D>& at, const Blend& blend,
                  const Use& use) {
  return in_coordinates_of(at.layout, functional, [&](const auto& here) {
    ReduceTask<D, std::remove_cvref_t<decltype(here)>, Motion> task{region, here, {}, {}, {}};
    bind_fields(at, blend, task);
    return use(task);
  });
}

}  // namespace softwet
