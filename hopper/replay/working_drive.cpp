// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/working_drive.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/drive_check/demand.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/current_choice.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/motor_region.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;
using actuator::ClipTable;
using actuator::OperatingConditions;

constexpr double kRestWidth = 1e-3;  // of the no-load speed: how wide friction is smoothed,
constexpr double kRestWidthOfUnknown = 1e-2;  // where no rotor's inertia is stated
constexpr double kFastest_rad_s = 1e6;        // where the back-EMF sets no speed
constexpr double kAnySpeed_rad_s = 1.0;       // in the place of a no-load speed of zero
constexpr double kEdge = 1e-9;                // of the no-load speed: of the box
constexpr double kNoRoom = 1e-9;              // of the voltage: the field is weakened to within it

actuator::NodeTemperatures starting_temperatures(const Actuator& actuator,
                                                 const OperatingConditions& conditions) {
  const double own_K = actuator.motor.winding_temperature_K;
  const double ambient_K = actuator.thermal ? actuator.thermal->ambient_K : own_K;
  return {conditions.winding_temperature_K.value_or(ambient_K), ambient_K};
}

double no_load_speed_at_joint_rad_s(const Actuator& actuator, const actuator::PhaseModel& model) {
  const double motor_rad_s = actuator::no_load_speed_rad_s(model);
  return std::min(motor_rad_s / std::abs(actuator.transmission.ratio), kFastest_rad_s);
}

/// |torque| <= peak, and beyond the no-load speed none that drives.
ClipTable box_of(double peak_Nm, double no_load_rad_s) {
  if (!(no_load_rad_s > 0.0)) return ClipTable({{-1.0, 1.0}, {0.0, 0.0}, {0.0, 0.0}});
  const double in = no_load_rad_s;
  const double out = in * (1.0 + kEdge);
  return ClipTable({{-out, -in, in, out},
                    {0.0, -peak_Nm, -peak_Nm, -peak_Nm},
                    {peak_Nm, peak_Nm, peak_Nm, 0.0}});
}

/// Whether the drive evens an effect out by the current that it chooses: friction that it knows at
/// its speed, and what makes the motor weaker. Waves, springs, stops and what has a state are felt.
/// An inertia is the engine's.
bool is_evened_out(const actuator::Effect& effect) {
  switch (effect.kind->acts) {
    case actuator::Acts::kMotorSideTorque:
    case actuator::Acts::kOutputTorque:
    case actuator::Acts::kDynamics:
      return false;
    case actuator::Acts::kDrag:
      return !effect.kind->has_harmonics;
    default:
      return true;
  }
}

bool has_felt_effects(const Actuator& actuator) {
  return !std::all_of(actuator.effects.begin(), actuator.effects.end(), is_evened_out);
}

simulation::SimulationOptions joint_options(const FixedDrive& fixed) {
  simulation::SimulationOptions options;
  // Without an inertia of its own no rotor leaves its output.
  options.motor_inertia_kg_m2 = fixed.turns_with_output ? 0.0 : fixed.turned_kg_m2;
  return options;
}

}  // namespace

WorkingDrive::WorkingDrive(const FixedDrive& fixed, const PoweredDriveOptions& options,
                           const UnknownOfDrive& unknown)
    : fixed_(&fixed),
      start_(starting_temperatures(fixed.actuator, options.conditions)),
      nodes_(start_),
      unknown_(unknown) {
  if (fixed.actuator.thermal) heat_.emplace(fixed.actuator);
  const double open_V = open_circuit_voltage_V(fixed.actuator, options.conditions);
  const actuator::PhaseModel model = fixed.region->model(open_V, start_.winding_K);
  const double no_load_rad_s = no_load_speed_at_joint_rad_s(fixed.actuator, model);
  if (options.limits == DriveLimits::kBox) {
    const actuator::Interval rest = fixed.region->limits(open_V, start_.winding_K, 0.0);
    box_ = box_of(std::max(-rest.least_Nm, rest.greatest_Nm), no_load_rad_s);
  }
  if (has_felt_effects(fixed.actuator)) joint_.emplace(fixed.actuator, joint_options(fixed));
  const bool turns_rotor = fixed.turns_with_output && fixed.turned_kg_m2 > 0.0;
  const double slow = turns_rotor ? kRestWidth : kRestWidthOfUnknown;
  rest_width_rad_s_ = slow * (no_load_rad_s > 0.0 ? no_load_rad_s : kAnySpeed_rad_s);
}

void WorkingDrive::start() {
  nodes_ = start_;
  if (joint_) joint_->start();
}

void WorkingDrive::want(double wanted_Nm, double output_speed_rad_s) {
  wanted_Nm_ = wanted_Nm;
  output_speed_rad_s_ = output_speed_rad_s;
  speed_rad_s_ = joint_ ? joint_->motor_speed_rad_s(output_speed_rad_s) : output_speed_rad_s;
  model_ = fixed_->region->model(0.0, nodes_.winding_K);
  is_loaded_ = false;
}

actuator::Interval WorkingDrive::range(double bus_V, double winding_K, double speed_rad_s) const {
  return box_ ? actuator::limits(box_->view(), speed_rad_s)
              : fixed_->region->limits(bus_V, winding_K, speed_rad_s);
}

void WorkingDrive::hold(double bus_V) {
  if (!(bus_V > 0.0)) {
    switch_off();
    return;
  }
  held_Nm_ = torquewright_clamp(wanted_Nm_, range(bus_V, nodes_.winding_K, speed_rad_s_));
  if (is_loaded_ && held_Nm_ == made_Nm_ && is_same_current(bus_V)) return;
  load(held_Nm_, bus_V);
}

/// The voltage changes the current of a torque only where the drive weakens the field for it.
bool WorkingDrive::is_same_current(double bus_V) const {
  if (!model_.field_weakening) return true;
  const auto phase_V = [&](double bus) { return model_.phase_volts_per_bus_volt * bus; };
  const bool had_room =
      needed_phase_V_ < (1.0 - kNoRoom) * phase_V(behind_line_V(model_.supply.open_circuit_V));
  return had_room && needed_phase_V_ <= phase_V(behind_line_V(bus_V));
}

/// Behind the cables of its own, under its power.
double WorkingDrive::behind_line_V(double bus_V) const {
  actuator::Supply line = model_.supply;
  line.open_circuit_V = bus_V;
  return actuator::bus_voltage_V(line, power_W_).value_or(0.5 * bus_V);
}

void WorkingDrive::load(double torque_Nm, double bus_V) {
  made_Nm_ = torque_Nm;
  is_loaded_ = true;
  power_W_ = current_A_ = phase_current_A_ = needed_phase_V_ = 0.0;
  // Nobody asks for anything: whatever friction there is holds.
  if (torque_Nm == 0.0 && speed_rad_s_ == 0.0) return;
  const Actuator& actuator = fixed_->actuator;
  model_.supply.open_circuit_V = bus_V;
  const double rotor_rad_s = actuator.transmission.ratio * speed_rad_s_;
  const double rotor_Nm =
      actuator::rotor_torque_Nm(actuator, nodes_.winding_K, speed_rad_s_, torque_Nm);
  actuator::Current current = actuator::chosen_current(model_, rotor_Nm, rotor_rad_s);
  if (!std::isfinite(current.amplitude_A())) {
    // No current saturates so far (in a box alone): the greatest there is.
    current = {0.0, std::copysign(model_.current_limit_A, rotor_Nm)};
  }
  phase_current_A_ = current.amplitude_A();
  current_A_ = phase_current_A_ /
               actuator::phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
  power_W_ = actuator::bus_power_W(model_, current, rotor_rad_s);
  if (model_.field_weakening) {
    needed_phase_V_ = actuator::phase_voltage_V(model_, current, rotor_rad_s);
  }
}

double WorkingDrive::coasting_Nm() const {
  if (speed_rad_s_ == 0.0) return 0.0;
  const double direction = std::copysign(1.0, speed_rad_s_);
  const actuator::Span side =
      actuator::motor_side_torque_Nm(fixed_->actuator, speed_rad_s_, direction, nodes_.winding_K);
  const double torque_Nm =
      actuator::after_mesh_Nm(fixed_->actuator, 0.5 * (side.least + side.greatest), direction);
  return std::isfinite(torque_Nm) ? torque_Nm : 0.0;  // a gear that locks itself holds its own
}

void WorkingDrive::make_only(double share, double bus_V) {
  const double coasting_Nm = this->coasting_Nm();
  load(coasting_Nm + share * (held_Nm_ - coasting_Nm), bus_V);
}

void WorkingDrive::switch_off() {
  held_Nm_ = made_Nm_ = coasting_Nm();
  power_W_ = current_A_ = phase_current_A_ = 0.0;
  is_loaded_ = true;
}

/// What a motor of another strength makes of the same current: its share changes, drag stays.
double WorkingDrive::given_Nm() const {
  if (unknown_.strength == 1.0) return made_Nm_;
  const double coasting_Nm = this->coasting_Nm();
  return coasting_Nm + unknown_.strength * (made_Nm_ - coasting_Nm);
}

/// Of the motion, also at rest, as rotor_torque_Nm() has it.
double WorkingDrive::direction(double torque_Nm) const {
  return speed_rad_s_ == 0.0 ? -std::copysign(1.0, torque_Nm) : std::copysign(1.0, speed_rad_s_);
}

/// What the motor makes, at the output, so that the torque is there once mesh and known friction
/// have taken theirs.
double WorkingDrive::motor_Nm(double torque_Nm) const {
  const Actuator& actuator = fixed_->actuator;
  const double along = direction(torque_Nm);
  const actuator::Span side =
      actuator::motor_side_torque_Nm(actuator, speed_rad_s_, along, nodes_.winding_K);
  return actuator::before_mesh_Nm(actuator, torque_Nm, along) - 0.5 * (side.least + side.greatest);
}

double WorkingDrive::acting_Nm(double output_position_rad, double step_s) {
  const double given_Nm = this->given_Nm();
  double torque_Nm = given_Nm;
  if (joint_) {
    simulation::DriveNow now;
    now.value = current_A_;
    now.motor_Nm = motor_Nm(given_Nm);
    torque_Nm = joint_->advance({output_position_rad, output_speed_rad_s_, step_s}, now,
                                direction(given_Nm), nodes_.winding_K);
    // What would turn a gear that locks holds itself.
    if (!std::isfinite(torque_Nm)) torque_Nm = given_Nm;
  }
  if (unknown_.friction_Nm == 0.0) return torque_Nm;
  // Eq. (5): whatever else moves with it, the rotor does.
  const double turning_rad_s = fixed_->turns_with_output && fixed_->turned_kg_m2 > 0.0
                                   ? unknown_.friction_Nm * step_s / fixed_->turned_kg_m2
                                   : 0.0;
  const double width_rad_s = std::max(rest_width_rad_s_, turning_rad_s);
  return torque_Nm -
         unknown_.friction_Nm * std::clamp(output_speed_rad_s_ / width_rad_s, -1.0, 1.0);
}

void WorkingDrive::end(double step_s) {
  if (!heat_) return;
  const Actuator& actuator = fixed_->actuator;
  const actuator::Instant at = actuator::at_winding_temperature(actuator, nodes_.winding_K);
  heat_->advance(nodes_, actuator::winding_loss_W(actuator, phase_current_A_, at), step_s);
}

}  // namespace torquewright::hopper
