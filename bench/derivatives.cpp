// SPDX-License-Identifier: Apache-2.0
// What gradients and second derivatives of a hopper's equations of motion cost beside their value,
// in one run: the seed's hopper in its plane (5 velocities, two contact forces; 15 variables, 11
// without those that nothing depends on) and the slopes of the whole body in space.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/point.hpp"
#include "dynamics/seeds.hpp"
#include "robot/model/linear_dynamics.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright {
namespace {

using dynamics::Jet;
using dynamics::Jet2;
using dynamics::VectorX;
using Eigen::VectorXd;

constexpr int kVelocities = 5;

/// A body on two links, all turning in the plane.
dynamics::Tree planar_hopper() {
  dynamics::Tree tree;
  tree.base = dynamics::BaseKind::kPlanar;
  for (std::size_t i = 0; i < 3; ++i) {
    dynamics::Body body;
    body.name = "body_" + std::to_string(i);
    body.parent = i == 0 ? 0 : i - 1;
    body.joint.p_PB_m = {0.02, 0, -0.35};
    body.inertia = {8.0 - 3.0 * static_cast<double>(i),
                    {0.03, 0, -0.1},
                    Eigen::Vector3d(0.1, 0.12, 0.05).asDiagonal()};
    body.joint.reflected_inertia = 0.1;
    tree.bodies.push_back(body);
  }
  return tree;
}

/// Of x = (x, z, pitch, joints; rates; accelerations).
template <typename T>
void residual(dynamics::TreeStateOf<T>& state, const VectorX<T>& x, VectorX<T>& out) {
  state.set(x.head(kVelocities), x.segment(kVelocities, kVelocities));
  dynamics::inverse_dynamics(state, x.tail(kVelocities), out);
  dynamics::add_point_force(state, {2, {0.1, 0, -0.05}}, {-20, 0, -150}, out);
  dynamics::add_point_force(state, {2, {-0.1, 0, -0.05}}, {-10, 0, -90}, out);
}

VectorXd values() { return VectorXd::LinSpaced(3 * kVelocities, -1, 2); }

/// Variables that are left out are constants.
template <typename T>
VectorX<T> seeded_values(bool all) {
  const VectorXd x = values();
  VectorX<T> out = x.cast<T>();
  int next = 0;
  for (int i = 0; i < 3 * kVelocities; ++i) {
    const bool matters = i >= 2 * kVelocities || i % kVelocities >= 2;  // x, z and their rates
    if (!all && !matters) continue;
    if constexpr (!std::is_same_v<T, double>) out[i] = T::variable(x[i], next++);
  }
  return out;
}

template <typename T>
void planar(benchmark::State& run) {
  dynamics::TreeStateOf<T> state(planar_hopper());
  const VectorX<T> x = seeded_values<T>(run.range(0) == 15);
  VectorX<T> out(kVelocities);
  for (auto _ : run) {
    residual<T>(state, x, out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
}

struct Standing {
  hopper::Robot robot =
      hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  hopper::DynamicsInstant at;
  Standing() {
    const Eigen::Index n = robot.tree.velocity_size();
    at.position = dynamics::zero_position(robot.tree);
    at.position.tail<3>() << 1.0, -0.2, 0.05;
    at.velocity = VectorXd::LinSpaced(n, -2, 3);
    at.acceleration = VectorXd::LinSpaced(n, 9, -8);
    at.drive_Nm =
        VectorXd::Constant(static_cast<Eigen::Index>(hopper::WholeBody(robot).drive_count()), 40);
    at.contact_N.setZero(3, static_cast<Eigen::Index>(robot.contacts.size()));
    at.contact_N.row(2).setConstant(30);
  }
};

/// What differences would evaluate 36 times.
void whole_body_value(benchmark::State& run) {
  const Standing standing;
  hopper::WholeBody body(standing.robot);
  VectorXd force(standing.at.velocity.size());
  for (auto _ : run) {
    benchmark::DoNotOptimize(body.set(standing.at.position, standing.at.velocity));
    body.inverse_dynamics(standing.at.acceleration, force);
    benchmark::DoNotOptimize(force.data());
  }
}

void whole_body_slopes(benchmark::State& run) {
  const Standing standing;
  hopper::LinearDynamics linear(standing.robot);
  hopper::DynamicsSlopes out;
  for (auto _ : run) {
    benchmark::DoNotOptimize(linear.at(standing.at, out));
    benchmark::DoNotOptimize(out.residual_by_position.data());
  }
}

BENCHMARK_TEMPLATE(planar, double)->Arg(15);
BENCHMARK_TEMPLATE(planar, Jet)->Arg(11)->Arg(15);
BENCHMARK_TEMPLATE(planar, Jet2)->Arg(11)->Arg(15);
BENCHMARK(whole_body_value);
BENCHMARK(whole_body_slopes);

}  // namespace
}  // namespace torquewright

BENCHMARK_MAIN();
