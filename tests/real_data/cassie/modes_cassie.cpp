// SPDX-License-Identifier: Apache-2.0
// How small deviations of Cassie go on that stands under a controller's document: each mode's rate
// in 1/s, and which velocities have most of it.
//   modes_cassie CONTROLLER
#include <fmt/core.h>

#include <cstddef>
#include <exception>
#include <memory>
#include <string>

#include "hopper/check/hopper_check.hpp"
#include "hopper/replay/powered_drives.hpp"
#include "hopper/tracking/operational/osc.hpp"
#include "hopper/tracking/operational/tasks_spec.hpp"
#include "tests/real_data/cassie/cassie.hpp"
#include "tests/real_data/cassie/cassie_jump.hpp"
#include "tests/real_data/cassie/standing_modes.hpp"

namespace torquewright::bench {
namespace {

constexpr double kNamed = 0.25;     // of a mode's greatest part
constexpr double kFast_1_s = 60.0;  // decays faster than what is told

std::string name_of(const hopper::Robot& robot, Eigen::Index row) {
  constexpr const char* kBase[] = {"x", "y", "z", "roll", "pitch", "yaw"};
  if (row < test::kCassieBase) return kBase[row];
  return robot.tree.bodies[static_cast<std::size_t>(row - test::kCassieBase) + 1].joint.name;
}

void print(const hopper::Robot& robot, const test::StandingModes& modes) {
  const Eigen::Index n = robot.tree.velocity_size();
  for (Eigen::Index i = 0; i < modes.rates_1_s.size(); ++i) {
    const auto rate_1_s = modes.rates_1_s[i];
    if (rate_1_s.imag() < 0.0 || rate_1_s.real() < -kFast_1_s) continue;
    fmt::print("{:+9.3f} {:+9.3f}i:", rate_1_s.real(), rate_1_s.imag());
    const Eigen::VectorXd parts = modes.shapes.col(i).head(n).cwiseAbs();
    for (Eigen::Index row = 0; row < n; ++row) {
      if (parts[row] < kNamed * parts.maxCoeff()) continue;
      fmt::print(" {} {:.2f}", name_of(robot, row), parts[row] / parts.maxCoeff());
    }
    fmt::print("\n");
  }
}

void run(const char* file) {
  const hopper::Robot robot = test::cassie();
  hopper::Motion motion =
      test::standing_motion(robot, test::read_jump(test::published_jump_file()), 0.1);
  hopper::CheckOptions check;
  check.residual_share = 2.0;  // springs are rigid in the motion: what they need is left
  const hopper::HopperReport report = hopper::check_motion(robot, motion, check);
  const hopper::Reference reference(robot, motion, report.contacts, report.torques_Nm);
  hopper::ReferenceInstant stands;
  reference.at(0.0, stands);
  const auto tasks =
      std::make_shared<const hopper::OperationalTasks>(hopper::read_tasks(file, robot).tasks);
  hopper::TrackingOptions tracking;
  tracking.impact.handling = hopper::ImpactHandling::kDefault;
  const auto osc = hopper::operational_controller(
      robot, reference, tasks, hopper::drive_ranges(robot, {hopper::DriveLimits::kMor, {}, {}, {}}),
      tracking);
  print(robot, test::standing_modes(robot, stands, *osc,
                                    {0.5 * tracking.control_period_s, tasks->rigid_rate_time_s}));
}

}  // namespace
}  // namespace torquewright::bench

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "modes_cassie CONTROLLER\n");
    return 2;
  }
  try {
    torquewright::bench::run(arguments[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
