// SPDX-License-Identifier: Apache-2.0
#include "identification/stepper.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

constexpr int kMostParts = 6;       ///< Stops and starts within one step; the last goes to its end.
constexpr int kStopRounds = 8;      ///< Of approaching a stop.
constexpr double kStopped = 1e-6;   ///< Of the time to it.
constexpr double kAllSpeed = 1e-3;  ///< A speed below this share of what was lost is the stop.

/// From a to b after a time, with the rates of `at`.
void move(RigState& to, const RigState& from, const RigState& rates, const RigMotion& motion,
          double step_s) {
  for (std::size_t j = 0; j < to.joints.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const JointState& a = from.joints[j];
    JointState& b = to.joints[j];
    b.position_rad = a.position_rad + step_s * rates.joints[j].speed_rad_s;
    b.speed_rad_s = a.speed_rad_s + step_s * motion.acceleration_rad_s2[row];
    b.motor_position_rad = a.motor_position_rad + step_s * rates.joints[j].motor_speed_rad_s;
    b.motor_speed_rad_s = a.motor_speed_rad_s + step_s * motion.motor_acceleration_rad_s2[row];
  }
}

/// Speeds that reversed, or belong to a motor that is held, to zero.
void stop_reversed(RigState& state, const std::vector<double>& directions,
                   const std::vector<JointModel>& models) {
  for (std::size_t j = 0; j < state.joints.size(); ++j) {
    JointState& joint = state.joints[j];
    if (directions[j] != 0.0 && joint.motor_speed_rad_s * directions[j] >= 0.0) continue;
    joint.motor_speed_rad_s = 0.0;
    if (!models[j].is_elastic()) joint.speed_rad_s = 0.0;
  }
}

/// How much of the part that led from `from` to `to` it takes until the first motor stops, if it
/// slows down evenly; 1 or more: none stops within it.
double share_to_stop(const RigState& from, const RigState& to, const std::vector<double>& ways) {
  double share = 2.0;
  for (std::size_t j = 0; j < ways.size(); ++j) {
    const double before = from.joints[j].motor_speed_rad_s * ways[j];
    const double after = to.joints[j].motor_speed_rad_s * ways[j];
    if (before > 0.0 && after < before) share = std::min(share, before / (before - after));
  }
  return share;
}

/// Motors that lost nearly all their speed have stopped.
void stop_slowed(const RigState& from, RigState& to, const std::vector<JointModel>& models) {
  for (std::size_t j = 0; j < models.size(); ++j) {
    JointState& joint = to.joints[j];
    const double before = from.joints[j].motor_speed_rad_s;
    if (std::abs(joint.motor_speed_rad_s) >
        kAllSpeed * std::abs(before - joint.motor_speed_rad_s)) {
      continue;
    }
    joint.motor_speed_rad_s = 0.0;
    if (!models[j].is_elastic()) joint.speed_rad_s = 0.0;
  }
}

}  // namespace

Stepper::Stepper(const LoadDynamics& load, const std::vector<JointModel>& models)
    : load_(load),
      models_(models),
      position_(load.joint_count()),
      speed_(load.joint_count()),
      bias_(load.joint_count()),
      mass_(load.joint_count(), load.joint_count()) {}

void Stepper::set_positions(const RigState& state) {
  for (std::size_t j = 0; j < state.joints.size(); ++j) {
    position_[static_cast<Eigen::Index>(j)] = state.joints[j].position_rad;
    speed_[static_cast<Eigen::Index>(j)] = state.joints[j].speed_rad_s;
  }
}

void Stepper::solve(const RigState& state, const std::vector<double>& directions,
                    RigMotion& motion) {
  set_positions(state);
  load_.mass_matrix(position_, mass_);
  load_.bias(position_, speed_, bias_);
  const Eigen::Index joints = load_.joint_count();
  // Through the gear the torque on the load is monotone and piecewise linear in the acceleration:
  // guess each gear's side, solve, correct the guess. Eq. (3).
  std::vector<bool> positive(state.joints.size());
  for (std::size_t j = 0; j < positive.size(); ++j)
    positive[j] = motion.forces[j].before_mesh_Nm > 0.0;
  for (Eigen::Index round = 0; round < 2 * joints + 2; ++round) {
    Eigen::MatrixXd left = mass_;
    Eigen::VectorXd right = -bias_;
    for (Eigen::Index j = 0; j < joints; ++j) {
      const auto index = static_cast<std::size_t>(j);
      const JointModel& model = models_[index];
      const JointForces& forces = motion.forces[index];
      if (model.is_elastic()) {
        const double twist_Nm = model.twist(state.joints[index]).torque_Nm;
        right[j] += twist_Nm * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
        continue;
      }
      if (directions[index] == 0.0) {
        left.row(j).setZero();
        left(j, j) = 1.0;
        right[j] = 0.0;
        continue;
      }
      const double gain = forces.gain(positive[index]) * (1.0 + forces.ripple_ratio);
      // A gear that locks takes any torque: what is before it balances. Large stands for infinite.
      const double slope = std::isfinite(gain) ? gain : 1e9;
      left(j, j) += slope * model.inertia_kg_m2();
      right[j] += slope * forces.before_mesh_Nm + forces.ripple_Nm;
    }
    motion.acceleration_rad_s2 = joints == 1 ? Eigen::VectorXd(right / left(0, 0))
                                             : Eigen::VectorXd(left.partialPivLu().solve(right));
    bool agrees = true;
    for (std::size_t j = 0; j < positive.size(); ++j) {
      if (models_[j].is_elastic() || directions[j] == 0.0) continue;
      const double net =
          motion.forces[j].before_mesh_Nm -
          models_[j].inertia_kg_m2() * motion.acceleration_rad_s2[static_cast<Eigen::Index>(j)];
      if ((net > 0.0) == positive[j]) continue;
      positive[j] = !positive[j];
      agrees = false;
    }
    if (agrees) break;
  }
  motion.torque_Nm = mass_ * motion.acceleration_rad_s2 + bias_;
}

RigMotion Stepper::motion(const RigState& state, const std::vector<double>& directions,
                          const std::vector<DriveNow>& drive,
                          const Eigen::VectorXd* imposed_rad_s2) {
  RigMotion motion;
  for (std::size_t j = 0; j < models_.size(); ++j) {
    motion.forces.push_back(models_[j].forces(state.joints[j], directions[j], drive[j]));
  }
  if (imposed_rad_s2 == nullptr) {
    solve(state, directions, motion);
  } else {
    motion.acceleration_rad_s2 = *imposed_rad_s2;
    motion.torque_Nm.resize(imposed_rad_s2->size());
  }
  motion.motor_acceleration_rad_s2 = motion.acceleration_rad_s2;
  for (std::size_t j = 0; j < models_.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const JointForces& forces = motion.forces[j];
    const double inertia = models_[j].inertia_kg_m2();
    if (models_[j].is_elastic()) {
      const double twist_Nm = models_[j].twist(state.joints[j]).torque_Nm;
      const double carried_Nm = models_[j].carried_Nm(twist_Nm, directions[j]);
      motion.motor_acceleration_rad_s2[row] =
          directions[j] == 0.0 ? 0.0 : (forces.before_mesh_Nm - carried_Nm) / inertia;
      if (imposed_rad_s2 != nullptr) {
        motion.torque_Nm[row] = twist_Nm * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
      }
    } else if (imposed_rad_s2 != nullptr) {
      const double net = forces.before_mesh_Nm - inertia * (*imposed_rad_s2)[row];
      motion.torque_Nm[row] =
          net * forces.gain(net > 0.0) * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
    }
  }
  return motion;
}

/// Lets go the held joint whose torque is furthest beyond what friction can hold.
bool Stepper::release_one(const RigState& state, const std::vector<DriveNow>& drive,
                          std::vector<double>& directions) {
  RigMotion held;
  for (std::size_t j = 0; j < models_.size(); ++j) {
    held.forces.push_back(models_[j].forces(state.joints[j], directions[j], drive[j]));
  }
  if (!load_.is_imposed()) solve(state, directions, held);
  double furthest = 0.0;
  std::size_t which = models_.size();
  double way = 0.0;
  for (std::size_t j = 0; j < models_.size(); ++j) {
    if (directions[j] != 0.0) continue;
    if (load_.is_imposed() && !models_[j].is_elastic()) continue;
    for (const double direction : {1.0, -1.0}) {
      const JointForces forces = models_[j].forces(state.joints[j], direction, drive[j]);
      double beyond = 0.0;
      if (models_[j].is_elastic()) {
        const double twist_Nm = models_[j].twist(state.joints[j]).torque_Nm;
        beyond = direction * (forces.before_mesh_Nm - models_[j].carried_Nm(twist_Nm, direction));
      } else {
        // What is before the mesh may be nothing; a gear that locks then holds whatever drives
        // back.
        const double before = forces.before_mesh_Nm;
        const double gain =
            before == 0.0 ? forces.gain(direction < 0.0) : forces.gain(before > 0.0);
        if (before == 0.0 && !std::isfinite(gain)) continue;
        const double reached = before * gain * (1.0 + forces.ripple_ratio) + forces.ripple_Nm;
        beyond = direction * (reached - held.torque_Nm[static_cast<Eigen::Index>(j)]);
      }
      if (beyond > furthest) {
        furthest = beyond;
        which = j;
        way = direction;
      }
    }
  }
  if (which == models_.size()) return false;
  directions[which] = way;
  return true;
}

std::vector<double> Stepper::directions(const RigState& state, const std::vector<DriveNow>& drive) {
  std::vector<double> directions;
  bool some_rest = false;
  for (const JointState& joint : state.joints) {
    directions.push_back(sign_of(joint.motor_speed_rad_s));
    some_rest = some_rest || directions.back() == 0.0;
  }
  while (some_rest && release_one(state, drive, directions)) {
    some_rest = std::find(directions.begin(), directions.end(), 0.0) != directions.end();
  }
  return directions;
}

void Stepper::account(const RigState& at, const RigMotion& motion, double step_s,
                      WorkAccount& work) const {
  for (std::size_t j = 0; j < models_.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const JointState& joint = at.joints[j];
    const JointForces& forces = motion.forces[j];
    const double motor_moved = step_s * joint.motor_speed_rad_s;
    const double moved = step_s * joint.speed_rad_s;
    const double ripple_Nm = forces.ripple_Nm + forces.ripple_ratio / (1.0 + forces.ripple_ratio) *
                                                    (motion.torque_Nm[row] - forces.ripple_Nm);
    const double through_Nm = motion.torque_Nm[row] - ripple_Nm;
    const double net_Nm =
        forces.before_mesh_Nm - models_[j].inertia_kg_m2() * motion.motor_acceleration_rad_s2[row];
    work.motor_J += forces.motor_Nm * motor_moved;
    work.friction_J -= forces.friction_Nm * motor_moved;
    work.periodic_J += forces.cogging_Nm * motor_moved + ripple_Nm * moved;
    work.mesh_J += (net_Nm - through_Nm) * motor_moved;
    if (models_[j].is_elastic()) {
      work.damper_J += models_[j].twist(joint).damping_Nm * (motor_moved - moved);
    }
    if (load_.is_imposed()) work.load_J -= motion.torque_Nm[row] * moved;
  }
}

void Stepper::advance(RigState& state, const std::vector<DriveNow>& drive, double step_s,
                      WorkAccount& work) {
  double left_s = step_s;
  for (int part = 0; part < kMostParts && left_s > 0.0; ++part) {
    const std::vector<double> ways = directions(state, drive);
    RigState middle = state;
    RigState end = state;
    RigMotion motion = this->motion(state, ways, drive, nullptr);
    const auto midpoint = [&](double part_s) {
      const RigMotion first = this->motion(state, ways, drive, nullptr);
      move(middle, state, state, first, 0.5 * part_s);
      stop_reversed(middle, ways, models_);
      motion = this->motion(middle, ways, drive, nullptr);
      move(end, state, middle, motion, part_s);
    };
    midpoint(left_s);
    double part_s = left_s;
    if (part + 1 < kMostParts && share_to_stop(state, end, ways) < 1.0) {
      // The earliest stop within the part ends it there. The rates on the way to it differ from
      // those of the whole part, so it is approached.
      for (int round = 0; round < kStopRounds; ++round) {
        const double share = share_to_stop(state, end, ways);
        if (std::abs(share - 1.0) < kStopped) break;
        part_s = std::min(left_s, part_s * share);
        midpoint(part_s);
      }
      stop_slowed(state, end, models_);
    } else {
      stop_reversed(end, ways, models_);
    }
    account(middle, motion, part_s, work);
    state = end;
    left_s -= part_s;
  }
}

void Stepper::advance_imposed(RigState& state, const std::vector<DriveNow>& drive, double step_s,
                              const JointState& middle, const JointState& end,
                              double acceleration_rad_s2, WorkAccount& work) {
  JointState& joint = state.joints[0];
  const Eigen::VectorXd imposed = Eigen::VectorXd::Constant(1, acceleration_rad_s2);
  RigState at = state;
  JointState& half = at.joints[0];
  if (!models_[0].is_elastic()) {
    half.position_rad = half.motor_position_rad = middle.position_rad;
    half.speed_rad_s = half.motor_speed_rad_s = middle.speed_rad_s;
    const RigMotion mid = motion(at, {sign_of(middle.speed_rad_s)}, drive, &imposed);
    account(at, mid, step_s, work);
    joint.position_rad = joint.motor_position_rad = end.position_rad;
    joint.speed_rad_s = joint.motor_speed_rad_s = end.speed_rad_s;
    return;
  }
  const std::vector<double> ways = directions(state, drive);
  const RigMotion first = motion(state, ways, drive, &imposed);
  half.position_rad = middle.position_rad;
  half.speed_rad_s = middle.speed_rad_s;
  half.motor_position_rad += 0.5 * step_s * joint.motor_speed_rad_s;
  half.motor_speed_rad_s += 0.5 * step_s * first.motor_acceleration_rad_s2[0];
  if (half.motor_speed_rad_s * ways[0] <= 0.0) half.motor_speed_rad_s = 0.0;
  const RigMotion mid = motion(at, ways, drive, &imposed);
  account(at, mid, step_s, work);
  joint.motor_position_rad += step_s * half.motor_speed_rad_s;
  const double speed = joint.motor_speed_rad_s + step_s * mid.motor_acceleration_rad_s2[0];
  joint.motor_speed_rad_s = ways[0] == 0.0 || speed * ways[0] < 0.0 ? 0.0 : speed;
  joint.position_rad = end.position_rad;
  joint.speed_rad_s = end.speed_rad_s;
}

}  // namespace torquewright::identification
