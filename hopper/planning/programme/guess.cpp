// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/guess.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "hopper/planning/programme/standing.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Of a first guess, which the solver leaves: choices of ours.
constexpr int kInstants = 41;          // of a phase, by whose differences rates are made
constexpr double kHump_m = 0.15;       // height that the base gains in flight
constexpr double kToeUp_rad = 0.2;     // pitch of a foot that stands on its heel
constexpr double kTuckedUntil = 0.35;  // share of the flight by which legs are drawn in

/// What joints and foot do at an instant.
struct Frame {
  VectorXd joints;        ///< Those that move.
  double foot_rad = 0.0;  ///< Of the foot about +y.
};

Frame between(const Frame& a, const Frame& b, double s) {
  const double smooth = s * s * (3.0 - 2.0 * s);
  return {a.joints + smooth * (b.joints - a.joints),
          a.foot_rad + smooth * (b.foot_rad - a.foot_rad)};
}

bool flies_in(const std::vector<MeshPhase>& mesh, std::size_t phase) {
  return phase < mesh.size() && mesh[phase].stance.is_flight();
}

class KeyFrames {
 public:
  KeyFrames(const PlanModel& model, const PlanOptions& options)
      : model_(model), options_(options) {}

  PlannedMotion make(const std::vector<MeshPhase>& mesh, const PlanGoal& goal);

 private:
  VectorXd moving_joints(const Posture& posture) const;
  VectorXd named(const char* name, const VectorXd& otherwise) const;
  VectorXd bent(double share) const;
  Frame standing(const VectorXd& joints) const;
  double tip_rad(const std::vector<MeshPhase>& mesh, std::size_t phase) const;
  VectorXd held(const Frame& frame, std::size_t sole_point, const Eigen::Vector2d& at) const;
  Eigen::Vector2d base(const VectorXd& position) const;
  VectorXd position(const Frame& frame, const Eigen::Vector2d& rear) const;
  double pitch(const VectorXd& position) const;
  double foot_between(const VectorXd& from, const VectorXd& to, const VectorXd& joints,
                      double s) const;
  void into_mass_frame(PlannedPhase& phase) const;
  void perturb(std::vector<Frame>& frames);

  const PlanModel& model_;
  const PlanOptions& options_;
};

/// Rows of the plan, the rearmost point of the sole there.
VectorXd KeyFrames::position(const Frame& frame, const Eigen::Vector2d& rear) const {
  VectorXd moving(model_.plane.moving_count());
  moving << rear, frame.foot_rad, frame.joints;
  return model_.plane.all_rows(moving);
}

/// The base's place.
Eigen::Vector2d KeyFrames::base(const VectorXd& position) const {
  const VectorXd still = VectorXd::Zero(position.size());
  return tree_motion(model_.plane, PlanFrame::kSole, {position, still, still}).position.head<2>();
}

/// A point of the sole kept at a place.
VectorXd KeyFrames::held(const Frame& frame, std::size_t sole_point,
                         const Eigen::Vector2d& at) const {
  const auto& sole = model_.plane.sole;
  const Eigen::Vector3d arm = sole[sole_point].point.p_B_m - sole.front().point.p_B_m;
  const double c = std::cos(frame.foot_rad), s = std::sin(frame.foot_rad);
  return position(frame, {at.x() - c * arm.x() - s * arm.z(), at.y() + s * arm.x() - c * arm.z()});
}

VectorXd KeyFrames::moving_joints(const Posture& posture) const {
  const std::vector<std::size_t>& bodies = model_.plane.joints;
  VectorXd joints(static_cast<Index>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    joints[static_cast<Index>(i)] = posture.joints[static_cast<Index>(bodies[i]) - 1];
  }
  return joints;
}

VectorXd KeyFrames::named(const char* name, const VectorXd& otherwise) const {
  for (const Posture& posture : model_.plane.robot.postures) {
    if (posture.name == name) return moving_joints(posture);
  }
  return otherwise;
}

/// Each joint on the way from 0 to the farther end of its range.
VectorXd KeyFrames::bent(double share) const {
  VectorXd joints(static_cast<Index>(model_.joint_rad.size()));
  for (std::size_t i = 0; i < model_.joint_rad.size(); ++i) {
    const optimization::Bounds& range = model_.joint_rad[i];
    const double far = std::abs(range.upper) > std::abs(range.lower) ? range.upper : range.lower;
    joints[static_cast<Index>(i)] = share * (std::isfinite(far) ? far : 1.0);
  }
  return joints;
}

/// Joints, and the foot as they stand on it.
Frame KeyFrames::standing(const VectorXd& joints) const {
  return {joints, standing_foot_rad(model_.plane, joints)};
}

/// How far the foot has tipped at a phase's end: there it stands, or will, on one end of its sole.
double KeyFrames::tip_rad(const std::vector<MeshPhase>& mesh, std::size_t phase) const {
  const auto by_end = [&](std::size_t of) {
    if (of >= mesh.size() || model_.plane.sole.size() == 1) return 0.0;
    const std::vector<std::size_t>& points = mesh[of].stance.points;
    if (points.size() != 1) return 0.0;
    return points.front() == 0 ? -kToeUp_rad : kToeUp_rad;
  };
  const double next_rad = by_end(phase + 1);
  return next_rad == 0.0 && flies_in(mesh, phase + 1) ? by_end(phase) : next_rad;
}

/// The base's.
double KeyFrames::pitch(const VectorXd& position) const {
  const VectorXd still = VectorXd::Zero(position.size());
  return tree_motion(model_.plane, PlanFrame::kSole, {position, still, still}).position[2];
}

/// The foot's pitch while the base turns evenly and joints stand so.
double KeyFrames::foot_between(const VectorXd& from, const VectorXd& to, const VectorXd& joints,
                               double s) const {
  const double base_rad = pitch(from) + s * (pitch(to) - pitch(from));
  return base_rad - pitch(position({joints, 0.0}, {0.0, 0.0}));
}

void KeyFrames::into_mass_frame(PlannedPhase& phase) const {
  for (PlannedInstant& instant : phase.instants) {
    const TreeMotion tree = tree_motion(model_.plane, PlanFrame::kSole,
                                        {instant.position, instant.velocity, instant.acceleration});
    const TreeMotion mass = frame_motion(model_.plane, PlanFrame::kMass, tree);
    instant.position = mass.position;
    instant.velocity = mass.velocity;
    instant.acceleration = mass.acceleration;
  }
}

void KeyFrames::perturb(std::vector<Frame>& frames) {
  if (!(options_.guess_noise_rad > 0.0)) return;
  std::mt19937 numbers(options_.guess_seed);
  for (std::size_t f = 1; f + 1 < frames.size(); ++f) {
    for (double& joint : frames[f].joints) {
      const double unit = static_cast<double>(numbers()) / static_cast<double>(std::mt19937::max());
      joint += options_.guess_noise_rad * (2.0 * unit - 1.0);
    }
  }
}

PlannedMotion KeyFrames::make(const std::vector<MeshPhase>& mesh, const PlanGoal& goal) {
  const Posture* stand = standing_posture(model_.plane.robot.postures);
  const Frame crouch = standing(balanced(model_, stand ? moving_joints(*stand) : bent(0.5)));
  const Frame take_off = standing(named("takeoff", bent(0.5)));
  const VectorXd tuck = goal.turn_rad != 0.0 ? named("tuck", bent(0.95)) : take_off.joints;
  const auto first_flight = std::find_if(
      mesh.begin(), mesh.end(), [](const MeshPhase& phase) { return phase.stance.is_flight(); });
  const auto flight = static_cast<std::size_t>(first_flight - mesh.begin());
  // Frames at the phases' ends.
  std::vector<Frame> ends{crouch};
  for (std::size_t p = 0; p < mesh.size(); ++p) {
    Frame frame = crouch;
    if (flies_in(mesh, p + 1)) {
      frame = take_off;
    } else if (flies_in(mesh, p + 2) && !mesh[p].stance.is_flight()) {
      frame = between(crouch, take_off, 0.5);
    }
    frame.foot_rad += (p < flight ? 0.0 : goal.turn_rad) + tip_rad(mesh, p);
    ends.push_back(frame);
  }
  perturb(ends);
  PlannedMotion out;
  double begin_s = 0.0;
  Eigen::Vector2d foot = {model_.plane.sole.front().point.p_B_m.x(), 0.0};
  VectorXd last_position = held(ends.front(), 0, foot);
  for (std::size_t p = 0; p < mesh.size(); ++p) {
    const double duration_s = mesh[p].guess_s > 0.0
                                  ? mesh[p].guess_s
                                  : 0.5 * (mesh[p].duration_s.lower + mesh[p].duration_s.upper);
    PlannedPhase phase{mesh[p].stance.name, {}, {}};
    const bool flies = mesh[p].stance.is_flight();
    VectorXd landing;
    if (flies) {
      // It lands with the next stance's first point on the ground, as far on as asked for.
      foot.x() += goal.stride_m.value_or(0.0);
      foot.y() = ground_m(goal, mesh, p + 1);
      const std::size_t point = mesh[p + 1].stance.points.front();
      landing = held(ends[p + 1], point,
                     {foot.x() + model_.plane.sole[point].point.p_B_m.x() -
                          model_.plane.sole.front().point.p_B_m.x(),
                      foot.y()});
    }
    for (int i = 0; i < kInstants; ++i) {
      const double s = static_cast<double>(i) / (kInstants - 1);
      PlannedInstant instant;
      instant.time_s = begin_s + s * duration_s;
      Frame frame = between(ends[p], ends[p + 1], s);
      if (flies) {
        frame.joints = s < kTuckedUntil ? between(ends[p], {tuck, 0.0}, s / kTuckedUntil).joints
                                        : between({tuck, 0.0}, ends[p + 1],
                                                  (s - kTuckedUntil) / (1.0 - kTuckedUntil))
                                              .joints;
        // The base goes straight, with a hump; the foot as the joints say.
        frame.foot_rad = foot_between(last_position, landing, frame.joints, s);
        instant.position = position(frame, {0.0, 0.0});
        const Eigen::Vector2d from = base(last_position), to = base(landing);
        Eigen::Vector2d at = from + s * (to - from);
        at.y() += kHump_m * 4.0 * s * (1.0 - s);
        instant.position.head<2>() = at - base(instant.position);
      } else {
        const std::size_t point = mesh[p].stance.points.front();
        const double x = foot.x() + model_.plane.sole[point].point.p_B_m.x() -
                         model_.plane.sole.front().point.p_B_m.x();
        instant.position = held(frame, point, {x, foot.y()});
      }
      const Index n = instant.position.size();
      instant.velocity = instant.acceleration = VectorXd::Zero(n);
      instant.drive_Nm = VectorXd::Zero(static_cast<Index>(model_.plane.drive_count()));
      instant.contact_N =
          Eigen::Matrix3Xd::Zero(3, static_cast<Index>(model_.plane.robot.contacts.size()));
      std::size_t members = 0;
      for (const std::size_t one : mesh[p].stance.points) {
        members += model_.plane.sole[one].members.size();
      }
      for (const std::size_t one : mesh[p].stance.points) {
        for (const std::size_t member : model_.plane.sole[one].members) {
          instant.contact_N(2, static_cast<Index>(member)) =
              model_.weight_N / static_cast<double>(members);
        }
      }
      phase.instants.push_back(std::move(instant));
    }
    const double step_s = duration_s / (kInstants - 1);
    for (int i = 0; i < kInstants; ++i) {
      const auto at = [&](int k) -> const VectorXd& {
        return phase.instants[static_cast<std::size_t>(std::clamp(k, 0, kInstants - 1))].position;
      };
      const int low = std::max(i - 1, 0), high = std::min(i + 1, kInstants - 1);
      phase.instants[static_cast<std::size_t>(i)].velocity =
          (at(high) - at(low)) / (step_s * (high - low));
    }
    last_position = phase.instants.back().position;
    if (flies) into_mass_frame(phase);
    begin_s += duration_s;
    out.phases.push_back(std::move(phase));
  }
  return out;
}

}  // namespace

PlannedMotion key_frame_guess(const PlanModel& model, const std::vector<MeshPhase>& mesh,
                              const PlanGoal& goal, const PlanOptions& options) {
  return KeyFrames(model, options).make(mesh, goal);
}

}  // namespace torquewright::hopper
