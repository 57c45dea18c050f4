// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/smoothness.hpp"

#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/plane/simpson.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"

namespace torquewright::hopper {
namespace {

// A torque that goes from 0 to the greatest in this time (3.2 ms squared) costs what holding it as
// long does. A Simpson sum does not see a middle that is off its neighbours as much one way as they
// are the other: without this and the accelerations' term the torques in the middle of intervals of
// the hopper's highest flip are up to 300 Nm off their neighbours' mean, with them 60 Nm. Ten times
// as much takes away 7 % of the greatest average velocity at take-off.
constexpr double kTorqueRate_s2 = 1e-5;
// A middle that stands off the straight line between its ends by half the greatest torque costs
// that much: 1 % of a flip's effort in one interval, next to nothing where torques are resolved.
constexpr double kTorqueBend = 1e-3;
// Joints that accelerate at 100 rad/s^2 cost a thousandth of a drive at its greatest torque. It
// chooses among motions that objectives of one instant (height, cav) leave alike: without it and
// the rates' term the search took twice the iterations. The least effort is 4 % more with them.
constexpr double kAccelerationShare = 1e-3;
constexpr double kAcceleration_rad_s2 = 100.0;

/// kTorqueRate_s2 times the integral over an interval of the squared rate of torque/most: straight
/// between its three instants. Variables: those torques, the phase's duration.
struct TorqueRateLaw {
  double share;  ///< Of the duration.
  double most_Nm;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const T first = (x[1] - x[0]) * (1.0 / most_Nm), second = (x[2] - x[1]) * (1.0 / most_Nm);
    const T bend = second - first;
    rows[0] = (2.0 * kTorqueRate_s2 / share) * (first * first + second * second) / x[3] +
              kTorqueBend * (bend * bend);
  }
};

/// An instant's part of the integral of squared accelerations. Variables: the joints'
/// accelerations, the phase's duration.
struct AccelerationLaw {
  double share;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const Eigen::Index joints = x.size() - 1;
    T sum(0.0);
    for (Eigen::Index i = 0; i < joints; ++i) sum += x[i] * x[i];
    rows[0] = (share * kAccelerationShare / (kAcceleration_rad_s2 * kAcceleration_rad_s2)) *
              x[joints] * sum;
  }
};

Costs torque_rates(const PlanModel& model, const FlipProgram& program, std::size_t phase) {
  Costs costs;
  const PhaseVariables& variables = program.phases[phase];
  const std::vector<double>& knots = program.mesh[phase].knots;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (std::size_t drive = 0; drive < model.regions->size(); ++drive) {
      const auto torque = [&](std::size_t point) {
        return variables.points[point].drives + static_cast<int>(drive);
      };
      costs.push_back(jet_cost(
          "smooth torques",
          {torque(2 * i), torque(2 * i + 1), torque(2 * i + 2), variables.duration},
          TorqueRateLaw{knots[i + 1] - knots[i], (*model.regions)[drive].greatest_torque_Nm()}));
    }
  }
  return costs;
}

Costs accelerations(const PlanModel& model, const FlipProgram& program, std::size_t phase) {
  Costs costs;
  const PhaseVariables& variables = program.phases[phase];
  const std::vector<double> shares = simpson_shares(program.mesh[phase].knots);
  for (std::size_t point = 0; point < shares.size(); ++point) {
    costs.push_back(jet_cost("smooth motion",
                             in_order({numbers_from(variables.points[point].acceleration + 3,
                                                    model.plane.moving_count() - 3),
                                       {variables.duration}}),
                             AccelerationLaw{shares[point]}));
  }
  return costs;
}

}  // namespace

void add_smoothness(const PlanModel& model, FlipProgram& program) {
  for (std::size_t phase = 0; phase < program.phases.size(); ++phase) {
    add_costs(torque_rates(model, program, phase), program);
    add_costs(accelerations(model, program, phase), program);
  }
}

}  // namespace torquewright::hopper
