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

/// Of a rig's sensors, where nothing is stated: torque and force 0.2 % of the actuator's greatest,
/// current and voltage 0.5 % of their peak, angles a step of 14 bits over sqrt 12.
std::map<Quantity, double> typical_noise(const Rig& rig, const actuator::Actuator& actuator,
                                         const ExcitationLimits& limits);

/// A log of the nominal actuator without noise, as if it had been read.
Log noiseless_log(const Rig& rig, const actuator::Actuator& actuator,
                  const std::vector<ExcitationRun>& runs,
                  const std::vector<simulation::SimulatedRun>& simulated);

/// Tries excitations of the nominal actuator on a rig. Columns are made for what the limits allow,
/// not for what one excitation reaches: all are asked for the same parameters.
class PlanTrial {
 public:
  /// `first`: any excitation of the rig, for its channels.
  PlanTrial(const Rig& rig, const actuator::Actuator& actuator, const ExcitationLimits& limits,
            const std::map<Quantity, double>& noise, const std::vector<ExcitationRun>& first);

  bool has_torque_balance() const { return bench_.has_torque_balance(); }
  const Bench& bench() const { return bench_; }
  std::vector<PlannedColumn> columns(const std::string& effect) const;

  /// The simulated runs if every `stride`-th sample is inside the limits.
  std::optional<std::vector<simulation::SimulatedRun>> inside(
      const std::vector<ExcitationRun>& runs, std::size_t stride) const;

  struct Information {
    Eigen::MatrixXd matrix;   ///< Fisher information of the columns' coefficients.
    Eigen::VectorXd largest;  ///< Of each column's magnitude, in the equation's torque.
  };
  /// Noise counts by its density at low frequency: columns are slow beside the sampling rate, and
  /// so every raw sample informs. Noise of an angle counts by its mean density in the band.
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
