// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/plant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/oracles/mujoco_bench/laws.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

/// Flanks of a gear with play: a spring against the rotor of this natural frequency.
constexpr double kFlank_rad_s = 2 * std::numbers::pi * 500;

double armature(const World& world) {
  return world.motor.armature_kg_m2() + world.laws.extra_inertia_kg_m2;
}

/// About the joint.
double load_inertia(const World& world, double bench_inertia_kg_m2, double payload_share) {
  const Load& load = world.load;
  const double grown = 1 + payload_share;
  if (load.type == "pendulum")
    return load.inertia_kg_m2 + load.mass_kg * grown * load.length_m * load.length_m;
  if (load.type == "linear_axis") return load.mass_kg * grown;
  if (load.type == "free") return load.inertia_kg_m2 * grown;
  return bench_inertia_kg_m2;
}

std::string inertial(const World& world, double about_joint, double payload_share) {
  const Load& load = world.load;
  if (load.type == "linear_axis")
    return fmt::format(R"(<inertial pos="0 0 0" mass="{}" diaginertia="1 1 1"/>)", about_joint);
  const bool hangs = load.type == "pendulum";
  const double mass = hangs ? load.mass_kg * (1 + payload_share) : 1;
  const double about_center = hangs ? load.inertia_kg_m2 : about_joint;
  return fmt::format(R"(<inertial pos="0 0 {}" mass="{}" diaginertia="{} {} {}"/>)",
                     hangs ? -load.length_m : 0.0, mass, about_center, about_center, about_center);
}

/// Spring and stops are those of MuJoCo's joint; a stop's stiffness there is per unit of inertia.
std::string output_joint(const World& world, double own_armature, double inertia) {
  const Load& load = world.load;
  const bool slides = load.type == "linear_axis";
  std::string text =
      fmt::format(R"(<joint name="output" type="{}" axis="{}" armature="{}")",
                  slides ? "slide" : "hinge", slides ? "1 0 0" : "0 1 0", own_armature);
  if (load.spring_Nm_rad > 0)
    text +=
        fmt::format(R"( stiffness="{}" springref="{}")", load.spring_Nm_rad, load.spring_rest_rad);
  if (load.stop_rad < kNever) {
    const double per_inertia = load.stop_stiffness_Nm_rad / inertia;
    text += fmt::format(
        R"( limited="true" range="{} {}" solreflimit="{} {}" solimplimit="0.99 0.99 0.001")",
        -load.stop_rad, load.stop_rad, -per_inertia, -0.6 * std::sqrt(per_inertia));
  }
  return text + "/>";
}

std::string rotor_and_shaft(const World& world, double armature_kg_m2, std::string& tendon) {
  const Laws& laws = world.laws;
  const bool plays = laws.gap_rad > 0;
  const double stiffness = plays ? flank_stiffness_Nm_rad(world) : laws.stiffness_Nm_rad;
  tendon = fmt::format(
      R"(<tendon><fixed stiffness="{}" springlength="0" damping="{}">)"
      R"(<joint joint="rotor" coef="1"/><joint joint="output" coef="-1"/></fixed></tendon>)",
      stiffness, plays ? 0 : laws.damping_Nm_s_rad);
  return fmt::format(R"(<body><joint name="rotor" type="hinge" axis="0 1 0"/>)"
                     R"(<inertial pos="0 0 0" mass="1" diaginertia="{0} {0} {0}"/></body>)",
                     armature_kg_m2);
}

std::string mjcf(const World& world, double armature_kg_m2, double inertia, double payload_share,
                 double step_s) {
  const bool elastic = world.laws.is_elastic();
  std::string tendon;
  const std::string rotor = elastic ? rotor_and_shaft(world, armature_kg_m2, tendon) : "";
  const double whole = elastic ? inertia : inertia + armature_kg_m2;
  return fmt::format(
      R"(<mujoco><compiler angle="radian" boundinertia="0"/>)"
      R"(<option timestep="{}" gravity="0 0 {}"><flag contact="disable"/></option>)"
      R"(<worldbody>{}<body>{}{}</body></worldbody>{})"
      R"(<actuator><motor joint="{}" gear="{}"/><motor joint="output"/></actuator></mujoco>)",
      step_s, -kGravity_m_s2, rotor, output_joint(world, elastic ? 0 : armature_kg_m2, whole),
      inertial(world, inertia, payload_share), tendon, elastic ? "rotor" : "output",
      world.motor.ratio);
}

mjModel* read(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "bench.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML("bench.xml", files.get(), error.data(), error.size());
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(error.data());
  return model;
}

}  // namespace

double flank_stiffness_Nm_rad(const World& world) {
  return armature(world) * kFlank_rad_s * kFlank_rad_s;
}

Plant::Plant(const World& world, double bench_inertia_kg_m2, double payload_share, double step_s)
    : world_(world),
      armature_kg_m2_(armature(world)),
      load_inertia_kg_m2_(load_inertia(world, bench_inertia_kg_m2, payload_share)) {
  model_.reset(read(mjcf(world, armature_kg_m2_, load_inertia_kg_m2_, payload_share, step_s)));
  data_.reset(mj_makeData(model_.get()));
  output_ = model_->nv - 1;
  mj_forward(model_.get(), data_.get());
}

Motion Plant::motion() const {
  return {.position_rad = data_->qpos[output_],
          .speed_rad_s = data_->qvel[output_],
          .rotor_position_rad = data_->qpos[0],
          .rotor_speed_rad_s = data_->qvel[0]};
}

void Plant::set_speed(double speed_rad_s) {
  for (int k = 0; k <= output_; ++k) data_->qvel[k] = speed_rad_s;
}

// Sliding with m = slope a + level behind the mesh: armature a = motor - direction drag - gain m.
// The gain depends on the sign of m; as both gains are positive one sign agrees with itself.
double Plant::slide(const Drive& drive, double slope, double level, double direction) const {
  const Motion now = motion();
  const Sliding state{now.rotor_speed_rad_s, now.position_rad, drive.current_A,
                      drive.temperature_K,   mesh_torque_Nm_,  drive.time_s};
  const double push = drive.motor_torque_Nm - direction * drag_Nm(world_, state, direction);
  for (const double side : {1.0, -1.0}) {
    const double gain = mesh_gain(world_, side, direction);
    const double acceleration = (push - gain * level) / (armature_kg_m2_ + gain * slope);
    if ((slope * acceleration + level) * side >= 0) return acceleration;
  }
  return (push - level) / (armature_kg_m2_ + slope);
}

double Plant::slip_acceleration(const Drive& drive, double slope, double level) const {
  const double speed = data_->qvel[0], step = model_->opt.timestep;
  const double first = speed < 0 ? -1 : 1;
  for (const double direction : {first, -first}) {
    const double acceleration = slide(drive, slope, level, direction);
    if ((speed + step * acceleration) * direction > 0) return acceleration;
  }
  return -speed / step;
}

void Plant::apply_rigid(const Drive& drive) {
  const mjData& d = *data_;
  // A stop's force is that of the step before: it is soft against the step.
  const double flange =
      flange_torque_Nm(world_, d.qpos[0]) + d.qfrc_passive[0] + d.qfrc_constraint[0];
  const double needed = d.qfrc_bias[0] - drive.bench_torque_Nm;
  const double factor = load_ripple_factor(world_, d.qpos[0]);
  const double slope = load_inertia_kg_m2_ / factor, level = (needed - flange) / factor;
  const double acceleration = slip_acceleration(drive, slope, level);
  mesh_torque_Nm_ = slope * acceleration + level;
  data_->qfrc_applied[0] = total_inertia_kg_m2() * acceleration - drive.motor_torque_Nm + needed -
                           d.qfrc_passive[0] - d.qfrc_constraint[0];
}

void Plant::apply_elastic(const Drive& drive) {
  const double shaft = -data_->qfrc_passive[0];
  const double acceleration = slip_acceleration(drive, 0, shaft);
  mesh_torque_Nm_ = shaft;
  data_->qfrc_applied[0] = armature_kg_m2_ * acceleration - drive.motor_torque_Nm + shaft;
  data_->qfrc_applied[1] = flange_torque_Nm(world_, data_->qpos[1]);
}

// The tendon's spring rests wherever the twist is, within the gap; flanks lose energy where they
// touch.
void Plant::follow_gap() {
  const double half_gap = world_.laws.gap_rad / 2, twist = data_->qpos[0] - data_->qpos[1];
  model_->tendon_lengthspring[0] = std::clamp(twist, -half_gap, half_gap);
  const bool touches = std::abs(twist) > half_gap;
  model_->tendon_damping[0] = touches ? 0.3 * armature_kg_m2_ * kFlank_rad_s : 0;
}

Motion Plant::step(const Drive& drive) {
  if (world_.laws.gap_rad > 0) follow_gap();
  mj_step1(model_.get(), data_.get());
  Motion now = motion();
  if (output_ == 0)
    apply_rigid(drive);
  else
    apply_elastic(drive);
  data_->ctrl[0] = drive.motor_torque_Nm / world_.motor.ratio;
  data_->ctrl[1] = drive.bench_torque_Nm;
  const double bias = data_->qfrc_bias[output_];
  mj_step2(model_.get(), data_.get());
  now.acceleration_rad_s2 = data_->qacc[output_];
  now.load_torque_Nm = load_inertia_kg_m2_ * now.acceleration_rad_s2 + bias - drive.bench_torque_Nm;
  return now;
}

}  // namespace torquewright::oracles::mujoco_bench
