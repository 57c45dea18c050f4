// SPDX-License-Identifier: Apache-2.0
// A robot's drives on their battery, a step at a time: what region, sag and heat cost a simulation
// beside what it may cost (the robot in fifty times real time at steps of 0.1 ms is 2 us a step, of
// all of it). A step of drives that reach no limit, one of drives that do, and the first run of a
// motion, which makes the tables.
#include "hopper/replay/powered_drives.hpp"

#include <benchmark/benchmark.h>

#include "actuator/effects/library.hpp"
#include "actuator/mor/clip_table.hpp"
#include "hopper/demand/contact_search.hpp"
#include "hopper/demand/demand.hpp"
#include "hopper/demand/drive_reports.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kStep_s = 1e-4;

std::string specs(const char* file) {
  return std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/") + file;
}

/// What the hand-made flip asks of the hopper's drives.
struct Flip {
  Robot robot = read_robot(specs("robot/hopper.json")).robot;
  Eigen::MatrixXd torque_Nm;
  Eigen::MatrixXd speed_rad_s;

  Flip() {
    Motion motion = read_motion(robot, {specs("trajectory/hopper_flip.csv"), {}, {}, {}});
    const ContactSchedule contacts = find_contacts(robot, {}, motion);
    const Demand demand = demand_of(robot, motion, contacts);
    torque_Nm = torques_by_dynamics(demand);
    speed_rad_s.resizeLike(torque_Nm);
    for (Eigen::Index i = 0; i < torque_Nm.rows(); ++i) {
      for (Eigen::Index k = 0; k < torque_Nm.cols(); ++k) {
        speed_rad_s(i, k) =
            demand.drives[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)].speed_rad_s;
      }
    }
  }
};

using Change = void (*)(actuator::Actuator&);

Robot with(Robot robot, Change change) {
  for (Drivetrain& drivetrain : robot.drivetrains) {
    for (actuator::Actuator& actuator : drivetrain.actuators) change(actuator);
  }
  return robot;
}

actuator::Effect effect(const char* name, std::vector<double> values) {
  return {actuator::find_effect(name), std::move(values), {}, false, "bench"};
}

void add_friction_and_heat(actuator::Actuator& actuator) {
  actuator.thermal = actuator::Thermal{0.5, 1.0, 100.0, 500.0, 400.0};
  actuator.effects = {effect("torque_constant_saturation", {60.0, 2.0}),
                      effect("coulomb_friction", {2.0}), effect("viscous_friction", {0.2}),
                      effect("load_dependent_friction", {0.05, 0.05})};
}

void add_field_weakening(actuator::Actuator& actuator) {
  actuator.motor.inductance_d_H = actuator.motor.inductance_q_H = 1e-4;
  actuator.drive.field_weakening = true;
}

/// What makes a region most costly.
void add_everything(actuator::Actuator& actuator) {
  add_friction_and_heat(actuator);
  add_field_weakening(actuator);
  actuator.motor.inductance_q_H = 2e-4;
  actuator.effects.push_back(effect("inverter_dead_time", {0.8}));
}

/// The flip over and over, its torques so many times as great.
void steps(benchmark::State& state, const Robot& robot, double times) {
  static const Flip flip;
  PoweredDrives drives(robot, {});
  const Eigen::MatrixXd torque_Nm = times * flip.torque_Nm;
  Eigen::Index sample = 0;
  Eigen::VectorXd wanted_Nm, speed_rad_s;
  const Eigen::VectorXd rest_rad = Eigen::VectorXd::Zero(torque_Nm.rows());
  double sum_W = 0.0;
  for (Eigen::Index k = 0; k < 2 * torque_Nm.cols(); ++k) {  // makes the tables
    drives.drive(torque_Nm.col(k % torque_Nm.cols()), rest_rad,
                 flip.speed_rad_s.col(k % torque_Nm.cols()), kStep_s);
  }
  for (auto _ : state) {
    wanted_Nm = torque_Nm.col(sample);
    speed_rad_s = flip.speed_rad_s.col(sample);
    sum_W += drives.drive(wanted_Nm, rest_rad, speed_rad_s, kStep_s).power_W;
    sample = sample + 1 == torque_Nm.cols() ? 0 : sample + 1;
  }
  benchmark::DoNotOptimize(sum_W);
}

/// What a step may not do without: a clip of every drive, at one voltage and temperature.
void clips(benchmark::State& state, const Robot& robot) {
  static const Flip flip;
  std::vector<actuator::ClipTable> tables;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const actuator::Actuator& actuator : drivetrain.actuators) {
      tables.emplace_back(mor_table(actuator::Region(actuator, {})));
    }
  }
  Eigen::Index sample = 0;
  double sum_Nm = 0.0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < tables.size(); ++i) {
      const auto drive = static_cast<Eigen::Index>(i);
      sum_Nm += actuator::clip(tables[i].view(), flip.speed_rad_s(drive, sample),
                               flip.torque_Nm(drive, sample));
    }
    sample = sample + 1 == flip.torque_Nm.cols() ? 0 : sample + 1;
  }
  benchmark::DoNotOptimize(sum_Nm);
}

void first_run(benchmark::State& state, const Robot& robot) {
  static const Flip flip;
  for (auto _ : state) {
    PoweredDrives drives(robot, {});
    const Eigen::VectorXd rest_rad = Eigen::VectorXd::Zero(flip.torque_Nm.rows());
    for (Eigen::Index k = 0; k < flip.torque_Nm.cols(); ++k) {
      drives.drive(flip.torque_Nm.col(k), rest_rad, flip.speed_rad_s.col(k), kStep_s);
    }
  }
}

void no_change(actuator::Actuator&) {}

struct Kind {
  const char* name;
  Change change;
};
constexpr Kind kKinds[] = {{"as_stated", no_change},
                           {"friction_saturation_heat", add_friction_and_heat},
                           {"field_weakening", add_field_weakening},
                           {"everything", add_everything}};

void register_all() {
  const Robot hopper = read_robot(specs("robot/hopper.json")).robot;
  benchmark::RegisterBenchmark("clips_alone", clips, hopper);
  for (const auto& [name, change] : kKinds) {
    const Robot robot = with(hopper, change);
    const std::string kind = name;
    benchmark::RegisterBenchmark(("step/" + kind).c_str(), steps, robot, 1.0);
    benchmark::RegisterBenchmark(("step_at_limits/" + kind).c_str(), steps, robot, 10.0);
    benchmark::RegisterBenchmark(("first_run/" + kind).c_str(), first_run, robot)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace torquewright::hopper

int main(int argc, char** argv) {
  torquewright::hopper::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
