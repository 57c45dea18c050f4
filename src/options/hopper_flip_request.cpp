// SPDX-License-Identifier: Apache-2.0
#include "src/options/hopper_flip_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hopper/planning/objectives/library.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::cli {
namespace {

// The solver holds constraints to some 1e-8 of numbers near 1: beyond these nothing of one or the
// other is left.
constexpr double kLeastWeight = 1e-6;
constexpr double kGreatestWeight = 1e6;

[[noreturn]] void refuse_objective(const std::string& text, const std::string& why) {
  throw io::SpecError({{"command line", "--objective " + text, why}});
}

double read_weight(const std::string& text, const std::string& number) {
  char* end = nullptr;
  const double weight = std::strtod(number.c_str(), &end);
  if (number.empty() || *end != '\0' || !std::isfinite(weight)) {
    refuse_objective(text, "WEIGHT is a number");
  }
  if (!(weight >= kLeastWeight && weight <= kGreatestWeight)) {
    refuse_objective(text,
                     "WEIGHT is from 1e-6 to 1e6: 1 is usual, and far from it the solver loses "
                     "the constraints, or the objective, in rounding");
  }
  return weight;
}

}  // namespace

std::vector<hopper::WeightedObjective> read_objectives(const std::vector<std::string>& texts) {
  std::vector<hopper::WeightedObjective> objectives;
  const std::vector<std::string> known = hopper::objective_names();
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const auto near = io::nearest(name, known);
      refuse_objective(text, fmt::format("no such objective{}",
                                         near ? fmt::format("; did you mean \"{}\"?", *near)
                                              : fmt::format("; there are {}", io::listed(known))));
    }
    for (const hopper::WeightedObjective& other : objectives) {
      if (other.name == name) refuse_objective(text, "stands twice: one weight is enough");
    }
    const double weight =
        equals == std::string::npos ? 1.0 : read_weight(text, text.substr(equals + 1));
    objectives.push_back({name, weight});
  }
  return objectives;
}

}  // namespace torquewright::cli
