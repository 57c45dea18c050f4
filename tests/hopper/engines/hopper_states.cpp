// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/engines/hopper_states.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::test {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr std::size_t kFoot = 3;
constexpr double kSole_m = -0.08;  // below the ankle
constexpr double kUnderMass_m = 0.02;

/// Spatial, of a leg in the plane of x and z.
VectorXd posture(double height_m, double pitch_rad, double knee_rad, double ankle_rad) {
  VectorXd q = VectorXd::Zero(10);
  q[2] = height_m;
  q[3] = std::cos(0.5 * pitch_rad);
  q[5] = std::sin(0.5 * pitch_rad);
  q[7] = knee_rad;
  q[8] = ankle_rad;
  return q;
}

/// Numbers of the row of a time that stands there twice: the first of the two.
std::vector<double> row_before_impact(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  std::vector<double> before;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 't') continue;
    std::vector<double> row;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    if (!before.empty() && before[0] == row[0]) return before;
    before = row;
  }
  throw std::runtime_error("no impact in " + file);
}

double lowest_m(const hopper::Robot& robot, const dynamics::TreeState& state) {
  double lowest = 1e9;
  for (const hopper::ContactPoint& contact : robot.contacts) {
    lowest = std::min(lowest, dynamics::point_position_m(state, contact.point).z());
  }
  return lowest;
}

}  // namespace

hopper::Robot hopper_robot() {
  return hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
}

EngineState standing(const hopper::Robot& hopper, double knee_rad) {
  hopper::WholeBody body(hopper);
  EngineState at;
  at.velocity = VectorXd::Zero(9);
  // Turns the thigh until the centre of mass is where it shall be; the foot stays flat.
  double low_rad = -2.0, high_rad = 1.0;
  Vector3d under_m;
  for (int i = 0; i < 60; ++i) {
    const double pitch_rad = 0.5 * (low_rad + high_rad);
    at.position = posture(0.0, pitch_rad, knee_rad, -pitch_rad - knee_rad);
    if (!body.set(at.position, at.velocity)) throw std::runtime_error("unreached");
    const Vector3d ankle_m = dynamics::point_position_m(body.state(), {kFoot, {0, 0, 0}});
    const Vector3d center_m = dynamics::centroid(body.state()).position_m;
    under_m = {center_m.x() - ankle_m.x(), 0.0, kSole_m};
    (under_m.x() < kUnderMass_m ? low_rad : high_rad) = pitch_rad;
  }
  at.position[2] = -lowest_m(hopper, body.state());
  if (!body.set(at.position, at.velocity)) throw std::runtime_error("unreached");
  at.force.resize(9);
  body.inverse_dynamics(at.velocity, at.force);
  const Vector3d weight_N(0, 0, at.force[2]);
  dynamics::add_point_force(body.state(), {kFoot, under_m}, -weight_N, at.force);
  if (at.force.head<6>().norm() > 1e-6) throw std::runtime_error("no equilibrium");
  return at;
}

EngineState flying(const hopper::Robot& hopper) {
  EngineState at;
  at.position = posture(5.0, 0.4, 1.2, -0.6);
  at.position[9] = 0.1;
  at.velocity.resize(9);
  at.velocity << 0.8, -0.1, 2.0, 0.5, 6.0, -0.4, -1.5, 0.5, 0.1;
  hopper::WholeBody body(hopper);
  if (!body.set(at.position, at.velocity)) throw std::runtime_error("unreached");
  at.force = VectorXd::Zero(9);
  at.force.tail<3>() << 2.0, -0.05, 0.02;
  return at;
}

EngineState touching_down(const hopper::Robot& hopper) {
  const std::vector<double> row =
      row_before_impact(TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_flip.csv");
  EngineState at;
  at.position = Eigen::Map<const VectorXd>(row.data() + 1, 10);
  at.velocity = Eigen::Map<const VectorXd>(row.data() + 11, 9);
  at.force = VectorXd::Zero(9);
  dynamics::TreeState state(hopper.tree);
  state.set(at.position, at.velocity);
  at.position[2] -= lowest_m(hopper, state);
  return at;
}

EngineState landing_on_heel(const hopper::Robot& hopper) {
  EngineState at = touching_down(hopper);
  const double half_rad = std::atan2(at.position[5], at.position[3]) - 0.1;
  at.position[3] = std::cos(half_rad);
  at.position[5] = std::sin(half_rad);
  dynamics::TreeState state(hopper.tree);
  state.set(at.position, at.velocity);
  at.position[2] -= lowest_m(hopper, state);
  return at;
}

VectorXd holding_force(const hopper::Engine& engine, const EngineState& about) {
  VectorXd force(about.force.size());
  hold(engine, about, force);
  return force;
}

void hold(const hopper::Engine& engine, const EngineState& about, VectorXd& force) {
  force = about.force;
  const Index joints = 3;
  force.tail(joints) +=
      kSpring_Nm_rad * (about.position.tail(joints) - engine.position().tail(joints)) -
      kDamper_Nm_s_rad * engine.velocity().tail(joints);
}

double energy_J(hopper::WholeBody& body, const VectorXd& position, const VectorXd& velocity) {
  if (!body.set(position, velocity)) throw std::runtime_error("unreached");
  Eigen::MatrixXd mass(velocity.size(), velocity.size());
  body.mass_matrix(mass);
  return 0.5 * velocity.dot(mass * velocity) + dynamics::potential_energy_J(body.state());
}

Vector3d angular_momentum_Nm_s(hopper::WholeBody& body, const VectorXd& position,
                               const VectorXd& velocity) {
  if (!body.set(position, velocity)) throw std::runtime_error("unreached");
  return dynamics::centroid(body.state()).angular_momentum_Nm_s;
}

}  // namespace torquewright::test
