// SPDX-License-Identifier: Apache-2.0
#include "identification/experiment/plan_trial.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"
#include "identification/preparation/preparation.hpp"
#include "identification/simulated/rig_plant.hpp"

namespace torquewright::identification {
namespace {

constexpr double kPlanStep_s = 1e-3;  ///< Of the simulation; stiff parts get less.
constexpr double kShareOfTorque = 0.002;
constexpr double kShareOfDrive = 0.005;
const double kAngleStep_rad = 2.0 * std::numbers::pi / 16384.0;
const double kBand_1_s = 2.0 * std::numbers::pi * Rows::Options().cutoff_Hz;  ///< As angular speed.

double square(double value) { return value * value; }

/// What the rig's load adds to the inertia: kg m^2, or kg on an axis.
double load_inertia(const Load& load) {
  if (load.type == LoadType::kLinearAxis) return load.mass_kg;
  return load.inertia_kg_m2 + load.mass_kg * square(load.length_m);
}

actuator::Ranges ranges_of_limits(const ExcitationLimits& limits,
                                  const actuator::Actuator& actuator) {
  actuator::Ranges ranges;
  ranges.torque_Nm = limits.greatest_torque_Nm();
  ranges.speed_rad_s = limits.speed_rad_s();
  ranges.acceleration_rad_s2 = kBand_1_s * ranges.speed_rad_s;
  ranges.current_A = limits.current_A(0.0, 1.0);
  ranges.voltage_V = actuator.drive.bus_voltage_V;
  ranges.angle_rad = 2.0 * limits.rig().position_rad.value_or(std::numbers::pi);
  ranges.motor_angle_rad = std::abs(actuator.transmission.ratio) * ranges.angle_rad;
  ranges.warmth_K = 20.0;
  return ranges;
}

/// (rows x 1) The time that each row stands for; 0 in a stretch of one.
Eigen::VectorXd time_of_rows_s(const Rows& rows) {
  Eigen::VectorXd time_s = Eigen::VectorXd::Zero(rows.count());
  Eigen::Index first = 0;
  for (std::size_t s = 0; s < rows.samples().size(); ++s) {
    const std::vector<std::size_t>& samples = rows.samples()[s];
    const auto count = static_cast<Eigen::Index>(samples.size());
    if (count > 1) {
      std::size_t stride = samples[1] - samples[0];
      for (std::size_t k = 2; k < samples.size(); ++k) {
        stride = std::min(stride, samples[k] - samples[k - 1]);
      }
      time_s.segment(first, count)
          .setConstant(static_cast<double>(stride) * rows.signals()[s].step_s);
    }
    first += count;
  }
  return time_s;
}

}  // namespace

std::map<Quantity, double> typical_noise(const Rig& rig, const actuator::Actuator& actuator,
                                         const ExcitationLimits& limits) {
  std::map<Quantity, double> noise;
  for (const ColumnUse& use : rig.columns) {
    switch (use.quantity) {
      case Quantity::kOutputTorque:
      case Quantity::kLinearForce:
        noise[use.quantity] = kShareOfTorque * limits.greatest_torque_Nm();
        break;
      case Quantity::kReportedTorque:
      case Quantity::kCommandedTorque:
        noise[use.quantity] = kShareOfDrive * limits.greatest_torque_Nm();
        break;
      case Quantity::kMotorCurrent:
        noise[use.quantity] = kShareOfDrive * actuator.drive.peak_current_A;
        break;
      case Quantity::kWindingVoltage:
        noise[use.quantity] = kShareOfDrive * actuator.drive.bus_voltage_V;
        break;
      case Quantity::kOutputPosition:
      case Quantity::kMotorPosition:
        noise[use.quantity] = kAngleStep_rad / std::sqrt(12.0);
        break;
      default:
        break;
    }
  }
  return noise;
}

Log noiseless_log(const Rig& rig, const actuator::Actuator& actuator,
                  const std::vector<ExcitationRun>& runs,
                  const std::vector<simulation::SimulatedRun>& simulated) {
  Log log;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const simulation::JointTrace& trace = simulated[r].joints[0];
    Run run;
    run.name = runs[r].name;
    run.time_s = runs[r].excitation.time_s;
    run.masked.assign(run.time_s.size(), 0);
    run.joints.resize(1);
    for (const ColumnUse& use : rig.columns) {
      if (use.quantity == Quantity::kTime) continue;
      run.joints[0][use.quantity] =
          simulated_quantity(use.quantity, actuator, runs[r].excitation, trace);
    }
    log.train_runs.push_back(run.name);
    log.runs.push_back(std::move(run));
  }
  return log;
}

PlanTrial::PlanTrial(const Rig& rig, const actuator::Actuator& actuator,
                     const ExcitationLimits& limits, const std::map<Quantity, double>& noise,
                     const std::vector<ExcitationRun>& first)
    : rig_(rig), actuator_(actuator), limits_(limits), noise_(noise) {
  for (const auto& [quantity, sigma] : noise) levels_[static_cast<std::size_t>(quantity)] = sigma;
  std::vector<ExcitationRun> short_run = {first.front()};
  short_run[0].excitation.time_s.resize(2);
  for (simulation::JointDrive& joint : short_run[0].excitation.joints) {
    joint.value.resize(2);
    if (!joint.speed_rad_s.empty()) joint.speed_rad_s.resize(2);
  }
  const simulation::SimulatedRun simulated = simulation::simulate(
      *plant_of(rig.load), {&actuator}, short_run[0].excitation, {simulation::JointStart{}});
  bench_ = make_bench(rig, noiseless_log(rig, actuator, short_run, {simulated}), 0, {&actuator});
  if (!bench_.has_torque_balance()) return;
  ranges_ = ranges_of_limits(limits, actuator);
}

std::vector<PlannedColumn> PlanTrial::columns(const std::string& effect) const {
  return planned_columns(bench_, ranges_, effect);
}

std::optional<std::vector<simulation::SimulatedRun>> PlanTrial::inside(
    const std::vector<ExcitationRun>& runs, std::size_t stride) const {
  simulation::SimulationOptions options;
  options.longest_step_s = kPlanStep_s;
  const std::unique_ptr<simulation::Plant> plant = plant_of(rig_.load);
  std::vector<simulation::SimulatedRun> simulated;
  for (const ExcitationRun& run : runs) {
    simulated.push_back(
        simulation::simulate(*plant, {&actuator_}, run.excitation, {run.start}, options));
    if (!simulated.back().is_finite || !limits_.hold(simulated.back().joints[0], stride)) return {};
  }
  return simulated;
}

double PlanTrial::noise_density_Nm2_s(double step_s) const {
  const auto sigma = [&](Quantity quantity) {
    const auto found = noise_.find(quantity);
    return found == noise_.end() ? 0.0 : found->second;
  };
  const double ratio = std::abs(actuator_.transmission.ratio);
  const double per_ampere = ratio * actuator_.motor.torque_constant_Nm_A;
  double inertia = actuator::reflected_inertia_kg_m2(actuator_);
  double variance = 0.0;
  if (bench_.load_side == LoadSide::kSensor) {
    variance += square(sigma(bench_.load_channel));
  } else {
    inertia += load_inertia(rig_.load);
  }
  if (bench_.drive == Drive::kCurrent) variance += square(per_ampere * sigma(bench_.drive_channel));
  if (bench_.drive == Drive::kTorque) variance += square(sigma(bench_.drive_channel));
  if (bench_.drive == Drive::kVoltage) {
    const double volt_Nm = per_ampere / actuator::winding_of(actuator_).resistance_ohm;
    const bool is_duty = bench_.drive_channel == Quantity::kDuty;
    variance += square(volt_Nm * sigma(bench_.drive_channel) *
                       (is_duty ? actuator_.drive.bus_voltage_V : 1.0));
  }
  const double position =
      std::max({sigma(Quantity::kOutputPosition), sigma(Quantity::kLinearPosition),
                sigma(Quantity::kMotorPosition) / ratio});
  variance += square(inertia * position) * square(square(kBand_1_s)) / 5.0;
  return variance * step_s;
}

PlanTrial::Information PlanTrial::information(
    const std::vector<ExcitationRun>& runs, const std::vector<simulation::SimulatedRun>& simulated,
    const std::vector<PlannedColumn>& columns) const {
  const Log log = noiseless_log(rig_, actuator_, runs, simulated);
  const std::vector<Signals> signals = prepare(log, bench_, levels_, {});
  const Rows rows(signals, std::vector<std::size_t>(runs.size(), 0), {});
  const double density_Nm2_s = noise_density_Nm2_s(runs.front().excitation.time_s[1]);
  const Eigen::MatrixXd values = planned_rows(bench_, rows, columns);
  const Eigen::VectorXd weight = time_of_rows_s(rows) / density_Nm2_s;
  const Eigen::VectorXd largest =
      rows.count() > 0 ? Eigen::VectorXd(values.cwiseAbs().colwise().maxCoeff().transpose())
                       : Eigen::VectorXd::Zero(values.cols());
  return {values.transpose() * weight.asDiagonal() * values, largest};
}

}  // namespace torquewright::identification
