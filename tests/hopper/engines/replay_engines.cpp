// SPDX-License-Identifier: Apache-2.0
// Both engines of the replay beside each other in one run, on specs/robot/hopper.json: standing
// under joint springs, landing on the heel, flight. And MuJoCo alone (mj_step of what robot export
// writes), whose rotors are frozen. CPU time of this thread; the least of several rounds each.
//   replay_engines
#include <fmt/core.h>
#include <mujoco/mujoco.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "dynamics/position_step.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/hopper/engines/hopper_states.hpp"

namespace torquewright::bench {
namespace {

using Eigen::VectorXd;
using hopper::Engine;
using hopper::EngineOutcome;
using test::EngineState;

constexpr int kRounds = 7;

double cpu_s() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double least_s(const std::function<void()>& round) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRounds; ++i) {
    const double from = cpu_s();
    round();
    least = std::min(least, cpu_s() - from);
  }
  return least;
}

struct Scene {
  const char* name;
  EngineState from;
  double duration_s;
  bool is_held;
};

/// Of a step, force included.
double step_s(Engine& engine, const Scene& scene, double step) {
  const int steps = static_cast<int>(scene.duration_s / step + 0.5);
  VectorXd force = scene.from.force;
  return least_s([&] {
           engine.start(scene.from.position, scene.from.velocity);
           for (int i = 0; i < steps; ++i) {
             if (scene.is_held) test::hold(engine, scene.from, force);
             if (engine.step(force, step) != EngineOutcome::kStepped) {
               throw std::runtime_error("a step failed");
             }
           }
         }) /
         steps;
}

/// mj_step alone on the exported file, no control.
double mj_step_s(const hopper::Robot& robot, const Scene& scene, double step) {
  test::MujocoEngine mujoco(hopper::mjcf_of(robot, {.ground = true, .collisions = true}).text);
  mujoco.model().opt.timestep = step;
  mujoco.model().opt.enableflags = 0;
  const int steps = static_cast<int>(scene.duration_s / step + 0.5);
  return least_s([&] {
           mj_resetData(&mujoco.model(), &mujoco.data());
           std::copy_n(scene.from.position.data(), 10, mujoco.data().qpos);
           std::copy_n(scene.from.velocity.data(), 9, mujoco.data().qvel);
           std::copy_n(scene.from.force.data(), 9, mujoco.data().qfrc_applied);
           for (int i = 0; i < steps; ++i) mj_step(&mujoco.model(), &mujoco.data());
         }) /
         steps;
}

/// What the own engine asks of the dynamics in a step with contact, once.
double dynamics_s(const hopper::Robot& robot, const Scene& scene) {
  constexpr int kTimes = 20000;
  hopper::WholeBody body(robot);
  Eigen::MatrixXd mass(9, 9);
  VectorXd bias(9);
  const VectorXd rest = VectorXd::Zero(9);
  Eigen::LLT<Eigen::MatrixXd> factors(9);
  return least_s([&] {
           for (int i = 0; i < kTimes; ++i) {
             if (!body.set(scene.from.position, scene.from.velocity)) return;
             body.mass_matrix(mass);
             body.inverse_dynamics(rest, bias);
             factors.compute(mass);
             bias = scene.from.force - bias;
             factors.solveInPlace(bias);
           }
         }) /
         kTimes;
}

/// Where a landing of 0.1 s under joint springs ends, and J^T of the ground's impulses in it.
struct Landed {
  VectorXd position;
  VectorXd impulse;
};

Landed landed(Engine& engine, const EngineState& from, int steps) {
  constexpr double kDuration_s = 0.1;
  VectorXd force = from.force;
  Landed sum{{}, VectorXd::Zero(from.velocity.size())};
  engine.start(from.position, from.velocity);
  for (int i = 0; i < steps; ++i) {
    test::hold(engine, from, force);
    if (engine.step(force, kDuration_s / steps) != EngineOutcome::kStepped) {
      throw std::runtime_error("a step failed");
    }
    sum.impulse += engine.generalised_impulse();
  }
  sum.position = engine.position();
  return sum;
}

/// Against a step of 1/320 ms.
void print_convergence(Engine& own, const hopper::Robot& robot) {
  fmt::print(
      "\n| landing | step, ms | farthest off, degrees | loads off, % |\n|---|---|---|---|\n");
  const std::array<std::pair<const char*, EngineState>, 2> landings{
      {{"flat", test::touching_down(robot)}, {"heel", test::landing_on_heel(robot)}}};
  for (const auto& [name, from] : landings) {
    const Landed exact = landed(own, from, 32000);
    for (const int steps : {50, 100, 200, 500, 1000, 2000}) {
      const Landed found = landed(own, from, steps);
      VectorXd off(from.velocity.size());
      dynamics::position_difference(robot.tree, exact.position, found.position, off);
      fmt::print("| {} | {} | {:.3f} | {:.2f} |\n", name, 100.0 / steps,
                 off.tail(6).cwiseAbs().maxCoeff() * 180.0 / std::numbers::pi,
                 100.0 * (found.impulse - exact.impulse).norm() / exact.impulse.norm());
    }
  }
}

void run() {
  const hopper::Robot robot = test::hopper_robot();
  const auto own = hopper::own_engine(robot, {});
  const auto mujoco = hopper::mujoco_engine(robot, {});
  const std::array<Scene, 3> scenes{{{"standing", test::standing(robot, 1.2), 1.0, true},
                                     {"landing", test::landing_on_heel(robot), 0.2, true},
                                     {"flight", test::flying(robot), 0.4, false}}};
  fmt::print(
      "| scene | step, ms | own, us | times real time | MuJoCo's engine, us | over own | mj_step "
      "alone, us | over own | own: dynamics |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const Scene& scene : scenes) {
    for (const double step : {1e-4, 5e-4}) {
      const double ours = step_s(*own, scene, step);
      const double theirs = step_s(*mujoco, scene, step);
      const double alone = mj_step_s(robot, scene, step);
      const double evaluations = scene.is_held ? 1.0 : 4.0;
      fmt::print("| {} | {} | {:.2f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} % |\n",
                 scene.name, step * 1e3, ours * 1e6, step / ours, theirs * 1e6, theirs / ours,
                 alone * 1e6, alone / ours, 100.0 * evaluations * dynamics_s(robot, scene) / ours);
    }
  }
  print_convergence(*own, robot);
}

}  // namespace
}  // namespace torquewright::bench

int main() {
  torquewright::bench::run();
  return 0;
}
