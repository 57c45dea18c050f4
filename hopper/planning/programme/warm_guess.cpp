// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/warm_guess.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hopper/contact/contact_schedule.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kInPlane = 1e-3;    // rad, m: of what must not leave the plane
constexpr double kChatter_s = 4e-3;  // a shorter contact or loss of it is none

/// Samples of one stance, both ends within.
struct Run {
  std::string stance;
  Index from = 0;
  Index until = 0;
};

class Reader {
 public:
  Reader(const Robot& robot, const PlanModel& model, const Motion& motion, const std::string& file)
      : robot_(robot), model_(model), motion_(motion), file_(file) {
    if (!motion.has_base) io::refuse(file, "has no motion of the base: nothing to begin from");
  }

  VectorXd planar_position(Index sample) {
    const auto from = motion_.positions.col(sample);
    const Index joints = robot_.tree.velocity_size() - robot_.tree.base_velocity_size();
    VectorXd out(3 + joints);
    out.tail(joints) = from.tail(joints);
    if (robot_.tree.base == dynamics::BaseKind::kPlanar) {
      out.head<3>() = from.head<3>();
    } else {
      if (std::abs(from[1]) > kInPlane || std::abs(from[4]) > kInPlane ||
          std::abs(from[6]) > kInPlane) {
        io::refuse(file_, fmt::format("leaves the sagittal plane at t = {} s",
                                      io::time_text(motion_.time_s(sample), 4)));
      }
      double pitch = 2.0 * std::atan2(from[5], from[3]);
      pitch += 2.0 * std::numbers::pi * std::round((pitch_ - pitch) / (2.0 * std::numbers::pi));
      pitch_ = pitch;
      out.head<3>() << from[0], from[2], pitch;
    }
    return held(out);
  }
  VectorXd planar_rate(const Eigen::MatrixXd& rates, Index sample) const {
    if (robot_.tree.base == dynamics::BaseKind::kPlanar) return held(rates.col(sample));
    const auto from = rates.col(sample);
    VectorXd out(from.size() - 3);
    out << from[0], from[2], from[4], from.tail(from.size() - 6);
    return held(out);
  }

 private:
  /// What does not move in the plane stays at 0.
  VectorXd held(VectorXd rows) const {
    for (const Index row : model_.plane.held) rows[row] = 0.0;
    return rows;
  }

  const Robot& robot_;
  const PlanModel& model_;
  const Motion& motion_;
  const std::string& file_;
  double pitch_ = 0.0;
};

std::string stance_at(const PlanModel& model, const ContactSchedule& contacts, Index sample) {
  std::vector<std::size_t> touching;
  for (std::size_t i = 0; i < model.plane.sole.size(); ++i) {
    const auto& members = model.plane.sole[i].members;
    const bool touches = std::any_of(members.begin(), members.end(), [&](std::size_t member) {
      return contacts.touches(static_cast<Index>(member), sample);
    });
    if (touches) touching.push_back(i);
  }
  if (touching.empty()) return "flight";
  if (touching.size() > 1 || model.plane.sole.size() == 1) return "flat";
  return model.plane.sole[touching.front()].name;
}

std::vector<Run> runs_of(const PlanModel& model, const Motion& motion,
                         const ContactSchedule& contacts) {
  std::vector<Run> runs;
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    const std::string stance = stance_at(model, contacts, sample);
    if (runs.empty() || runs.back().stance != stance) runs.push_back({stance, sample, sample});
    runs.back().until = sample;
  }
  std::vector<Run> out;
  for (const Run& run : runs) {
    const bool is_short = motion.time_s(run.until) - motion.time_s(run.from) < kChatter_s;
    if (!out.empty() && (is_short || out.back().stance == run.stance)) {
      out.back().until = run.until;
    } else {
      out.push_back(run);
    }
  }
  return out;
}

/// By contact point of the robot.
std::vector<bool> touching(const SagittalRobot& plane, const Stance& stance) {
  std::vector<bool> out(plane.robot.contacts.size(), false);
  for (const std::size_t point : stance.points) {
    for (const std::size_t member : plane.sole[point].members) out[member] = true;
  }
  return out;
}

/// Borne alike by all that touch.
Eigen::Matrix3Xd shared_weight_N(const std::vector<bool>& touches, double weight_N) {
  const auto count = std::count(touches.begin(), touches.end(), true);
  Eigen::Matrix3Xd out = Eigen::Matrix3Xd::Zero(3, static_cast<Index>(touches.size()));
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (touches[i]) out(2, static_cast<Index>(i)) = weight_N / static_cast<double>(count);
  }
  return out;
}

void require_order(const std::vector<Run>& runs, const std::vector<Stance>& stances,
                   const std::string& file) {
  std::vector<std::string> found, wanted;
  for (const Run& run : runs) found.push_back(run.stance);
  for (const Stance& stance : stances) wanted.push_back(stance.name);
  if (found == wanted) return;
  io::refuse(file, fmt::format("stands as {}; planned is {} (--contacts)", fmt::join(found, ", "),
                               fmt::join(wanted, ", ")));
}

void require_rows(const Robot& robot, const Motion& motion, const std::string& file) {
  if (motion.positions.rows() == robot.tree.position_size() &&
      motion.velocities.rows() == robot.tree.velocity_size()) {
    return;
  }
  io::refuse(file, fmt::format("is a motion of another robot: {} positions and {} velocities a "
                               "sample, where {} has {} and {}",
                               motion.positions.rows(), motion.velocities.rows(), robot.name,
                               robot.tree.position_size(), robot.tree.velocity_size()));
}

}  // namespace

PlannedMotion warm_guess(const Robot& robot, const PlanModel& model,
                         const std::vector<Stance>& stances, const Motion& motion,
                         const ContactRule& contact, const std::string& file) {
  require_rows(robot, motion, file);
  Motion known = motion;
  Reader reader(robot, model, known, file);
  const ContactSchedule contacts = schedule_contacts(robot, contact, known);
  std::vector<Run> runs = runs_of(model, known, contacts);
  require_order(runs, stances, file);
  PlannedMotion out;
  for (std::size_t p = 0; p < runs.size(); ++p) {
    const std::vector<bool> touches = touching(model.plane, stances[p]);
    PlannedPhase phase{runs[p].stance, touches, {}};
    // Up to the next phase's first sample, unless an impact lies between.
    const bool shares_end = p + 1 < runs.size() && !known.is_break(runs[p + 1].from);
    for (Index sample = runs[p].from; sample <= runs[p].until + (shares_end ? 1 : 0); ++sample) {
      const TreeMotion rows = frame_motion(
          model.plane, phase.frame(),
          {reader.planar_position(sample), reader.planar_rate(known.velocities, sample),
           reader.planar_rate(known.accelerations, sample)});
      PlannedInstant instant;
      instant.time_s = known.time_s(sample);
      instant.position = rows.position;
      instant.velocity = rows.velocity;
      instant.acceleration = rows.acceleration;
      instant.drive_Nm = VectorXd::Zero(static_cast<Index>(model.plane.drive_count()));
      instant.contact_N = shared_weight_N(touches, model.weight_N);
      phase.instants.push_back(std::move(instant));
    }
    if (phase.instants.size() < 2) {
      io::refuse(file, fmt::format("has a single sample while it stands as '{}'", phase.stance));
    }
    out.phases.push_back(std::move(phase));
  }
  return out;
}

}  // namespace torquewright::hopper
