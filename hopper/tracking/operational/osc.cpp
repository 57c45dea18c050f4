// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/operational/osc.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "hopper/tracking/drive_ranges.hpp"
#include "hopper/tracking/every_controller.hpp"
#include "hopper/tracking/impact_invariant.hpp"
#include "hopper/tracking/operational/torque_program.hpp"
#include "hopper/tracking/velocity_error.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Sums of a task's residuals over the looks at which it was active.
struct Residuals {
  double sum_of_squares = 0.0;
  long looks = 0;
  double worst = 0.0;
  double worst_s = 0.0;
};

class OperationalController final : public Controller {
 public:
  OperationalController(const Robot& robot, const Reference& reference,
                        std::shared_ptr<const OperationalTasks> tasks,
                        std::shared_ptr<const DriveRanges> ranges, const TrackingOptions& options)
      : robot_(robot),
        reference_(reference),
        tasks_(std::move(tasks)),
        impact_(options.impact),
        ranges_(std::move(ranges)),
        clock_(reference, options.clock),
        frame_(robot, tasks_->rigid),
        program_(robot, *tasks_) {}

  std::string_view name() const override { return "osc"; }

  void start() override {
    clock_.start();
    program_.start();
    residuals_.assign(tasks_->tasks.size(), {});
    slow_rates_.resize(0);
    looks_ = unsolved_ = 0;
  }

  void control(const Observation& seen, VectorXd& torque_Nm) override {
    const ClockReading reading = clock_.read(seen.time_s, seen.touches);
    instant_at(reference_, robot_.tree, reading, wanted_);
    fed_forward_Nm_ = hopper::fed_forward_Nm(reference_, reading, seen.latency_s, seen.hold_s);
    const TouchingPoints touches = reference_.modes()[reference_.mode_at(reading.time_s)].touches;
    ++looks_;
    torque_Nm = fed_forward_Nm_;
    if (!frame_.set(wanted_, touches, seen.position, seen.velocity)) {
      ++unsolved_;
      return;
    }
    VectorXd speed_rad_s(torque_Nm.size());
    frame_.body().speed_changes(frame_.velocity(), speed_rad_s);
    ranges_->at(speed_rad_s, seen.bus_V, seen.winding_K, bounds_.least_Nm, bounds_.greatest_Nm);
    follow_springs(seen.time_s);
    frame_.rows(tasks_->tasks, rows_);
    handle_impacts(reading);
    const VectorXd wanted = rows_.acceleration +
                            rows_.stiffness_1_s2.cwiseProduct(rows_.place_error) +
                            rows_.damping_1_s.cwiseProduct(rows_.rate_error);
    const auto status = program_.solve(frame_, rows_, wanted, touches, bounds_);
    if (status == optimization::QuadraticStatus::kSolved && program_.torque_Nm().allFinite()) {
      // What rounding leaves of a bound is taken away.
      torque_Nm = program_.torque_Nm();
      note_residuals(seen.time_s, wanted);
    } else {
      ++unsolved_;
    }
    torque_Nm = torque_Nm.cwiseMin(bounds_.greatest_Nm).cwiseMax(bounds_.least_Nm);
  }

  const VectorXd& fed_forward_Nm() const override { return fed_forward_Nm_; }

  ControlAccount account() const override {
    ControlAccount account{{}, looks_, unsolved_};
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
      const OperationalTask& task = tasks_->tasks[i];
      const Residuals& one = residuals_[i];
      const double mean = one.looks > 0 ? one.sum_of_squares / static_cast<double>(one.looks) : 0.0;
      account.tasks.push_back(
          {words_of(task, robot_), unit_of(task), std::sqrt(mean), one.worst, one.worst_s});
    }
    return account;
  }

 private:
  std::string unit_of(const OperationalTask& task) const {
    const bool is_slide = task.kind == TaskKind::kJoint &&
                          robot_.tree.bodies[task.of].joint.kind == dynamics::JointKind::kPrismatic;
    const bool turns = task.kind == TaskKind::kBaseAttitude || task.kind == TaskKind::kJoint;
    return turns && !is_slide ? "rad/s^2" : "m/s^2";
  }

  /// Rates of rigid springs that are slow enough are fed back, eq. (10).
  void follow_springs(double time_s) {
    if (tasks_->rigid_rate_time_s <= 0.0) return;
    const VectorXd rates = frame_.springs() * frame_.velocity();
    if (slow_rates_.size() == 0) {
      slow_rates_ = rates;
    } else {
      const double past = (time_s - followed_s_) / tasks_->rigid_rate_time_s;
      slow_rates_ += (1.0 - std::exp(-past)) * (rates - slow_rates_);
    }
    followed_s_ = time_s;
    frame_.let_springs_turn(slow_rates_);
  }

  /// What of the tasks' errors of rates an impulse of the coming contact may change is blended out,
  /// over all active tasks at once.
  void handle_impacts(const ClockReading& reading) {
    if (impact_.handling == ImpactHandling::kDefault || rows_.size() == 0) return;
    const auto mode = reference_.nearest_impact(reading.time_s);
    if (!mode) return;
    const double from_impact_s =
        reading.time_s + reading.waited_s - reference_.modes()[*mode].from_s;
    if (impact_blend(impact_, from_impact_s) == 0.0) return;
    const ContactRows landing =
        contact_rows(robot_, frame_.body().state(),
                     landing_points(robot_, reference_, *mode, impact_.whole_foot));
    handle_impact(impact_, from_impact_s,
                  impact_map(frame_.mass(), landing.jacobian, rows_.jacobian, frame_.springs(),
                             VectorXd::Zero(frame_.velocity().size())),
                  rows_.rate_error);
  }

  void note_residuals(double time_s, const VectorXd& wanted) {
    const VectorXd off = rows_.jacobian * program_.acceleration() + rows_.bias - wanted;
    for (Index first = 0; first < off.size();) {
      const std::size_t task = rows_.task_of[static_cast<std::size_t>(first)];
      double square = 0.0;
      for (; first < off.size() && rows_.task_of[static_cast<std::size_t>(first)] == task;
           ++first) {
        square += off[first] * off[first];
      }
      Residuals& sum = residuals_[task];
      sum.sum_of_squares += square;
      ++sum.looks;
      if (std::sqrt(square) <= sum.worst) continue;
      sum.worst = std::sqrt(square);
      sum.worst_s = time_s;
    }
  }

  const Robot& robot_;
  const Reference& reference_;
  std::shared_ptr<const OperationalTasks> tasks_;
  ImpactOptions impact_;
  std::shared_ptr<const DriveRanges> ranges_;
  ReferenceClock clock_;
  TaskFrame frame_;
  TorqueProgram program_;
  ReferenceInstant wanted_;
  TaskRows rows_;
  TorqueBounds bounds_;
  VectorXd fed_forward_Nm_;
  VectorXd slow_rates_;      ///< (springs x 1) of rigid springs; empty before the first look,
  double followed_s_ = 0.0;  ///< and when they were.
  std::vector<Residuals> residuals_;
  long looks_ = 0, unsolved_ = 0;
};

}  // namespace

std::unique_ptr<Controller> operational_controller(const Robot& robot, const Reference& reference,
                                                   std::shared_ptr<const OperationalTasks> tasks,
                                                   std::shared_ptr<const DriveRanges> ranges,
                                                   const TrackingOptions& options) {
  return std::make_unique<OperationalController>(robot, reference, std::move(tasks),
                                                 std::move(ranges), options);
}

}  // namespace torquewright::hopper

namespace torquewright::hopper::controllers {
namespace {

class ReadyOsc final : public ReadyController {
 public:
  ReadyOsc(const Robot& robot, const Reference& reference, const TrackingOptions& options)
      : robot_(robot),
        reference_(reference),
        options_(options),
        tasks_(options.tasks ? options.tasks
                             : std::make_shared<const OperationalTasks>(usual_tasks(robot))),
        ranges_(options.make_ranges()) {
    options_.make_ranges = {};  // what it refers to may be gone later
  }

  std::unique_ptr<Controller> make() const override {
    return operational_controller(robot_, reference_, tasks_, ranges_, options_);
  }

 private:
  const Robot& robot_;
  const Reference& reference_;
  TrackingOptions options_;
  std::shared_ptr<const OperationalTasks> tasks_;
  std::shared_ptr<const DriveRanges> ranges_;
};

std::unique_ptr<const ReadyController> prepare_osc(const Robot& robot, const Reference& reference,
                                                   const TrackingOptions& options) {
  // The tasks' rows depend on each other, and have no inertia of their own.
  if (options.impact.metric == ImpactMetric::kInertia) {
    io::refuse("--impact-metric",
               "is euclidean with --controller osc: inertia needs rates that do "
               "not depend on each other, as tasks' do");
  }
  return std::make_unique<const ReadyOsc>(robot, reference, options);
}

}  // namespace

const ControllerKind osc = {
    .name = "osc",
    .sentence =
        "operational-space control: tasks weighed against each other in the drives' regions",
    .has_tasks = true,
    .prepare = prepare_osc};

}  // namespace torquewright::hopper::controllers
