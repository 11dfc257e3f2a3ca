// What graded elements would spare a case that has equal ones, and whether that was measured to keep the path of its
// droplet.
#pragma once

#include <string>

#include "case/case.hpp"

namespace softwet {

/// Share of the elements that domain.grading.fine = "automatic" would leave; 1 where elements are graded already.
double share_left_by_grading(const Case&);

/// Whether a case is of the kind of which scenes were sampled: one droplet in 2D on a layer of one material, which
/// loads alone pull or push from the start that the case describes, with contact angle, stiffness, Poisson's ratio and
/// temperature in the ranges sampled there (docs/verification/sampled_graded.md).
bool is_sampled_pull(const Case&);

/// What was found in these scenes.
std::string result_of_sampled_pulls();

/// A sentence for the end of a run that had equal elements though it was of that kind and grading would spare a fifth;
/// empty: none.
std::string advice_on_grading(const Case&);

/// Whether grading would spare enough to say so.
inline bool is_worth_grading(double share) {
  constexpr double most_left = 0.8;
  return share <= most_left;
}

}  // namespace softwet
