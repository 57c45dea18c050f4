// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/plant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace torquewright::oracles::robot_bench {
namespace {

/// Dry friction as a constraint that is as stiff as MuJoCo allows: what creeps at rest is below
/// 1e-5 rad/s.
constexpr double kFirm = 0.9999;
/// So that MuJoCo keeps a row for friction; each step sets the level anew.
constexpr double kPlaceholder_Nm = 1e-9;
/// The robot settles under its first command before the log begins.
constexpr double kSettling_s = 1.0;
/// Below this speed a joint counts as resting: friction's direction is that of what pushes.
constexpr double kRest_rad_s = 1e-4;

std::string text(const Eigen::Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}
std::string text(const Eigen::Quaterniond& q) {
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(), q.z());
}

std::string inertial(const Body& body) {
  if (body.mass_kg <= 0) return "";
  const Eigen::Matrix3d& i = body.inertia_kg_m2;
  return fmt::format(
      R"(<inertial pos="{}" mass="{:.17g}" fullinertia="{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}"/>)",
      text(body.center_m), body.mass_kg, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
}

std::string hinge(const std::string& name, const Joint& joint, double armature_kg_m2) {
  return fmt::format(
      R"(<joint name="{}" type="hinge" axis="{}" armature="{:.17g}" frictionloss="{}"/>)", name,
      text(joint.axis), armature_kg_m2, kPlaceholder_Nm);
}

/// Nearly without inertia of its own: the armature is the rotor's.
std::string rotor(const Joint& joint, double armature_kg_m2) {
  return fmt::format(
      R"(<body pos="{}" quat="{}">{}<inertial pos="0 0 0" mass="1e-7" diaginertia="1e-9 1e-9 1e-9"/></body>)",
      text(joint.position_m), text(joint.rotation),
      hinge(joint.name + "_rotor", joint, armature_kg_m2));
}

std::string subtree(const Scene& scene, const std::string& body);

std::string limb(const Scene& scene, const Joint& joint) {
  const bool moves = !scene.robot.is_held(joint.name);
  const Laws laws = moves ? scene.laws.at(joint.name) : Laws{};
  return fmt::format(
      R"({}<body name="{}" pos="{}" quat="{}">{}{}</body>)",
      laws.is_elastic() ? rotor(joint, laws.armature_kg_m2) : "", joint.child,
      text(joint.position_m), text(joint.rotation),
      moves ? hinge(joint.name, joint, laws.is_elastic() ? 0 : laws.armature_kg_m2) : "",
      subtree(scene, joint.child));
}

std::string subtree(const Scene& scene, const std::string& body) {
  std::string all = inertial(scene.robot.body(body));
  for (const Joint& joint : scene.robot.joints)
    if (joint.parent == body) all += limb(scene, joint);
  return all;
}

/// Of the whole robot about the gantry's hinges, roughly: what makes its frequency.
double hanging_inertia(const Scene& scene) {
  double inertia = 0;
  for (const Body& body : scene.robot.bodies)
    inertia += body.mass_kg * (scene.gantry.above_m * scene.gantry.above_m + 0.04);
  return inertia;
}

std::string gantry(const Scene& scene) {
  if (!scene.gantry.gives_way()) return "";
  const double rate = 2 * std::numbers::pi * scene.gantry.frequency_hz,
               inertia = hanging_inertia(scene);
  std::string all;
  for (const char* axis : {"1 0 0", "0 1 0"})
    all += fmt::format(
        R"(<joint type="hinge" axis="{}" pos="0 0 {}" stiffness="{:.17g}" damping="{:.17g}"/>)",
        axis, scene.gantry.above_m, inertia * rate * rate,
        2 * scene.gantry.damping_ratio * inertia * rate);
  return all;
}

}  // namespace

double Commands::at(std::size_t joint, double time_s) const {
  const auto& targets = targets_rad[joint];
  // A packet that arrives at this very instant counts.
  const double packet = std::floor(time_s / packet_s + 1e-6);
  const double last = static_cast<double>(targets.size() - 1);
  return targets[static_cast<std::size_t>(std::clamp(packet, 0.0, last))];
}

double Commands::mean(std::size_t joint, double from_s, double to_s) const {
  const double before = at(joint, from_s), after = at(joint, to_s);
  if (before == after) return before;
  const double change_s = packet_s * std::floor(to_s / packet_s + 1e-6);
  const double share = std::clamp((to_s - change_s) / (to_s - from_s), 0.0, 1.0);
  return before + share * (after - before);
}

double Commands::duration_s() const {
  return packet_s * static_cast<double>(targets_rad.front().size());
}

std::string mjcf(const Scene& scene, double step_s) {
  const Eigen::Quaterniond attitude(Eigen::AngleAxisd(scene.roll_rad, Eigen::Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(scene.pitch_rad, Eigen::Vector3d::UnitY()));
  const std::string inside = gantry(scene) + subtree(scene, scene.robot.base);
  return fmt::format(
      R"(<mujoco><compiler angle="radian" boundmass="0" boundinertia="0"/>)"
      R"(<option timestep="{0}" gravity="0 0 -9.81" tolerance="1e-10" solver="Newton"/>)"
      R"(<default><joint solreffriction="{1} 1" solimpfriction="{2} {2} 1"/></default>)"
      R"(<worldbody><body name="{3}" quat="{4}">{5}</body></worldbody></mujoco>)",
      step_s, 2 * step_s, kFirm, scene.robot.base == "world" ? "base" : scene.robot.base,
      text(attitude), inside);
}

Plant::Plant(const Scene& scene, double step_s)
    : scene_(scene), model_(compile(mjcf(scene, step_s))), data_(mj_makeData(model_.get())) {
  for (const std::string& name : scene.robot.moved()) {
    Axis axis;
    axis.name = name;
    axis.laws = scene.laws.at(name);
    axis.controller = scene.controllers.at(name);
    const auto dof = [&](const std::string& joint) {
      const int index = mj_name2id(model_.get(), mjOBJ_JOINT, joint.c_str());
      return index < 0 ? -1 : model_->jnt_dofadr[index];
    };
    axis.dof = dof(name);
    axis.rotor = dof(name + "_rotor");
    axes_.push_back(axis);
  }
  inertial_.resize(static_cast<std::size_t>(model_->nv));
  mj_forward(model_.get(), data_.get());
}

void Plant::start_at(const std::vector<double>& position_rad) {
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    data_->qpos[axes_[k].dof] = position_rad[k];
    if (axes_[k].rotor >= 0) data_->qpos[axes_[k].rotor] = position_rad[k];
  }
  mj_forward(model_.get(), data_.get());
}

double Plant::measured_rad(std::size_t joint) const {
  return data_->qpos[measured_dof(axes_[joint])];
}

// MuJoCo's speeds belong to the middle of the last step: its positions leap over them.
double Plant::speed_rad_s(const Axis& axis) const {
  const int dof = measured_dof(axis);
  return data_->qvel[dof] + 0.5 * model_->opt.timestep * data_->qacc[dof];
}

// Spring and damper between rotor and output, beyond half the gap; a belt passes no more than its
// slip torque, and creeps so that it carries just that.
void Plant::twist(Axis& axis) {
  const Laws& laws = axis.laws;
  const double turn = data_->qpos[axis.rotor] - data_->qpos[axis.dof] - axis.slipped_rad;
  const double half = laws.gap_rad / 2;
  const double beyond = turn - std::clamp(turn, -half, half);
  const double rate = data_->qvel[axis.rotor] - data_->qvel[axis.dof];
  double torque = 0;
  if (beyond != 0 || half == 0)
    torque = laws.stiffness_Nm_rad * beyond + laws.twist_damping_Nm_s_rad * rate;
  const double passed = std::clamp(torque, -laws.slip_torque_Nm, laws.slip_torque_Nm);
  axis.slipped_rad += (torque - passed) / laws.stiffness_Nm_rad;
  data_->qfrc_applied[axis.rotor] -= passed;
  data_->qfrc_applied[axis.dof] += passed;
}

// Direction: of the motion, or at rest of what pushes, which the constraint opposes.
void Plant::set_friction(const Axis& axis) {
  const double speed = data_->qvel[axis.dof];
  const bool forwards =
      std::abs(speed) > kRest_rad_s ? speed > 0 : data_->qfrc_constraint[axis.dof] < 0;
  model_->dof_frictionloss[axis.dof] =
      std::max(kPlaceholder_Nm, axis.laws.dry_Nm(speed, forwards, axis.gear_Nm));
  model_->dof_damping[axis.dof] = axis.laws.viscous_Nm_s_rad[forwards ? 0 : 1];
}

void Plant::drive(Axis& axis, double command_rad) {
  const Laws& laws = axis.laws;
  const double asked =
      laws.torque_factor *
      axis.controller.torque_Nm(command_rad, data_->qpos[measured_dof(axis)], speed_rad_s(axis));
  const double share = laws.lag_s > 0 ? 1 - std::exp(-model_->opt.timestep / laws.lag_s) : 1;
  axis.motor_Nm += share * (asked - axis.motor_Nm);
  data_->qfrc_applied[axis.rotor >= 0 ? axis.rotor : axis.dof] += axis.motor_Nm;
  const double angle = data_->qpos[axis.dof];
  data_->qfrc_applied[axis.dof] += laws.spring_and_ripple_Nm(angle) + laws.stops_Nm(angle);
  if (axis.rotor >= 0) twist(axis);
  set_friction(axis);
}

void Plant::pull_cable() {
  const Cable& cable = scene_.cable;
  mju_zero(data_->xfrc_applied, 6 * model_->nbody);
  if (!cable.pulls()) return;
  std::array<mjtNum, 3> from{}, to{};
  std::array<int, 2> bodies{};
  const auto place = [&](const std::string& name, const double* at, mjtNum* world) {
    const int body = mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
    mju_rotVecMat(world, at, data_->xmat + 9 * body);
    for (int k = 0; k < 3; ++k) world[k] += data_->xpos[3 * body + k];
    return body;
  };
  bodies[0] = place(cable.from, cable.from_m, from.data());
  bodies[1] = place(cable.to, cable.to_m, to.data());
  std::array<mjtNum, 3> pull{};
  mju_sub3(pull.data(), from.data(), to.data());
  const double length = mju_normalize3(pull.data());
  const double stretch = length - cable.free_m;
  if (stretch <= 0) return;
  const double tension = cable.tension_N + cable.stiffness_N_m * stretch;
  const std::array<mjtNum, 3> none{};
  mju_scl3(pull.data(), pull.data(), tension);
  mj_applyFT(model_.get(), data_.get(), pull.data(), none.data(), to.data(), bodies[1],
             data_->qfrc_applied);
  mju_scl3(pull.data(), pull.data(), -1);
  mj_applyFT(model_.get(), data_.get(), pull.data(), none.data(), from.data(), bodies[0],
             data_->qfrc_applied);
}

// What passes the gears to the link: its inertia and weight, less what acts on the link itself.
void Plant::note_gear_torques() {
  mj_mulM(model_.get(), data_.get(), inertial_.data(), data_->qacc);
  for (Axis& axis : axes_) {
    const double rotor = axis.rotor >= 0 ? 0 : axis.laws.armature_kg_m2 * data_->qacc[axis.dof];
    const double angle = data_->qpos[axis.dof];
    axis.gear_Nm = inertial_[static_cast<std::size_t>(axis.dof)] - rotor +
                   data_->qfrc_bias[axis.dof] - axis.laws.spring_and_ripple_Nm(angle) -
                   axis.laws.stops_Nm(angle);
  }
}

void Plant::step(const std::vector<double>& command_rad) {
  mju_zero(data_->qfrc_applied, model_->nv);
  pull_cable();
  for (std::size_t k = 0; k < axes_.size(); ++k) drive(axes_[k], command_rad[k]);
  mj_step(model_.get(), data_.get());
  note_gear_torques();
}

Energy Plant::energy() {
  mj_forward(model_.get(), data_.get());
  model_->opt.enableflags |= mjENBL_ENERGY;
  mj_energyPos(model_.get(), data_.get());
  mj_energyVel(model_.get(), data_.get());
  return {data_->energy[1], data_->energy[0]};
}

Record play(const Scene& scene, const Commands& commands, double row_s, int finer) {
  bool elastic = false;
  for (const auto& [name, laws] : scene.laws) elastic = elastic || laws.is_elastic();
  const int steps_per_row =
      static_cast<int>(std::lround(row_s / (elastic ? 1e-4 : 2.5e-4))) * finer;
  const double step_s = row_s / steps_per_row;
  Plant plant(scene, step_s);
  const std::size_t joints = plant.joints();
  std::vector<double> late(joints), command(joints);
  for (std::size_t k = 0; k < joints; ++k) {
    command[k] = commands.targets_rad[k].front();
    late[k] = commands.delay_s + scene.laws.at(scene.robot.moved()[k]).command_delay_s;
  }
  plant.start_at(command);
  for (double time_s = 0; time_s < kSettling_s; time_s += step_s) plant.step(command);
  Record record;
  record.position_rad.resize(joints);
  record.speed_rad_s = record.command_rad = record.torque_Nm = record.position_rad;
  const long steps = std::lround(commands.duration_s() / row_s) * steps_per_row;
  for (long s = 0; s < steps; ++s) {
    const double time_s = static_cast<double>(s) * step_s;
    if (s % steps_per_row == 0) record.time_s.push_back(time_s);
    for (std::size_t k = 0; k < joints; ++k) {
      // A step's torque acts from half a step before to half a step after its instant.
      const double sent_s = time_s - late[k];
      command[k] = commands.mean(k, sent_s - step_s / 2, sent_s + step_s / 2);
      if (s % steps_per_row != 0) continue;
      record.position_rad[k].push_back(plant.measured_rad(k));
      record.speed_rad_s[k].push_back(plant.measured_rad_s(k));
      record.command_rad[k].push_back(commands.at(k, time_s));
      record.torque_Nm[k].push_back(plant.motor_torque_Nm(k));
    }
    plant.step(command);
  }
  return record;
}

}  // namespace torquewright::oracles::robot_bench
