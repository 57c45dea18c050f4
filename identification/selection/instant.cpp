// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/instant.hpp"

#include "identification/forward/sample_step.hpp"

namespace torquewright::identification {

ForwardEquation held_at_start(ForwardEquation equation, std::size_t k) {
  const auto place = static_cast<std::ptrdiff_t>(k);
  equation.apply_always = [before = equation.apply_always, place, value = equation.always_start[k]](
                              std::span<const double> values, Hypothesis& hypothesis) {
    std::vector<double> all(values.begin(), values.end());
    all.insert(all.begin() + place, value);
    before(all, hypothesis);
  };
  equation.always.erase(equation.always.begin() + place);
  equation.always_start.erase(equation.always_start.begin() + place);
  if (k < equation.pointers.size()) equation.pointers.erase(equation.pointers.begin() + place);
  return equation;
}

ForwardEquation without_instants(ForwardEquation equation) {
  for (std::size_t k = equation.always.size(); k-- > 0;) {
    if (equation.always[k].name == kInstant) equation = held_at_start(std::move(equation), k);
  }
  return equation;
}

}  // namespace torquewright::identification
