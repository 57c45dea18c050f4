// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/every_objective.hpp"
#include "hopper/planning/objectives/flight_phase.hpp"

namespace torquewright::hopper {
namespace {

// A radian per second counts what it counts for cav; the flip of least effort has 12.
constexpr double kTypical_rad_s = 8.0;

/// Variables: the base's pitch rate.
struct PitchRateLaw {
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    rows[0] = factor * x[0];
  }
};

Costs costs(const FlipProgram& program, double factor) {
  Costs out;
  // The third row of the frame that flies is the base's pitch.
  const int rate = longest_flight(program, "bav").points.front().velocity + 2;
  out.push_back(jet_cost("bav", {rate}, PitchRateLaw{factor}));
  return out;
}

void add(const PlanModel&, const PlanOptions&, double weight, FlipProgram& program) {
  add_costs(costs(program, -weight * kTypicalCost / kTypical_rad_s), program);
}

double value(const PlanModel&, const PlanOptions&, const FlipProgram& program,
             const std::vector<double>& values) {
  return sum_of(costs(program, 1.0), values);
}

}  // namespace

const Objective objectives::bav{
    "bav", "greatest angular velocity of the base forwards, at the take-off of the longest flight",
    "rad/s", add, value};

}  // namespace torquewright::hopper
