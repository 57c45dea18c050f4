// SPDX-License-Identifier: Apache-2.0
#include "simulation/run/run_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/run/drives.hpp"
#include "simulation/sign.hpp"
#include "simulation/stepper/sticking.hpp"

namespace torquewright::simulation {
namespace {

/// What a joint feels of the plant at position 0, the other joints at rest.
double felt_inertia_kg_m2(Plant& plant, Eigen::Index joint) {
  if (plant.is_imposed()) return 0.0;
  Eigen::MatrixXd mass(plant.joint_count(), plant.joint_count());
  plant.mass_matrix(Eigen::VectorXd::Zero(plant.joint_count()), mass);
  return mass(joint, joint);
}

std::vector<JointModel> make_models(Plant& plant,
                                    const std::vector<const actuator::Actuator*>& actuators,
                                    const SimulationOptions& options) {
  std::vector<JointModel> models;
  for (std::size_t j = 0; j < actuators.size(); ++j) {
    const double felt_kg_m2 = felt_inertia_kg_m2(plant, static_cast<Eigen::Index>(j));
    models.emplace_back(*actuators[j], felt_kg_m2, options);
  }
  return models;
}

}  // namespace

RunSimulation::RunSimulation(Plant& plant, const std::vector<const actuator::Actuator*>& actuators,
                             const Excitation& excitation, const std::vector<JointStart>& start,
                             std::size_t first, const SimulationOptions& options)
    : plant_(plant),
      excitation_(excitation),
      first_(first),
      traces_motion_only_(options.traces_motion_only && !plant.is_imposed()),
      models_(make_models(plant, actuators, options)),
      stepper_(plant, models_) {
  begin(start);
}

void RunSimulation::begin(const std::vector<JointStart>& start) {
  run_.joints.resize(models_.size());
  for (std::size_t j = 0; j < models_.size(); ++j) {
    state_.joints.push_back(models_[j].initial(start[j]));
  }
  if (plant_.is_imposed()) {
    imposed_.emplace(excitation_.time_s, excitation_.joints[0].speed_rad_s, start[0].position_rad);
    const ImposedMotion::Point point = imposed_->at(first_, excitation_.time_s[first_]);
    JointState& joint = state_.joints[0];
    joint.position_rad = joint.motor_position_rad = point.position_rad;
    joint.speed_rad_s = joint.motor_speed_rad_s = point.speed_rad_s;
  }
  const std::vector<DriveNow> drive = drives_at(excitation_, first_, 0.0);
  set_temperatures(first_, 0.0);
  for (std::size_t j = 0; j < models_.size(); ++j) {
    models_[j].settle_states(state_.joints[j], drive[j]);
  }
}

SimulatedRun RunSimulation::run(std::size_t last) {
  const double stored_J = energy_J();
  record(first_);
  for (std::size_t knot = first_; knot < last && run_.is_finite; ++knot) {
    interval(knot);
    record(knot + 1);
  }
  run_.work.stored_J = energy_J() - stored_J;
  return std::move(run_);
}

void RunSimulation::set_temperatures(std::size_t knot, double share) {
  for (std::size_t j = 0; j < models_.size(); ++j) {
    const std::vector<double>& measured = excitation_.joints[j].winding_K;
    if (!measured.empty()) {
      state_.joints[j].temperature.winding_K = between(measured, knot, share);
    }
  }
}

void RunSimulation::advance_states(std::size_t knot, double share, double step_s) {
  for (std::size_t j = 0; j < models_.size(); ++j) {
    const DriveNow drive = drive_at(excitation_.joints[j], knot, share);
    models_[j].advance_states(state_.joints[j], drive, step_s);
  }
}

void RunSimulation::heat(const std::vector<DriveNow>& drive, double step_s) {
  for (std::size_t j = 0; j < models_.size(); ++j) {
    if (!excitation_.joints[j].winding_K.empty()) continue;
    const double current_A = models_[j].circuit().current_A(state_.joints[j], drive[j]);
    models_[j].heat(state_.joints[j], current_A, step_s);
  }
}

double RunSimulation::longest_step_s() const {
  double longest_s = models_[0].longest_step_s();
  for (const JointModel& model : models_) longest_s = std::min(longest_s, model.longest_step_s());
  return longest_s;
}

/// From a knot to the next.
void RunSimulation::interval(std::size_t knot) {
  const double span_s = excitation_.time_s[knot + 1] - excitation_.time_s[knot];
  const int steps = std::max(1, static_cast<int>(std::ceil(span_s / longest_step_s() - 1e-9)));
  const double step_s = span_s / steps;
  run_.step_s = std::max(run_.step_s, step_s);
  for (int number = 0; number < steps; ++number) {
    step(knot, static_cast<double>(number) / steps, 1.0 / steps, step_s);
  }
  set_temperatures(knot, 1.0);
}

/// Half a step of what has a rate of its own, a step of motion, the other half (Strang's splitting,
/// second order). `from`, `width`: shares of the interval.
void RunSimulation::step(std::size_t knot, double from, double width, double step_s) {
  const std::vector<DriveNow> middle = drives_at(excitation_, knot, from + 0.5 * width);
  set_temperatures(knot, from + 0.5 * width);
  advance_states(knot, from + 0.25 * width, 0.5 * step_s);
  if (imposed_) {
    step_imposed(knot, from, width, step_s, middle);
  } else {
    stepper_.advance(state_, middle, step_s, run_.work);
  }
  advance_states(knot, from + 0.75 * width, 0.5 * step_s);
  heat(middle, step_s);
}

void RunSimulation::step_imposed(std::size_t knot, double from, double width, double step_s,
                                 const std::vector<DriveNow>& drive) {
  const double begin_s = excitation_.time_s[knot];
  const double span_s = excitation_.time_s[knot + 1] - begin_s;
  const auto half = imposed_->at(knot, begin_s + (from + 0.5 * width) * span_s);
  const auto full = imposed_->at(knot, begin_s + (from + width) * span_s);
  const ImposedStep imposed{half.position_rad, half.speed_rad_s, half.acceleration_rad_s2,
                            full.position_rad, full.speed_rad_s};
  stepper_.advance_imposed(state_, drive, step_s, imposed, run_.work);
}

/// At rest a drive on an imposed motion holds whatever lies between what it gives to either side.
double RunSimulation::held_Nm(const std::vector<DriveNow>& drive, const Eigen::VectorXd& imposed) {
  double least = 0.0;
  double most = 0.0;
  for (const double direction : {1.0, -1.0}) {
    const double torque =
        stepper_.equations().motion(state_, {direction}, drive, &imposed).torque_Nm[0];
    if (direction > 0.0) least = most = torque;
    least = std::min(least, torque);
    most = std::max(most, torque);
  }
  return std::clamp(state_.joints[0].held_Nm, least, most);
}

void RunSimulation::record(std::size_t knot) {
  if (traces_motion_only_) return record_motion();
  const std::vector<DriveNow> drive = drives_at(excitation_, knot, 0.0);
  Eigen::VectorXd imposed(1);
  if (imposed_) imposed[0] = imposed_->at(knot, excitation_.time_s[knot]).acceleration_rad_s2;
  const bool is_rigid_imposed = imposed_ && !models_[0].is_elastic();
  const std::vector<double> ways = is_rigid_imposed
                                       ? std::vector<double>{sign_of(state_.joints[0].speed_rad_s)}
                                       : directions_of(stepper_.equations(), state_, drive);
  PlantMotion motion =
      stepper_.equations().motion(state_, ways, drive, imposed_ ? &imposed : nullptr);
  if (is_rigid_imposed && ways[0] == 0.0) motion.torque_Nm[0] = held_Nm(drive, imposed);
  for (std::size_t j = 0; j < models_.size(); ++j) record_joint(j, motion, drive[j]);
}

void RunSimulation::record_motion() {
  for (std::size_t j = 0; j < models_.size(); ++j) {
    const JointState& state = state_.joints[j];
    run_.joints[j].position_rad.push_back(state.position_rad);
    run_.joints[j].speed_rad_s.push_back(state.speed_rad_s);
    if (!std::isfinite(state.position_rad) || !std::isfinite(state.speed_rad_s))
      run_.is_finite = false;
  }
}

void RunSimulation::record_joint(std::size_t joint, const PlantMotion& motion,
                                 const DriveNow& drive) {
  JointState& state = state_.joints[joint];
  JointTrace& trace = run_.joints[joint];
  const WindingCircuit& circuit = models_[joint].circuit();
  const double ratio = models_[joint].ratio();
  const auto row = static_cast<Eigen::Index>(joint);
  const double current_A = motion.forces[joint].current_A;
  state.held_Nm = motion.torque_Nm[row];
  trace.position_rad.push_back(state.position_rad);
  trace.speed_rad_s.push_back(state.speed_rad_s);
  trace.acceleration_rad_s2.push_back(motion.acceleration_rad_s2[row]);
  trace.motor_position_rad.push_back(ratio * state.motor_position_rad);
  trace.motor_speed_rad_s.push_back(ratio * state.motor_speed_rad_s);
  trace.current_A.push_back(current_A);
  trace.voltage_V.push_back(circuit.voltage_V(state, drive, current_A));
  trace.bus_V.push_back(circuit.bus_V(state, drive, current_A));
  trace.torque_Nm.push_back(motion.torque_Nm[row]);
  trace.winding_K.push_back(state.temperature.winding_K);
  trace.case_K.push_back(state.temperature.case_K);
  if (!std::isfinite(state.position_rad) || !std::isfinite(state.speed_rad_s) ||
      !std::isfinite(motion.torque_Nm[row])) {
    run_.is_finite = false;
  }
}

double RunSimulation::energy_J() {
  const auto joints = static_cast<Eigen::Index>(models_.size());
  Eigen::VectorXd position(joints), speed(joints);
  double sum = 0.0;
  for (std::size_t j = 0; j < models_.size(); ++j) {
    const JointState& state = state_.joints[j];
    position[static_cast<Eigen::Index>(j)] = state.position_rad;
    speed[static_cast<Eigen::Index>(j)] = state.speed_rad_s;
    sum += 0.5 * models_[j].inertia_kg_m2() * state.motor_speed_rad_s * state.motor_speed_rad_s;
    if (models_[j].is_elastic()) sum += models_[j].twist(state).stored_J;
  }
  return sum + plant_.energy_J(position, speed);
}

}  // namespace torquewright::simulation
