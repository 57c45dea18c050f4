// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "identification/experiment/excitation.hpp"
#include "identification/experiment/planned_columns.hpp"
#include "identification/signals/channel_noise.hpp"
#include "simulation/run/simulate.hpp"

namespace torquewright::identification {

/// Returns typical noise of a rig's sensors, where nothing is stated (choices of ours): torque and
/// force 0.2 % of the actuator's greatest, current and voltage 0.5 % of their peak, angles a step
/// of 14 bits over sqrt 12.
std::map<Quantity, double> typical_noise(const Rig& rig, const actuator::Actuator& actuator,
                                         const ExcitationLimits& limits);

/// Simulates the nominal actuator without noise and returns its log, as if it had been read.
Log noiseless_log(const Rig& rig, const actuator::Actuator& actuator,
                  const std::vector<ExcitationRun>& runs,
                  const std::vector<simulation::SimulatedRun>& simulated);

/// Tries excitations of the nominal actuator on a rig. Columns are made for what the limits allow,
/// not for what one excitation reaches: all are asked for the same parameters.
class PlanTrial {
 public:
  /// `first` is any excitation of the rig; it tells which channels there are.
  PlanTrial(const Rig& rig, const actuator::Actuator& actuator, const ExcitationLimits& limits,
            const std::map<Quantity, double>& noise, const std::vector<ExcitationRun>& first);

  bool has_torque_balance() const { return bench_.has_torque_balance(); }
  const Bench& bench() const { return bench_; }
  std::vector<PlannedColumn> columns(const std::string& effect) const;

  /// Returns the simulated runs if every `stride`-th sample is inside the limits, else nothing.
  std::optional<std::vector<simulation::SimulatedRun>> inside(
      const std::vector<ExcitationRun>& runs, std::size_t stride) const;

  struct Information {
    Eigen::MatrixXd matrix;   ///< Fisher information of the columns' coefficients.
    Eigen::VectorXd largest;  ///< Largest magnitude of each column, in the equation's torque.
  };
  /// Computes the Fisher information of an excitation. Noise counts by its density at low
  /// frequency: columns are slow beside the sampling rate, so every raw sample informs. Noise of an
  /// angle counts by its mean density in the band.
  Information information(const std::vector<ExcitationRun>& runs,
                          const std::vector<simulation::SimulatedRun>& simulated,
                          const std::vector<PlannedColumn>& columns) const;

 private:
  double noise_density_Nm2_s(double step_s) const;

  const Rig& rig_;
  const actuator::Actuator& actuator_;
  const ExcitationLimits& limits_;
  std::map<Quantity, double> noise_;
  NoiseLevels levels_{};
  Bench bench_;
  actuator::Ranges ranges_;
};

}  // namespace torquewright::identification
