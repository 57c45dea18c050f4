// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/bam_servos/servo.hpp"

#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "actuator/effects/library.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "identification/reading/read_log.hpp"
#include "io/documents/document.hpp"

namespace torquewright::identification {
namespace {

namespace fs = std::filesystem;

/// Duty per radian of the firmware at gain 1, as published with the log.
constexpr double kDutyPerGain_1_rad = 4096.0 / (2.0 * std::numbers::pi) / (256.0 * 885.0);

fs::path data_folder() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  return variable != nullptr ? fs::path(variable)
                             : fs::path(TORQUEWRIGHT_SOURCE_DIR) / ".." / "shared" / "data";
}

/// Runs 0 to 3, 4 to 7, 8 to 11 of the training file have these gains; the other file has 200.
double gain_of(const std::string& name) {
  if (name.find("heldout") != std::string::npos) return 200.0;
  const int run = std::atoi(name.substr(name.find('/') + 1).c_str());
  return run < 4 ? 100.0 : run < 8 ? 400.0 : 800.0;
}

actuator::Effect servo_effect(std::string_view name, std::vector<double> values) {
  actuator::Effect made;
  made.kind = actuator::find_effect(name);
  made.values = std::move(values);
  return made;
}

/// Values: Kt, R, rotor inertia, viscous, then the model's own.
actuator::Actuator with_values(actuator::Actuator actuator, ServoModel model,
                               std::span<const double> x) {
  actuator.motor.torque_constant_Nm_A = x[0];
  actuator.motor.resistance_ohm = x[1];
  actuator.motor.rotor_inertia_kg_m2 = x[2];
  actuator.effects = {servo_effect("viscous_friction", {x[3]})};
  if (model == ServoModel::kStribeck) {
    actuator.effects.push_back(servo_effect("stribeck_friction", {x[4], x[4] + x[5], x[6]}));
  } else if (model != ServoModel::kViscous) {
    actuator.effects.push_back(servo_effect("coulomb_friction", {x[4]}));
  }
  if (model == ServoModel::kLoad) {
    actuator.effects.push_back(servo_effect("load_dependent_friction", {x[5], x[6]}));
  }
  return actuator;
}

std::vector<optimization::FitVariable> variables(ServoModel model) {
  std::vector<optimization::FitVariable> box{
      {0.1, 0.8, 0.323}, {2.0, 10.0, 4.764}, {2e-4, 1e-2, 0.00164, true}, {0.0, 0.1, 0.0105}};
  if (model != ServoModel::kViscous) box.push_back({0.0, 0.1, 0.007});
  if (model == ServoModel::kStribeck) {
    box.push_back({0.0, 0.1, 0.01});
    box.push_back({0.02, 5.0, 0.5, true});
  }
  if (model == ServoModel::kLoad) {
    box.push_back({0.0, 1.5, 0.2});
    box.push_back({0.0, 0.9, 0.2});
  }
  return box;
}

PositionScoreOptions whole_runs() {
  PositionScoreOptions options;
  options.window_s = 0.0;
  options.longest_step_s = 3e-3;
  return options;
}

}  // namespace

std::optional<ServoLog> read_servo(bool closed_loop) {
  const fs::path folder = data_folder() / "logs" / "bam_servos";
  if (!fs::exists(folder)) return std::nullopt;
  const fs::path rigs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "tests" / "real_data" / "rigs";
  ServoLog servo;
  servo.rig = read_rig(io::read_document(rigs / "bam_servos.json", "rig"));
  servo.nominal = actuator::read_actuator(rigs / "bam_servos_actuator.json").actuator;
  const Log log =
      read_log({folder / "xl330_train.csv", folder / "xl330_heldout_kp200.csv"}, servo.rig);
  PositionScoreOptions options;
  if (closed_loop) {
    for (const Run& run : log.runs) {
      options.position_gain_1_rad.push_back(kDutyPerGain_1_rad * gain_of(run.name));
    }
  }
  for (ReplayedRun& run : replayed_runs(servo.rig, log, options)) {
    // The temperature is the servo's register, of its board: nothing here follows it.
    run.excitation.joints[0].winding_K.clear();
    (run.name.find("heldout") == std::string::npos ? servo.train : servo.held_out)
        .push_back(std::move(run));
  }
  return servo;
}

FittedServo fit_servo(const ServoLog& log, ServoModel model, std::size_t starts,
                      std::size_t most_evaluations) {
  const PositionScoreOptions score = whole_runs();
  optimization::FitOptions options;
  options.starts = starts;
  options.most_evaluations = most_evaluations;
  options.tolerance = 1e-4;
  FittedServo fitted;
  fitted.fit = optimization::fit_locally(
      [&](std::span<const double> x) {
        const actuator::Actuator actuator = with_values(log.nominal, model, x);
        return position_score(log.rig, {&actuator}, log.train, score).mean_absolute_rad;
      },
      variables(model), options);
  fitted.actuator = with_values(log.nominal, model, fitted.fit.point);
  fitted.train = position_score(log.rig, {&fitted.actuator}, log.train, score);
  fitted.held_out = position_score(log.rig, {&fitted.actuator}, log.held_out, score);
  return fitted;
}

}  // namespace torquewright::identification
