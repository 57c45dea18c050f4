// SPDX-License-Identifier: Apache-2.0
#include "simulation/in_engine/joint_in_engine.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"
#include "simulation/plants/dynamometer.hpp"
#include "simulation/stepper/stepper.hpp"

namespace torquewright::simulation {

struct JointInEngine::Parts {
  Parts(const actuator::Actuator& of, const SimulationOptions& with)
      : actuator(of), options(with), models{JointModel(of, 0.0, with)}, stepper(plant, models) {}

  const JointModel& model() const { return models.front(); }
  JointState& joint() { return state.joints.front(); }

  /// The output turns as the engine says; of a rigid train the motor with it.
  void place(double position_rad, double speed_rad_s) {
    JointState& now = joint();
    now.position_rad = position_rad;
    now.speed_rad_s = speed_rad_s;
    if (model().is_elastic()) return;
    now.motor_position_rad = position_rad;
    now.motor_speed_rad_s = speed_rad_s;
  }

  /// In equilibrium under what the motor makes: the twist carries it, lags have caught up.
  void begin(const OutputStep& output, const DriveNow& drive, double direction) {
    JointStart start;
    start.position_rad = output.position_rad;
    start.speed_rad_s = output.speed_rad_s;
    const double winding_K = joint().temperature.winding_K;
    joint() = model().initial(start);
    joint().temperature.winding_K = winding_K;
    model().settle_states(joint(), drive);
    if (model().is_elastic()) {
      const double before_Nm = model().forces(joint(), direction, drive).before_mesh_Nm;
      const double after_Nm = actuator::after_mesh_Nm(actuator, before_Nm, direction);
      joint().motor_position_rad += model().twist_rad_under(after_Nm);
    }
    has_begun = true;
  }

  double rigid_Nm(const DriveNow& drive, double direction) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(1);
    return stepper.equations().motion(state, {direction}, {drive}, &none).torque_Nm[0];
  }

  double elastic_Nm(const OutputStep& output, const DriveNow& drive) {
    const int count =
        std::max(1, static_cast<int>(std::ceil(output.step_s / model().longest_step_s() - 1e-9)));
    const double part_s = output.step_s / count;
    WorkAccount unused;
    double sum_Nm = 0.0;
    for (int part = 0; part < count; ++part) {
      const auto at_rad = [&](double parts) {
        return output.position_rad + output.speed_rad_s * part_s * (part + parts);
      };
      const ImposedStep imposed{at_rad(0.5), output.speed_rad_s, 0.0, at_rad(1.0),
                                output.speed_rad_s};
      sum_Nm += stepper.advance_imposed(state, {drive}, part_s, imposed, unused);
    }
    return sum_Nm / count;
  }

  const actuator::Actuator& actuator;
  SimulationOptions options;
  Dynamometer plant;
  std::vector<JointModel> models;
  Stepper stepper;
  PlantState state{{JointState{}}};
  bool has_begun = false;
};

JointInEngine::JointInEngine(const actuator::Actuator& actuator, const SimulationOptions& options)
    : parts_(std::make_unique<Parts>(actuator, options)) {
  start();
}
JointInEngine::JointInEngine(const JointInEngine& other)
    : parts_(std::make_unique<Parts>(other.parts_->actuator, other.parts_->options)) {
  parts_->state = other.parts_->state;
  parts_->has_begun = other.parts_->has_begun;
}
JointInEngine& JointInEngine::operator=(const JointInEngine& other) {
  return *this = JointInEngine(other);
}
JointInEngine::JointInEngine(JointInEngine&&) noexcept = default;
JointInEngine& JointInEngine::operator=(JointInEngine&&) noexcept = default;
JointInEngine::~JointInEngine() = default;

bool JointInEngine::is_elastic() const { return parts_->model().is_elastic(); }

void JointInEngine::start() {
  parts_->joint() = parts_->model().initial({});
  parts_->has_begun = false;
}

double JointInEngine::motor_speed_rad_s(double output_speed_rad_s) const {
  if (!is_elastic() || !parts_->has_begun) return output_speed_rad_s;
  return state().motor_speed_rad_s;
}

double JointInEngine::advance(const OutputStep& output, const DriveNow& drive, double direction,
                              double winding_K) {
  Parts& parts = *parts_;
  parts.joint().temperature.winding_K = winding_K;
  if (!parts.has_begun) parts.begin(output, drive, direction);
  parts.place(output.position_rad, output.speed_rad_s);
  const double half_s = 0.5 * output.step_s;
  parts.model().advance_states(parts.joint(), drive, half_s);
  double torque_Nm = 0.0;
  if (is_elastic()) {
    torque_Nm = parts.elastic_Nm(output, drive);
  } else {
    parts.place(output.position_rad + half_s * output.speed_rad_s, output.speed_rad_s);
    torque_Nm = parts.rigid_Nm(drive, direction);
  }
  parts.model().advance_states(parts.joint(), drive, half_s);
  parts.place(output.position_rad + output.step_s * output.speed_rad_s, output.speed_rad_s);
  return torque_Nm;
}

const JointState& JointInEngine::state() const { return parts_->state.joints.front(); }

}  // namespace torquewright::simulation
