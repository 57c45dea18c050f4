// SPDX-License-Identifier: Apache-2.0
// Ours beside MuJoCo on one robot in one run: a hopper (spatial base, knee, ankle pitch and roll)
// and a humanoid's worth of joints. mj_inverse also prepares what a simulation needs (composite
// inertias, their factors, contacts); so its parts that inverse dynamics needs stand beside it.
#include "dynamics/inverse_dynamics.hpp"

#include <benchmark/benchmark.h>
#include <mujoco/mujoco.h>

#include <cstdio>
#include <map>
#include <memory>

#include "dynamics/mass_matrix.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/dynamics/tree_mjcf.hpp"

namespace torquewright {
namespace {

using Eigen::VectorXd;

constexpr int kStates = 64;

/// A chain where it is small, branches where it is large.
struct Robot {
  explicit Robot(std::size_t joints)
      : tree(drawn(joints)), state(tree), mujoco(test::mjcf_of(tree)) {
    oracles::Dice dice(3);
    for (int i = 0; i < kStates; ++i) {
      positions.push_back(test::random_position(dice, tree));
      velocities.push_back(test::uniform_vector(dice, tree.velocity_size(), 10));
      accelerations.push_back(test::uniform_vector(dice, tree.velocity_size(), 50));
    }
    force.resize(tree.velocity_size());
    mass.resize(tree.velocity_size(), tree.velocity_size());
    mujoco.model().opt.enableflags = 0;  // no energies
  }

  static dynamics::Tree drawn(std::size_t joints) {
    oracles::Dice dice(2);
    dynamics::Tree tree = test::random_tree(dice, dynamics::BaseKind::kSpatial, joints);
    for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
      tree.bodies[i].joint.kind = dynamics::JointKind::kRevolute;
      if (joints < 5) tree.bodies[i].parent = i - 1;
    }
    return tree;
  }

  dynamics::Tree tree;
  dynamics::TreeState state;
  test::MujocoEngine mujoco;
  std::vector<VectorXd> positions;
  std::vector<VectorXd> velocities;
  std::vector<VectorXd> accelerations;
  VectorXd force;
  Eigen::MatrixXd mass;
};

Robot& robot(std::int64_t joints) {
  static std::map<std::int64_t, std::unique_ptr<Robot>> robots;
  auto& made = robots[joints];
  if (!made) made = std::make_unique<Robot>(static_cast<std::size_t>(joints));
  return *made;
}

void ours(benchmark::State& run) {
  Robot& of = robot(run.range(0));
  std::size_t i = 0;
  for (auto _ : run) {
    of.state.set(of.positions[i], of.velocities[i]);
    dynamics::inverse_dynamics(of.state, of.accelerations[i], of.force);
    benchmark::DoNotOptimize(of.force.data());
    i = (i + 1) % kStates;
  }
}

void ours_mass_matrix(benchmark::State& run) {
  Robot& of = robot(run.range(0));
  std::size_t i = 0;
  for (auto _ : run) {
    of.state.set(of.positions[i], of.velocities[i]);
    dynamics::mass_matrix(of.state, of.mass);
    benchmark::DoNotOptimize(of.mass.data());
    i = (i + 1) % kStates;
  }
}

template <typename Inverse>
void theirs(benchmark::State& run, const Inverse& inverse) {
  Robot& of = robot(run.range(0));
  mjData& data = of.mujoco.data();
  std::size_t i = 0;
  for (auto _ : run) {
    std::copy_n(of.positions[i].data(), of.mujoco.nq(), data.qpos);
    std::copy_n(of.velocities[i].data(), of.mujoco.nv(), data.qvel);
    std::copy_n(of.accelerations[i].data(), of.mujoco.nv(), data.qacc);
    inverse(of.mujoco.model(), data, of.force);
    benchmark::DoNotOptimize(data.qfrc_inverse);
    i = (i + 1) % kStates;
  }
}

void mj_inverse_whole(benchmark::State& run) {
  theirs(run, [](const mjModel& model, mjData& data, VectorXd&) { mj_inverse(&model, &data); });
}

/// mj_rne leaves out reflected inertia.
void mj_rne_alone(benchmark::State& run) {
  theirs(run, [](const mjModel& model, mjData& data, VectorXd& force) {
    mj_kinematics(&model, &data);
    mj_comPos(&model, &data);
    mj_comVel(&model, &data);
    mj_rne(&model, &data, 1, force.data());
  });
}

/// Prints as usual, and keeps each benchmark's smallest CPU time.
class Ratios : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      double& least_ns = least_ns_[run.run_name.function_name + "/" + run.run_name.args];
      const double ns = run.GetAdjustedCPUTime();
      if (least_ns == 0 || ns < least_ns) least_ns = ns;
    }
  }
  void print() const {
    for (const char* joints : {"/3", "/30"}) {
      const double ours_ns = least_ns_.at(std::string("ours") + joints);
      std::printf("%s joints and a spatial base: mj_inverse %.1f times ours, mj_rne %.1f times\n",
                  joints + 1, least_ns_.at(std::string("mj_inverse_whole") + joints) / ours_ns,
                  least_ns_.at(std::string("mj_rne_alone") + joints) / ours_ns);
    }
  }

 private:
  std::map<std::string, double> least_ns_;
};

BENCHMARK(ours)->Arg(3)->Arg(30)->Repetitions(5);
BENCHMARK(mj_inverse_whole)->Arg(3)->Arg(30)->Repetitions(5);
BENCHMARK(mj_rne_alone)->Arg(3)->Arg(30)->Repetitions(5);
BENCHMARK(ours_mass_matrix)->Arg(3)->Arg(30)->Repetitions(5);

}  // namespace
}  // namespace torquewright

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  torquewright::Ratios ratios;
  benchmark::RunSpecifiedBenchmarks(&ratios);
  ratios.print();
}
