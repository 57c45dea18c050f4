// SPDX-License-Identifier: Apache-2.0
#include "identification/trials.hpp"

#include "identification/compatibility.hpp"

namespace torquewright::identification {

bool Trials::may_join(const Members& members, std::size_t added) const {
  return is_compatible(fitter_.dictionary(), members, added, options_.target_is_motor_side,
                       options_.is_free_load);
}

bool Trials::accepts(const Fit& without, const Fit& with) const {
  if (!without.is_valid) return with.is_valid;
  if (!with.is_valid) return false;
  const AcceptanceRules rules =
      rules_for(fitter_.dictionary(), without.members, with.members, options_.rules);
  return objection(with, gain_of(fitter_, without, with, rules), rules).empty();
}

Fit Trials::without(const Fit& fit, std::size_t place) const {
  return fitter_.fit_unlimited(less_one(fit.members, place));
}

bool Trials::is_sound(const Fit& fit) const {
  for (std::size_t place = 0; place < fit.members.size(); ++place) {
    if (!accepts(without(fit, place), fit)) return false;
  }
  return true;
}

Members less_one(Members members, std::size_t place) {
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(place));
  return members;
}

Members plus_one(Members members, std::size_t added) {
  members.push_back(added);
  return members;
}

bool beats(const Fit& fit, const Fit& best) {
  return fit.is_valid && (!best.is_valid || fit.loss < best.loss);
}

}  // namespace torquewright::identification
