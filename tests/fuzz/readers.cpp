// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/readers.hpp"

#include "actuator/motor/actuator_spec.hpp"
#include "actuator/region/joint_region.hpp"
#include "actuator/trajectory/trajectory_reader.hpp"
#include "dynamics/mass_matrix.hpp"
#include "gearbox/problem_spec.hpp"
#include "gearbox/strength/strength_spec.hpp"
#include "gearbox/strength/torque_limit.hpp"
#include "hopper/check/hopper_check.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "hopper/trials/trial.hpp"
#include "io/documents/document.hpp"
#include "io/documents/schema.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/parts/plausible_inertia.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/fuzz/log_readers.hpp"
#include "tests/fuzz/result_reader.hpp"

namespace torquewright::fuzz {
namespace {

namespace fs = std::filesystem;

void read_problem(const fs::path& file) {
  (void)gearbox::read_problem(io::read_document(file, "gearbox_problem"));
}

// What is read must have limits of torque.
void read_strength(const fs::path& file) {
  const gearbox::TorqueLimits limits =
      gearbox::torque_limits(gearbox::read_strength(file).strength);
  if (!(limits.once.motor_Nm > 0.0 && limits.for_cycles.motor_Nm <= limits.once.motor_Nm)) {
    throw Misbehaviour("a limit of torque that is none");
  }
}

// What is read must have a region, or sentences why not; never NaN, never a hang.
void read_actuator(const fs::path& file) {
  const actuator::Actuator read = actuator::read_actuator(file).actuator;
  if (!actuator::objections(read, {}).empty()) return;
  const actuator::Region region(read, {});
  for (const double speed_rad_s : {0.0, 1.0, -100.0}) {
    const actuator::JointRange range = region.at(speed_rad_s);
    if (range.is_empty) continue;
    if (!(range.least.torque_Nm <= range.greatest.torque_Nm))
      throw Misbehaviour("a range whose ends are not in order");
  }
}

// What is read must have a mass matrix of numbers.
void expect_mass_matrix(const dynamics::Tree& tree) {
  dynamics::TreeState state(tree);
  const Eigen::Index size = state.velocity().size();
  Eigen::MatrixXd mass(size, size);
  dynamics::mass_matrix(state, mass);
  if (!mass.allFinite()) throw Misbehaviour("a mass matrix that is not finite");
}

void read_robot(const fs::path& file) { expect_mass_matrix(hopper::read_robot(file).robot.tree); }
void read_urdf(const fs::path& file) { expect_mass_matrix(hopper::read_urdf(file).robot.tree); }
void read_mjcf(const fs::path& file) { expect_mass_matrix(hopper::read_mjcf(file).robot.tree); }

// What is read must be checked with figures, or refused; a walker's motion, its legs undriven.
void read_motion(const fs::path& file) {
  static const hopper::Robot robot =
      hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/rabbit.json").robot;
  hopper::Motion motion = hopper::read_motion(robot, {file, {}, {}, {}});
  hopper::CheckOptions options;
  options.residual_share = 1e12;  // also what is no motion goes through all of it
  const hopper::HopperReport report = hopper::check_motion(robot, motion, options);
  if (!report.demand.forces_N.allFinite() || !report.demand.residual.allFinite()) {
    throw Misbehaviour("forces that are not finite");
  }
}

// What is read and fits must make robots of real bodies.
void read_randomisation(const fs::path& file) {
  static const hopper::Robot robot =
      hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  const hopper::Randomisation read = hopper::read_randomisation(file).randomisation;
  hopper::require_fits(read, robot);
  for (std::size_t number = 0; number < 3; ++number) {
    const hopper::Robot drawn =
        hopper::perturbed(robot, hopper::draw_trial(read, robot, 1, number));
    dynamics::require_tree(drawn.tree);
    for (const dynamics::Body& body : drawn.tree.bodies) {
      if (const auto objection = hopper::inertia_objection(body.inertia.inertia_kg_m2)) {
        throw Misbehaviour("a drawn body that cannot be: " + *objection);
      }
    }
  }
}

void read_trajectory(const fs::path& file) {
  actuator::TrajectoryReader reader(file, {}, {"knee"}, {});
  actuator::Row row;
  while (reader.next(row)) continue;
}

}  // namespace

std::vector<Reader> readers() {
  std::vector<Reader> readers = {
      {"gearbox_problem, read", ".json", read_problem},
      {"gearbox_result, verified", ".json", verify_result},
      {"gear_strength, with its limits", ".json", read_strength},
      {"actuator, with its region", ".json", read_actuator},
      {"robot, with its mass matrix", ".json", read_robot},
      {"randomisation, with its draws", ".json", read_randomisation},
      {"robot from URDF", ".urdf", read_urdf},
      {"robot from MJCF", ".xml", read_mjcf},
      {"trajectory", ".csv", read_trajectory},
      {"whole-body motion", ".csv", read_motion},
      {"rig, read", ".json", read_rig_document},
      {"log with a fixed rig", ".csv", read_measured_log},
  };
  for (const std::string& kind : io::document_kinds()) {
    readers.push_back(
        {kind, ".json", [kind](const fs::path& file) { (void)io::read_document(file, kind); }});
  }
  return readers;
}

}  // namespace torquewright::fuzz
