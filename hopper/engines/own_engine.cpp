// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/time_stepping.md.
#include "dynamics/passive_forces.hpp"
#include "dynamics/position_step.hpp"
#include "hopper/engines/every_engine.hpp"
#include "robot/model/whole_body.hpp"
#include "simulation/contact/time_stepping.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::VectorIn;
using Eigen::Index;
using Eigen::VectorXd;
using simulation::TimeStepping;

/// Of what a robot falls on; its document states none.
constexpr double kBodyFriction = 0.6;

/// A robot with its rotors as what a time stepping moves.
class TurningBodies final : public simulation::MovingBodies {
 public:
  explicit TurningBodies(const Robot& robot)
      : whole_(robot), rest_(VectorXd::Zero(robot.tree.velocity_size())) {}

  bool set(const VectorIn& position, const VectorIn& velocity) override {
    return whole_.set(position, velocity);
  }
  dynamics::TreeState& state() override { return whole_.state(); }
  void mass_matrix(dynamics::MatrixOut out) override { whole_.mass_matrix(out); }
  void bias(dynamics::VectorOut out) override { whole_.inverse_dynamics(rest_, out); }
  void joint_motion(Index row, dynamics::VectorOut out) override {
    if (row < rest_.size()) return MovingBodies::joint_motion(row, out);
    out = whole_.link_motion(static_cast<std::size_t>(row - rest_.size()));
  }

 private:
  WholeBody whole_;
  VectorXd rest_;
};

/// Of the tree's joints, and of links behind them.
std::vector<simulation::JointFriction> frictions_of(const Robot& robot) {
  std::vector<simulation::JointFriction> frictions = simulation::joint_frictions(robot.tree);
  const WholeBody whole(robot);
  Index row = robot.tree.velocity_size();
  for (const dynamics::Body& link : whole.links()) {
    const double resting = dynamics::friction_limit(link.joint.passive, 0.0);
    if (resting > 0.0) frictions.push_back({row, link.joint.passive.dry_friction, resting});
    ++row;
  }
  return frictions;
}

simulation::Obstacles obstacles_of(const Robot& robot, const EngineOptions& options) {
  simulation::Obstacles obstacles;
  for (const ContactPoint& contact : robot.contacts) {
    obstacles.points.push_back(
        {contact.point, contact.friction_coefficient, contact.restitution, contact.radius_m});
  }
  for (const CollisionSphere& sphere : robot.spheres) {
    obstacles.points.push_back({sphere.center, kBodyFriction, 0.0, sphere.radius_m});
  }
  obstacles.stops = simulation::joint_stops(robot.tree);
  obstacles.frictions = frictions_of(robot);
  obstacles.ground_height_m = options.ground_height_m;
  obstacles.profile = options.profile;
  obstacles.time_constant_s = options.contact_time_constant_s.value_or(0.0);
  return obstacles;
}

EngineOutcome outcome_of(TimeStepping::Outcome outcome) {
  switch (outcome) {
    case TimeStepping::Outcome::kStepped:
      return EngineOutcome::kStepped;
    case TimeStepping::Outcome::kUnreached:
      return EngineOutcome::kUnreached;
    case TimeStepping::Outcome::kUnsolved:
      return EngineOutcome::kUnsolved;
    case TimeStepping::Outcome::kBlownUp:
      break;
  }
  return EngineOutcome::kBlownUp;
}

class OwnEngine final : public Engine {
 public:
  OwnEngine(const Robot& robot, const EngineOptions& options)
      : bodies_(robot),
        stepping_(bodies_, obstacles_of(robot, options)),
        contacts_(robot.contacts.size()),
        impulses_N_s_(3 * static_cast<Index>(contacts_)),
        generalised_(robot.tree.velocity_size()) {
    start(dynamics::zero_position(robot.tree), VectorXd::Zero(robot.tree.velocity_size()));
  }

  std::string_view name() const override { return "own"; }

  void start(const VectorIn& position, const VectorIn& velocity) override {
    bodies_.state().set(position, velocity);  // throws where they are none
    position_.resize(position.size());
    dynamics::step_position(bodies_.state().tree(), position, velocity, 0.0, position_);
    velocity_ = velocity;
    stepping_.forget();
    impulses_N_s_.setZero();
    generalised_.setZero();
  }

  EngineOutcome step(const VectorIn& force, double step_s) override {
    const EngineOutcome outcome = outcome_of(stepping_.step(position_, velocity_, force, step_s));
    if (outcome == EngineOutcome::kStepped) {
      impulses_N_s_ = stepping_.impulses_N_s().head(impulses_N_s_.size());
      stepping_.generalised_impulse_of(contacts_, generalised_);
    }
    return outcome;
  }

  const VectorXd& position() const override { return position_; }
  const VectorXd& velocity() const override { return velocity_; }
  const VectorXd& impulses_N_s() const override { return impulses_N_s_; }
  const VectorXd& generalised_impulse() const override { return generalised_; }

 private:
  TurningBodies bodies_;
  TimeStepping stepping_;
  std::size_t contacts_;
  VectorXd position_, velocity_;
  VectorXd impulses_N_s_, generalised_;
};

}  // namespace

std::unique_ptr<Engine> own_engine(const Robot& robot, const EngineOptions& options) {
  return std::make_unique<OwnEngine>(robot, options);
}

namespace engines {

const EngineKind own = {
    .name = "own", .sentence = "rigid contact, step by step", .make = own_engine};

}  // namespace engines
}  // namespace torquewright::hopper
