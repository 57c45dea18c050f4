// SPDX-License-Identifier: Apache-2.0
#include "identification/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "identification/imposed_motion.hpp"
#include "identification/stepper.hpp"

namespace torquewright::identification {
namespace {

void require_sizes(const Rig& rig, std::size_t actuators, const Excitation& excitation,
                   std::size_t starts) {
  const std::size_t joints = rig.joints.size();
  const std::size_t count = excitation.time_s.size();
  bool fits = joints > 0 && actuators == joints && excitation.joints.size() == joints &&
              starts == joints && count > 0;
  for (const JointDrive& drive : excitation.joints) {
    fits = fits && drive.value.size() == count &&
           (drive.bus_V.empty() || drive.bus_V.size() == count) &&
           (drive.enabled.empty() || drive.enabled.size() == count) &&
           (drive.winding_K.empty() || drive.winding_K.size() == count) &&
           (rig.load.type != LoadType::kDynamometer || drive.speed_rad_s.size() == count);
  }
  if (!fits) throw std::invalid_argument("simulate: sizes do not agree");
}

double load_inertia(const LoadDynamics& load, Eigen::Index joint) {
  if (load.is_imposed()) return 0.0;
  Eigen::MatrixXd mass(load.joint_count(), load.joint_count());
  load.mass_matrix(Eigen::VectorXd::Zero(load.joint_count()), mass);
  return mass(joint, joint);
}

std::vector<JointModel> make_models(const LoadDynamics& load,
                                    const std::vector<const actuator::Actuator*>& actuators,
                                    const SimulationOptions& options) {
  std::vector<JointModel> models;
  for (std::size_t j = 0; j < actuators.size(); ++j) {
    models.emplace_back(*actuators[j], load_inertia(load, static_cast<Eigen::Index>(j)), options);
  }
  return models;
}

/// One run, from its first sample to its last.
class RunSimulation {
 public:
  RunSimulation(const Rig& rig, const std::vector<const actuator::Actuator*>& actuators,
                const Excitation& excitation, const std::vector<JointStart>& start,
                std::size_t first, std::size_t last, const SimulationOptions& options)
      : excitation_(excitation),
        first_(first),
        last_(last),
        load_(rig),
        models_(make_models(load_, actuators, options)),
        stepper_(load_, models_) {
    run_.joints.resize(models_.size());
    for (std::size_t j = 0; j < models_.size(); ++j)
      state_.joints.push_back(models_[j].initial(start[j]));
    if (load_.is_imposed()) {
      imposed_ = std::make_unique<ImposedMotion>(
          excitation.time_s, excitation.joints[0].speed_rad_s, start[0].position_rad);
      place(imposed_->at(first, excitation.time_s[first]));
    }
    const std::vector<DriveNow> drive = drive_at(first, 0.0);
    set_temperatures(first, 0.0);
    for (std::size_t j = 0; j < models_.size(); ++j) {
      models_[j].settle_states(state_.joints[j], drive[j]);
    }
  }

  SimulatedRun run() {
    const double stored_J = energy_J();
    record(first_);
    for (std::size_t knot = first_; knot < last_ && run_.is_finite; ++knot) {
      interval(knot);
      record(knot + 1);
    }
    run_.work.stored_J = energy_J() - stored_J;
    return std::move(run_);
  }

 private:
  void place(const ImposedMotion::Point& point) {
    JointState& joint = state_.joints[0];
    joint.position_rad = joint.motor_position_rad = point.position_rad;
    joint.speed_rad_s = joint.motor_speed_rad_s = point.speed_rad_s;
  }

  static double between(const std::vector<double>& values, std::size_t knot, double share) {
    const std::size_t next = std::min(knot + 1, values.size() - 1);
    return values[knot] + share * (values[next] - values[knot]);
  }

  std::vector<DriveNow> drive_at(std::size_t knot, double share) const {
    std::vector<DriveNow> drives;
    for (const JointDrive& joint : excitation_.joints) {
      DriveNow drive{joint.kind, between(joint.value, knot, share), joint.position_gain_1_rad, {}};
      if (!joint.bus_V.empty()) drive.bus_V = between(joint.bus_V, knot, share);
      if (!joint.enabled.empty() && joint.enabled[knot] < 0.5) {
        drive.kind = DriveKind::kCurrent;
        drive.value = 0.0;
      }
      drives.push_back(drive);
    }
    return drives;
  }

  void set_temperatures(std::size_t knot, double share) {
    for (std::size_t j = 0; j < models_.size(); ++j) {
      const std::vector<double>& measured = excitation_.joints[j].winding_K;
      if (!measured.empty()) state_.joints[j].winding_K = between(measured, knot, share);
    }
  }

  void advance_states(std::size_t knot, double share, double step_s) {
    const std::vector<DriveNow> drive = drive_at(knot, share);
    for (std::size_t j = 0; j < models_.size(); ++j) {
      models_[j].advance_states(state_.joints[j], drive[j], step_s);
    }
  }

  void heat(const std::vector<DriveNow>& drive, double step_s) {
    for (std::size_t j = 0; j < models_.size(); ++j) {
      if (!excitation_.joints[j].winding_K.empty()) continue;
      const double current_A = models_[j].current_A(state_.joints[j], drive[j]);
      models_[j].heat(state_.joints[j], current_A, step_s);
    }
  }

  /// From a knot to the next: half a step of what has a rate of its own, a step of motion, the
  /// other half (Strang's splitting, second order).
  void interval(std::size_t knot) {
    const double span_s = excitation_.time_s[knot + 1] - excitation_.time_s[knot];
    double longest_s = models_[0].longest_step_s();
    for (const JointModel& model : models_) longest_s = std::min(longest_s, model.longest_step_s());
    const int steps = std::max(1, static_cast<int>(std::ceil(span_s / longest_s - 1e-9)));
    const double step_s = span_s / steps;
    run_.step_s = std::max(run_.step_s, step_s);
    for (int step = 0; step < steps; ++step) {
      const double from = static_cast<double>(step) / steps;
      const double width = 1.0 / steps;
      const std::vector<DriveNow> middle = drive_at(knot, from + 0.5 * width);
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
    set_temperatures(knot, 1.0);
  }

  void step_imposed(std::size_t knot, double from, double width, double step_s,
                    const std::vector<DriveNow>& drive) {
    const double begin_s = excitation_.time_s[knot];
    const double span_s = excitation_.time_s[knot + 1] - begin_s;
    const auto half = imposed_->at(knot, begin_s + (from + 0.5 * width) * span_s);
    const auto full = imposed_->at(knot, begin_s + (from + width) * span_s);
    JointState middle;
    middle.position_rad = half.position_rad;
    middle.speed_rad_s = half.speed_rad_s;
    JointState end;
    end.position_rad = full.position_rad;
    end.speed_rad_s = full.speed_rad_s;
    stepper_.advance_imposed(state_, drive, step_s, middle, end, half.acceleration_rad_s2,
                             run_.work);
  }

  /// At rest a drive on an imposed motion holds whatever lies between what it gives to either side.
  double held_Nm(std::size_t j, const std::vector<DriveNow>& drive,
                 const Eigen::VectorXd& imposed) {
    double least = 0.0;
    double most = 0.0;
    for (const double direction : {1.0, -1.0}) {
      const double torque = stepper_.motion(state_, {direction}, drive, &imposed).torque_Nm[0];
      if (direction > 0.0) least = most = torque;
      least = std::min(least, torque);
      most = std::max(most, torque);
    }
    return std::clamp(state_.joints[j].held_Nm, least, most);
  }

  void record(std::size_t knot) {
    const std::vector<DriveNow> drive = drive_at(knot, 0.0);
    Eigen::VectorXd imposed(1);
    if (imposed_) imposed[0] = imposed_->at(knot, excitation_.time_s[knot]).acceleration_rad_s2;
    const std::vector<double> ways =
        imposed_ && !models_[0].is_elastic()
            ? std::vector<double>{sign_of(state_.joints[0].speed_rad_s)}
            : stepper_.directions(state_, drive);
    RigMotion motion = stepper_.motion(state_, ways, drive, imposed_ ? &imposed : nullptr);
    if (imposed_ && !models_[0].is_elastic() && ways[0] == 0.0) {
      motion.torque_Nm[0] = held_Nm(0, drive, imposed);
    }
    for (std::size_t j = 0; j < models_.size(); ++j) record_joint(j, motion, drive[j]);
  }

  void record_joint(std::size_t j, const RigMotion& motion, const DriveNow& drive) {
    JointState& state = state_.joints[j];
    JointTrace& trace = run_.joints[j];
    const auto row = static_cast<Eigen::Index>(j);
    const double current_A = motion.forces[j].current_A;
    const double bus_V = models_[j].bus_V(state, drive, current_A);
    state.held_Nm = motion.torque_Nm[row];
    trace.position_rad.push_back(state.position_rad);
    trace.speed_rad_s.push_back(state.speed_rad_s);
    trace.acceleration_rad_s2.push_back(motion.acceleration_rad_s2[row]);
    trace.motor_position_rad.push_back(models_[j].ratio() * state.motor_position_rad);
    trace.motor_speed_rad_s.push_back(models_[j].ratio() * state.motor_speed_rad_s);
    trace.current_A.push_back(current_A);
    trace.voltage_V.push_back(models_[j].voltage_V(state, drive, current_A));
    trace.bus_V.push_back(bus_V);
    trace.torque_Nm.push_back(motion.torque_Nm[row]);
    trace.winding_K.push_back(state.winding_K);
    trace.case_K.push_back(state.case_K);
    if (!std::isfinite(state.position_rad) || !std::isfinite(state.speed_rad_s) ||
        !std::isfinite(motion.torque_Nm[row])) {
      run_.is_finite = false;
    }
  }

  double energy_J() const {
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
    return sum + load_.energy_J(position, speed);
  }

  const Excitation& excitation_;
  std::size_t first_, last_;
  LoadDynamics load_;
  std::vector<JointModel> models_;
  Stepper stepper_;
  RigState state_;
  std::unique_ptr<ImposedMotion> imposed_;
  SimulatedRun run_;
};

}  // namespace

SimulatedRun simulate(const Rig& rig, const std::vector<const actuator::Actuator*>& actuators,
                      const Excitation& excitation, const std::vector<JointStart>& start,
                      const SimulationOptions& options) {
  require_sizes(rig, actuators.size(), excitation, start.size());
  return simulate_part(rig, actuators, excitation, start, 0, excitation.time_s.size() - 1, options);
}

SimulatedRun simulate_part(const Rig& rig, const std::vector<const actuator::Actuator*>& actuators,
                           const Excitation& excitation, const std::vector<JointStart>& start,
                           std::size_t first, std::size_t last, const SimulationOptions& options) {
  require_sizes(rig, actuators.size(), excitation, start.size());
  if (first > last || last >= excitation.time_s.size()) {
    throw std::invalid_argument("simulate: no such part");
  }
  return RunSimulation(rig, actuators, excitation, start, first, last, options).run();
}

}  // namespace torquewright::identification
