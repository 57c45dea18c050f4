// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "dynamics/point.hpp"
#include "hopper/replay/fall.hpp"
#include "robot/model/touching_point.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kControlsBetweenProgress = 100;

/// One run under way.
class Run {
 public:
  Run(const RunParts& parts, const RunOptions& options)
      : parts_(parts),
        options_(options),
        body_(parts.robot),
        force_(parts.robot.tree.velocity_size()),
        drives_(static_cast<Index>(body_.drive_count())) {
    const double span_s = parts.reference.ends_s() - parts.reference.begins_s() + options.stand_s;
    steps_ = static_cast<long>(std::ceil(span_s / options.step_s));
    record_.step_s = options.step_s;
    record_.control_period_s = options.step_s * options.steps_per_control;
    for (VectorXd* of_drives : {&position_, &speed_, &carried_, &wanted_, &contact_})
      of_drives->setZero(drives_);
    for (Eigen::MatrixXd* table : tables()) table->setZero(drives_, steps_);
    record_.steps.times_s.reserve(static_cast<std::size_t>(steps_) + 1);
  }

  Record go() {
    begin();
    for (step_ = 0; step_ < steps_ && record_.end == RunEnd::kDone; ++step_) {
      if (is_look()) look();
      if (step_ % options_.steps_per_control == 0 && !control()) break;
      advance();
    }
    finish();
    return std::move(record_);
  }

 private:
  double time_s() const {
    return parts_.reference.begins_s() + static_cast<double>(step_) * options_.step_s;
  }

  bool is_look() const {
    return (step_ + options_.latency_steps) % options_.steps_per_control == 0;
  }

  void begin() {
    parts_.engine.start(parts_.start.position, parts_.start.velocity);
    parts_.controller.start();
    parts_.drives.start();
    const auto points = static_cast<Index>(parts_.robot.contacts.size());
    // What stands at the start is felt there.
    seen_touches_ = parts_.reference.modes().front().touches;
    row_.touches = TouchingPoints::Constant(points, false);
    row_.impulses_N_s.setZero(3 * points);
    for (VectorXd* of_drives : {&row_.torque_Nm, &row_.cut_off_Nm}) of_drives->setZero(drives_);
    place();
    row_.speed_rad_s = speed_;
    look();
  }

  /// The robot as the engine has it; ends the run where a mechanism does not reach.
  void place() {
    if (!body_.set(parts_.engine.position(), parts_.engine.velocity())) {
      stop(RunEnd::kStopped,
           fmt::format("{} cannot be as the joints stand", body_.unreached().what));
      return;
    }
    body_.drive_positions(position_);
    body_.speed_changes(parts_.engine.velocity(), speed_);
    body_.carried_momenta(parts_.engine.velocity(), carried_);
  }

  void stop(RunEnd end, std::string reason) {
    record_.end = end;
    record_.reason = std::move(reason);
  }

  void look() {
    Observation seen;
    seen.time_s = time_s();
    seen.latency_s = options_.latency_steps * options_.step_s;
    seen.hold_s = record_.control_period_s;
    seen.position = parts_.engine.position();
    seen.velocity = parts_.engine.velocity();
    seen.touches = seen_touches_;
    seen.bus_V = row_.bus_V;
    seen.winding_K = row_.winding_K;
    seen_touches_.setConstant(false);
    if (parts_.sense) parts_.sense(look_number_++, seen);
    looks_.push_back(std::move(seen));
  }

  /// The youngest look that is old enough; false where the run is over.
  bool control() {
    if (parts_.should_stop && parts_.should_stop()) {
      stop(RunEnd::kAsked, "it was asked to stop");
      return false;
    }
    const long newest = step_ - options_.latency_steps;
    while (looks_.size() > 1 && step_of(looks_[1]) <= newest) looks_.pop_front();
    parts_.controller.control(looks_.front(), wanted_);
    if (parts_.gain_factor.size() > 0) {
      const VectorXd& fed_Nm = parts_.controller.fed_forward_Nm();
      wanted_ = fed_Nm + parts_.gain_factor.cwiseProduct(wanted_ - fed_Nm);
    }
    if (!wanted_.allFinite()) {
      wanted_.setZero();
      stop(RunEnd::kStopped, "the controller's torque is no number");
      return false;
    }
    note_row();
    const WalkedGround ground{options_.ground_height_m, options_.profile};
    auto fall = fallen(parts_.robot, body_.state(), ground);
    if (!fall) fall = struck(parts_.robot, body_.state(), ground);
    if (fall) stop(RunEnd::kFell, *fall);
    const long controls = step_ / options_.steps_per_control;
    if (parts_.on_progress && controls % kControlsBetweenProgress == 0) {
      parts_.on_progress(static_cast<double>(step_) / static_cast<double>(steps_));
    }
    return !fall;
  }

  long step_of(const Observation& seen) const {
    return std::lround((seen.time_s - parts_.reference.begins_s()) / options_.step_s);
  }

  void note_row() {
    row_.time_s = time_s();
    row_.position = parts_.engine.position();
    row_.velocity = parts_.engine.velocity();
    row_.wanted_Nm = wanted_;
    row_.speed_rad_s = speed_;
    row_.slip_m_s = 0.0;
    for (Index point = 0; point < row_.touches.size(); ++point) {
      if (!row_.touches[point]) continue;
      const auto& contact = parts_.robot.contacts[static_cast<std::size_t>(point)];
      const dynamics::BodyPoint at = touching_point(contact, body_.state());
      row_.slip_m_s =
          std::max(row_.slip_m_s, dynamics::point_velocity_m_s(body_.state(), at).norm());
    }
    record_.rows.push_back(row_);
    row_.touches.setConstant(false);
    row_.impulses_N_s.setZero();
    row_.cut_off_Nm.setZero();
  }

  void advance() {
    const DriveStep& made = parts_.drives.drive(wanted_, position_, speed_, options_.step_s);
    force_.setZero();
    body_.add_drive_torques(made.torque_Nm, force_);
    add_pushes();
    const EngineOutcome outcome = parts_.engine.step(force_, options_.step_s);
    if (outcome != EngineOutcome::kStepped) {
      stop(RunEnd::kStopped, words_of(outcome));
      return;
    }
    if (made.is_starved) ++record_.starved_steps;
    note_step(made);
  }

  void add_pushes() {
    for (const Push& push : options_.pushes) {
      // Rounding may leave a time that is a whole number of steps just below it.
      const double since_s = push.time_s - parts_.reference.begins_s();
      if (static_cast<long>(std::floor(since_s / options_.step_s + 1e-6)) != step_) continue;
      add_push(body_.state(), push, options_.step_s, force_);
    }
  }

  void note_step(const DriveStep& made) {
    const Index column = step_;
    body_.at_actuators(parts_.engine.generalised_impulse(), contact_);
    DriveSteps& steps = record_.steps;
    if (steps.times_s.empty()) steps.times_s.push_back(time_s());
    steps.speed_before_rad_s.col(column) = speed_;
    steps.torque_Nm.col(column) = made.torque_Nm;
    steps.contact_Nm_s.col(column) = contact_;
    steps.carried_Nm_s.col(column) = -carried_;
    place();
    steps.speed_after_rad_s.col(column) = speed_;
    steps.carried_Nm_s.col(column) += carried_;
    steps.times_s.push_back(time_s() + options_.step_s);
    if (column == 0) record_.rows.front().torque_Nm = made.torque_Nm;
    row_.torque_Nm = made.torque_Nm;
    row_.bus_V = made.bus_V;
    row_.winding_K = made.winding_K;
    note_batteries(made, column == 0);
    for (Index drive = 0; drive < drives_; ++drive) {
      if (std::abs(made.cut_off_Nm[drive]) > std::abs(row_.cut_off_Nm[drive])) {
        row_.cut_off_Nm[drive] = made.cut_off_Nm[drive];
      }
    }
    const VectorXd& impulses = parts_.engine.impulses_N_s();
    row_.impulses_N_s += impulses;
    for (Index point = 0; point < row_.touches.size(); ++point) {
      if (!(impulses[3 * point + 2] > 0.0)) continue;
      row_.touches[point] = true;
      seen_touches_[point] = true;
    }
  }

  void note_batteries(const DriveStep& made, bool is_first) {
    record_.greatest_power_W = std::max(record_.greatest_power_W, made.power_W);
    if (!made.least_bus_V) return;
    if (!is_first && made.least_bus_V >= record_.least_bus_V) return;
    record_.least_bus_V = made.least_bus_V;
    record_.least_bus_s = time_s();
  }

  static std::string words_of(EngineOutcome outcome) {
    switch (outcome) {
      case EngineOutcome::kUnreached:
        return "a mechanism does not reach the posture";
      case EngineOutcome::kUnsolved:
        return "the engine found no impulses that obey the contacts' laws; a shorter --step may";
      default:
        return "the engine's numbers grew without bound; a shorter --step or lower gains may help";
    }
  }

  void finish() {
    record_.end_s = time_s();
    record_.account = parts_.controller.account();
    record_.drawn_Ah = parts_.drives.drawn_Ah();
    const auto made = std::max<Index>(1, static_cast<Index>(record_.steps.times_s.size())) - 1;
    for (Eigen::MatrixXd* table : tables()) table->conservativeResize(drives_, made);
  }

  std::array<Eigen::MatrixXd*, 5> tables() {
    DriveSteps& steps = record_.steps;
    return {&steps.torque_Nm, &steps.speed_before_rad_s, &steps.speed_after_rad_s,
            &steps.contact_Nm_s, &steps.carried_Nm_s};
  }

  const RunParts& parts_;
  const RunOptions& options_;
  WholeBody body_;
  Record record_;
  RecordRow row_;
  long step_ = 0;
  long steps_ = 0;
  VectorXd force_;
  Index drives_;
  VectorXd position_, speed_, carried_, wanted_, contact_;
  TouchingPoints seen_touches_;
  std::deque<Observation> looks_;
  std::uint64_t look_number_ = 0;
};

}  // namespace

Record run_replay(const RunParts& parts, const RunOptions& options) {
  return Run(parts, options).go();
}

}  // namespace torquewright::hopper
