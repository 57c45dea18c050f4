// SPDX-License-Identifier: Apache-2.0
// Functions: MuJoCo's API reference (mujoco.readthedocs.io, APIreference), "Sub components".
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "dynamics/position_step.hpp"
#include "hopper/engines/engine.hpp"
#include "hopper/engines/mujoco_model.hpp"
#include "robot/model/touching_point.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::VectorIn;
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// What MuJoCo cannot go on after: by default it would end the program.
class MujocoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// By default MuJoCo prints, and writes a file where the program runs.
void silence() {
  [[maybe_unused]] static const bool done = [] {
    mju_user_warning = [](const char*) {};
    mju_user_error = [](const char* message) { throw MujocoError(message); };
    return true;
  }();
}

bool is_sound(const mjtNum* numbers, Index size) {
  return std::all_of(numbers, numbers + size, [](mjtNum x) { return std::abs(x) < mjMAXVAL; });
}

/// MuJoCo's dynamics and contact; rotors as the mechanisms turn them, which its constant armature
/// is not, are put into its mass matrix and forces between its own stages.
class MujocoReplayEngine final : public Engine {
 public:
  MujocoReplayEngine(const Robot& robot, const EngineOptions& options)
      : mujoco_(robot, options), body_(robot) {
    const Index size = robot.tree.velocity_size();
    rest_ = rate_force_ = generalised_ = VectorXd::Zero(size);
    rotors_.resize(size, size);
    impulses_N_s_ = VectorXd::Zero(3 * static_cast<Index>(robot.contacts.size()));
    for (Stage& stage : stages_) stage.acceleration.resize(size);
    start(dynamics::zero_position(robot.tree), rest_);
  }

  std::string_view name() const override { return "mujoco"; }

  void start(const VectorIn& position, const VectorIn& velocity) override {
    body_.state().set(position, velocity);  // throws where they are none
    position_.resize(position.size());
    dynamics::step_position(tree(), position, velocity, 0.0, position_);
    velocity_ = velocity;
    mj_resetData(&model(), &data());
    impulses_N_s_.setZero();
    generalised_.setZero();
  }

  EngineOutcome step(const VectorIn& force, double step_s) override {
    dynamics::require_velocity_size(body_.state(), force.size());
    try {
      return try_step(force, step_s);
    } catch (const MujocoError&) {
      mj_resetData(&model(), &data());
      return EngineOutcome::kUnsolved;
    }
  }

  const VectorXd& position() const override { return position_; }
  const VectorXd& velocity() const override { return velocity_; }
  const VectorXd& impulses_N_s() const override { return impulses_N_s_; }
  const VectorXd& generalised_impulse() const override { return generalised_; }

 private:
  /// Of a Runge-Kutta step, as simulation::TimeStepping has it.
  struct Stage {
    VectorXd step, velocity, rate, acceleration;
  };

  const dynamics::Tree& tree() const { return body_.robot().tree; }
  mjModel& model() { return mujoco_.model(); }
  mjData& data() { return mujoco_.data(); }

  EngineOutcome try_step(const VectorIn& force, double step_s) {
    model().opt.timestep = step_s;
    for (mjWarningStat& warning : data().warning) warning.number = 0;
    Stage& first = stages_[0];
    first.velocity = first.rate = velocity_;
    EngineOutcome outcome = accelerate(position_, force, true, first);
    if (outcome != EngineOutcome::kStepped) return outcome;
    return data().nefc == 0 ? fly(force, step_s) : touch(step_s);
  }

  /// MuJoCo's own step of velocities first, then of positions at those.
  EngineOutcome touch(double step_s) {
    rate_ = velocity_ + step_s * stages_[0].acceleration;
    moved(position_, rate_, step_s, next_);
    if (!is_sound(rate_.data(), rate_.size()) || !is_sound(next_.data(), next_.size())) {
      return EngineOutcome::kBlownUp;
    }
    record_contacts(step_s);
    velocity_ = rate_;
    position_ = next_;
    return EngineOutcome::kStepped;
  }

  // docs/derivations/time_stepping.md eqs. (1), (2)
  EngineOutcome fly(const VectorIn& force, double step_s) {
    for (std::size_t i = 1; i < stages_.size(); ++i) {
      const Stage& before = stages_[i - 1];
      Stage& stage = stages_[i];
      const double duration_s = i < 3 ? 0.5 * step_s : step_s;
      stage.step = duration_s * before.rate;
      stage.velocity = velocity_ + duration_s * before.acceleration;
      stage.rate.resize(stage.velocity.size());
      dynamics::step_rate(tree(), stage.step, stage.velocity, stage.rate);
      moved(position_, before.rate, duration_s, next_);
      const EngineOutcome outcome = accelerate(next_, force, false, stage);
      if (outcome != EngineOutcome::kStepped) return outcome;
    }
    const auto& [one, two, three, four] = stages_;
    rate_ = (one.rate + 2.0 * two.rate + 2.0 * three.rate + four.rate) / 6.0;
    moved(position_, rate_, step_s, next_);
    rate_ = velocity_ + step_s / 6.0 *
                            (one.acceleration + 2.0 * two.acceleration + 2.0 * three.acceleration +
                             four.acceleration);
    if (!is_sound(rate_.data(), rate_.size()) || !is_sound(next_.data(), next_.size())) {
      return EngineOutcome::kBlownUp;
    }
    velocity_ = rate_;
    position_ = next_;
    impulses_N_s_.setZero();
    generalised_.setZero();
    return EngineOutcome::kStepped;
  }

  /// By MuJoCo's own integration of positions.
  void moved(const VectorXd& from, const VectorXd& rate, double duration_s, VectorXd& to) {
    put(from, rate);
    mj_integratePos(&model(), data().qpos, data().qvel, duration_s);
    to.resize(from.size());
    for (Index i = 0; i < to.size(); ++i) to[i] = data().qpos[mujoco_.places()[index(i)]];
  }

  void put(const VectorXd& position, const VectorXd& velocity) {
    for (Index i = 0; i < position.size(); ++i) {
      data().qpos[mujoco_.places()[index(i)]] = position[i];
    }
    for (Index i = 0; i < velocity.size(); ++i) {
      data().qvel[mujoco_.dofs()[index(i)]] = velocity[i];
    }
  }

  /// Forward dynamics of a posture, in MuJoCo's order of mj_forward().
  EngineOutcome accelerate(const VectorXd& position, const VectorIn& force, bool meets,
                           Stage& stage) {
    if (!position.allFinite() || !stage.velocity.allFinite()) return EngineOutcome::kBlownUp;
    if (!body_.set(position, stage.velocity)) return EngineOutcome::kUnreached;
    put(position, stage.velocity);
    mjModel* m = &model();
    mjData* d = &data();
    mj_kinematics(m, d);
    mj_comPos(m, d);
    mj_crb(m, d);
    add_rotors();
    mj_factorM(m, d);
    if (meets) {
      mj_collision(m, d);
      mj_makeConstraint(m, d);
      mj_projectConstraint(m, d);
    }
    mj_fwdVelocity(m, d);
    push(force);
    mj_fwdActuation(m, d);
    mj_fwdAcceleration(m, d);
    mj_fwdConstraint(m, d);
    if (d->warning[mjWARN_INERTIA].number > 0 || !is_sound(d->qacc, m->nv)) {
      return EngineOutcome::kBlownUp;
    }
    if (d->warning[mjWARN_CONTACTFULL].number > 0 || d->warning[mjWARN_CNSTRFULL].number > 0) {
      return EngineOutcome::kUnsolved;
    }
    for (Index i = 0; i < stage.acceleration.size(); ++i) {
      stage.acceleration[i] = d->qacc[mujoco_.dofs()[index(i)]];
    }
    return EngineOutcome::kStepped;
  }

  /// A^T I A in place of the armature, docs/derivations/whole_body_check.md eq. (2), and what links
  /// of loops weigh, which no bodies of MuJoCo's are.
  void add_rotors() {
    rotors_.setZero();
    body_.add_rotor_inertia(rotors_);
    body_.add_link_inertia(rotors_);
    for (const MujocoModel::MassEntry& entry : mujoco_.rotor_entries()) {
      data().qM[entry.address] += entry.kept + rotors_(entry.row, entry.column);
    }
  }

  /// The force from outside, less A^T I A' v and what links take.
  void push(const VectorIn& force) {
    rate_force_.setZero();
    body_.add_rotors(rest_, rate_force_);
    body_.add_link_forces(rate_force_);
    for (Index i = 0; i < force.size(); ++i) {
      data().qfrc_applied[mujoco_.dofs()[index(i)]] = force[i] - rate_force_[i];
    }
  }

  /// Impulses at the contact points, and J^T of them where they acted.
  void record_contacts(double step_s) {
    impulses_N_s_.setZero();
    generalised_.setZero();
    for (int i = 0; i < data().ncon; ++i) {
      const mjContact& contact = data().contact[i];
      const int sign = mujoco_.contact_of(contact.geom2) >= 0 ? 1 : -1;
      const int point = mujoco_.contact_of(sign > 0 ? contact.geom2 : contact.geom1);
      if (point < 0 || contact.efc_address < 0) continue;
      std::array<mjtNum, 6> wrench;
      mj_contactForce(&model(), &data(), i, wrench.data());
      // Rows of the frame are its axes; the force is the first geom's on the second.
      Vector3d impulse_N_s = Vector3d::Zero();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        impulse_N_s +=
            sign * step_s * wrench[axis] * Eigen::Map<const Vector3d>(contact.frame + 3 * axis);
      }
      impulses_N_s_.segment<3>(3 * point) += impulse_N_s;
      const ContactPoint& touched = body_.robot().contacts[static_cast<std::size_t>(point)];
      dynamics::add_point_force(body_.state(), touching_point(touched, body_.state()), impulse_N_s,
                                generalised_);
    }
  }

  static std::size_t index(Index i) { return static_cast<std::size_t>(i); }

  MujocoModel mujoco_;
  WholeBody body_;
  VectorXd position_, velocity_;
  VectorXd impulses_N_s_, generalised_;
  std::array<Stage, 4> stages_;
  VectorXd rest_, rate_, next_, rate_force_;
  Eigen::MatrixXd rotors_;
};

}  // namespace

std::unique_ptr<Engine> mujoco_engine(const Robot& robot, const EngineOptions& options) {
  silence();
  return std::make_unique<MujocoReplayEngine>(robot, options);
}

std::optional<std::string> mujoco_absence() { return std::nullopt; }

}  // namespace torquewright::hopper
