// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/logs/simulated_hop.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/point.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/touching_point.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/tree_mjcf.hpp"

namespace torquewright::test {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStep_s = 2.5e-4;
constexpr double kFrom_s = 0.2;  // it has settled on the ground
constexpr double kUntil_s = 1.3;
constexpr double kBall_m = 1e-3;

/// Times and shares of the fold between which it moves, smoothly.
double fold_at(const PublicHopper& hopper, double time_s) {
  struct Knot {
    double time_s;
    double share;
  };
  const std::array knots{Knot{0.25, 1.0},
                         Knot{0.5, hopper.crouch},
                         Knot{0.53, hopper.crouch},
                         Knot{0.63, hopper.stretch},
                         Knot{0.66, hopper.stretch},
                         Knot{0.8, 1.0}};
  if (time_s <= knots.front().time_s) return 1.0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (time_s > knots[i].time_s) continue;
    const double x = (time_s - knots[i - 1].time_s) / (knots[i].time_s - knots[i - 1].time_s);
    return knots[i - 1].share +
           (knots[i].share - knots[i - 1].share) * x * x * x * (10 - 15 * x + 6 * x * x);
  }
  return 1.0;
}

class Simulation {
 public:
  explicit Simulation(const PublicHopper& hopper)
      : hopper_(hopper),
        mujoco_(hopper::mjcf_of(hopper.robot, {.ground = true, .collisions = true}).text),
        rows_(rows_of_mujoco(hopper.robot.tree)),
        state_(hopper.robot.tree),
        base_(hopper.robot.tree.base_velocity_size()),
        joints_(hopper.robot.tree.velocity_size() - base_) {
    mujoco_.model().opt.timestep = kStep_s;
    mujoco_.model().opt.integrator = mjINT_RK4;
    mujoco_.model().opt.disableflags |= mjDSBL_LIMIT;  // their forces are no torque of a drive
    for (const hopper::ContactPoint& contact : hopper.robot.contacts) {
      const int site = mj_name2id(&mujoco_.model(), mjOBJ_SITE, contact.name.c_str());
      sites_.push_back(site);
    }
    stand_up();
  }

  SimulatedHop run() {
    SimulatedHop hop;
    hop.step_s = kStep_s;
    const auto from = static_cast<int>(std::lround(kFrom_s / kStep_s));
    const auto until = static_cast<int>(std::lround(kUntil_s / kStep_s));
    allocate(until - from + 1, hop);
    for (int step = 0; step <= until; ++step) {
      control(step * kStep_s);
      mj_forward(&mujoco_.model(), &mujoco_.data());
      if (step >= from) record(step - from, (step - from) * kStep_s, hop);
      mj_step(&mujoco_.model(), &mujoco_.data());
    }
    return hop;
  }

 private:
  const dynamics::Tree& tree() const { return hopper_.robot.tree; }
  mjData& data() { return mujoco_.data(); }
  Index extra() const { return tree().position_size() - tree().velocity_size(); }

  double reference(Index joint, double time_s) const {
    const std::string& name = tree().bodies[static_cast<std::size_t>(joint) + 1].joint.name;
    const auto fold = hopper_.fold.find(name);
    if (fold != hopper_.fold.end()) return fold->second * fold_at(hopper_, time_s);
    const auto stand = hopper_.stand.find(name);
    return stand == hopper_.stand.end() ? 0.0 : stand->second;
  }

  /// The lowest ball on the ground.
  void stand_up() {
    VectorXd q = VectorXd::Zero(tree().position_size());
    if (tree().base == dynamics::BaseKind::kSpatial) q[3] = 1.0;
    for (Index joint = 0; joint < joints_; ++joint) {
      q[base_ + extra() + joint] = reference(joint, 0.0);
    }
    state_.set(q, VectorXd::Zero(tree().velocity_size()));
    double lowest_m = 1e9;
    for (const hopper::ContactPoint& contact : hopper_.robot.contacts) {
      const dynamics::BodyPoint point = hopper::touching_point(contact, state_);
      const double below_m = contact.radius_m > 0.0 ? 0.0 : kBall_m;
      lowest_m = std::min(lowest_m, dynamics::point_position_m(state_, point).z() - below_m);
    }
    q[tree().base == dynamics::BaseKind::kPlanar ? 1 : 2] = -lowest_m;
    for (Index i = 0; i < base_ + extra(); ++i) data().qpos[i] = q[i];
    for (Index i = base_; i < base_ + joints_; ++i) {
      data().qpos[i + extra()] = q[rows_[static_cast<std::size_t>(i)] + extra()];
    }
  }

  /// Theirs of our row of velocity.
  Index theirs(Index row) const {
    const auto at = std::find(rows_.begin(), rows_.end(), row);
    return at == rows_.end() ? row : at - rows_.begin();
  }

  void control(double time_s) {
    for (Index joint = 0; joint < joints_; ++joint) {
      const Index at = theirs(base_ + joint);
      data().qfrc_applied[at] =
          hopper_.spring_Nm_rad * (reference(joint, time_s) - data().qpos[at + extra()]) -
          hopper_.damper_Nm_s_rad * data().qvel[at];
    }
  }

  void allocate(Index samples, SimulatedHop& hop) {
    hopper::Motion& motion = hop.motion;
    const auto contacts = static_cast<Index>(hopper_.robot.contacts.size());
    motion.times_s.resize(static_cast<std::size_t>(samples));
    motion.positions.setZero(tree().position_size(), samples);
    motion.velocities.setZero(tree().velocity_size(), samples);
    motion.accelerations.setZero(tree().velocity_size(), samples);
    motion.efforts.setZero(joints_, samples);
    motion.forces_N.setZero(3 * contacts, samples);
    motion.touching.setZero(contacts, samples);
    motion.has_effort.assign(static_cast<std::size_t>(joints_), true);
    motion.has_forces = motion.has_touching = true;
    motion.file = hopper_.name + ".csv";
    hop.angular_momentum_Nm_s.setZero(3, samples);
  }

  void record(Index sample, double time_s, SimulatedHop& hop) {
    hopper::Motion& motion = hop.motion;
    motion.times_s[static_cast<std::size_t>(sample)] = time_s;
    for (Index row = 0; row < tree().velocity_size(); ++row) {
      const Index at = theirs(row);
      motion.velocities(row, sample) = data().qvel[at];
      motion.accelerations(row, sample) = data().qacc[at];
      if (row < base_) continue;
      motion.positions(row + extra(), sample) = data().qpos[at + extra()];
      motion.efforts(row - base_, sample) = data().qfrc_applied[at];
    }
    for (Index i = 0; i < base_ + extra(); ++i) motion.positions(i, sample) = data().qpos[i];
    mj_subtreeVel(&mujoco_.model(), &mujoco_.data());
    hop.angular_momentum_Nm_s.col(sample) = mujoco_.angular_momentum_Nm_s();
    record_contacts(sample, motion);
  }

  void record_contacts(Index sample, hopper::Motion& motion) {
    for (int i = 0; i < data().ncon; ++i) {
      const mjContact& contact = data().contact[i];
      mjtNum wrench[6];
      mj_contactForce(&mujoco_.model(), &mujoco_.data(), i, wrench);
      Vector3d force_N = Vector3d::Zero();
      for (int axis = 0; axis < 3; ++axis) {
        force_N += wrench[axis] * Eigen::Map<const Vector3d>(contact.frame + 3 * axis);
      }
      const bool ground_first = mujoco_.model().geom_type[contact.geom1] == mjGEOM_PLANE;
      const Index point = nearest_point(Eigen::Map<const Vector3d>(contact.pos));
      motion.forces_N.block<3, 1>(3 * point, sample) += (ground_first ? 1.0 : -1.0) * force_N;
      motion.touching(point, sample) = 1.0;
    }
  }

  Index nearest_point(const Vector3d& place_m) {
    Index nearest = 0;
    double least_m = 1e9;
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      const Vector3d site_m = Eigen::Map<const Vector3d>(data().site_xpos + 3 * sites_[i]);
      const double away_m = (site_m - place_m).norm();
      if (away_m >= least_m) continue;
      least_m = away_m;
      nearest = static_cast<Index>(i);
    }
    return nearest;
  }

  const PublicHopper& hopper_;
  MujocoEngine mujoco_;
  std::vector<Index> rows_;  ///< Ours of each of theirs.
  dynamics::TreeState state_;
  Index base_;
  Index joints_;
  std::vector<int> sites_;
};

}  // namespace

SimulatedHop simulate_hop(const PublicHopper& hopper) { return Simulation(hopper).run(); }

}  // namespace torquewright::test
