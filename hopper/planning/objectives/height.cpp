// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/every_objective.hpp"
#include "hopper/planning/objectives/flight_phase.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kTypical_m = 0.65;  // apex of the hopper's flip of least effort

/// Where the mass would come to rest, falling freely: exact in the frame of the mass. Variables:
/// its height at take-off, how fast it rises.
struct ApexLaw {
  double gravity_m_s2;
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    rows[0] = factor * (x[0] + x[1] * x[1] * (0.5 / gravity_m_s2));
  }
};

struct RiseLaw {
  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    rows[0] = x[0];
  }
};

constexpr int kUp = 1;  // row of z in a frame
constexpr double kSpeed_m_s = 5.0;

std::unique_ptr<const optimization::Rows> apex(const PlanModel& model, const FlipProgram& program,
                                               double factor) {
  const PointVariables& take_off = longest_flight(program, "height").points.front();
  return jet_cost("height", {take_off.position + kUp, take_off.velocity + kUp},
                  ApexLaw{model.plane.robot.tree.gravity_m_s2, factor});
}

/// Who falls from the begin on has the apex there, and the law's would be over it.
void add(const PlanModel& model, const PlanOptions&, double weight, FlipProgram& program) {
  program.program.add_cost(apex(model, program, -weight * kTypicalCost / kTypical_m));
  const int rise = longest_flight(program, "height").points.front().velocity + kUp;
  program.program.add_rows(jet_rows("take-off upwards", {rise},
                                    {{0.0, std::numeric_limits<double>::infinity()}}, {kSpeed_m_s},
                                    RiseLaw{}));
}

double value(const PlanModel& model, const PlanOptions&, const FlipProgram& program,
             const std::vector<double>& values) {
  const auto rows = apex(model, program, 1.0);
  Eigen::VectorXd take_off = optimization::gathered(*rows, values);
  take_off[1] = std::max(take_off[1], 0.0);
  Eigen::VectorXd height_m(1);
  rows->values(take_off, height_m);
  return height_m[0];
}

}  // namespace

const Objective objectives::height{
    "height", "highest apex of the centre of mass over the ground, in the longest flight", "m", add,
    value};

}  // namespace torquewright::hopper
