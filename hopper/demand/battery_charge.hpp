// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// Returns a finding on each battery whose cells state a capacity: what share of it a run of the
/// motion takes and for how many runs it lasts, a violation where that is fewer than are asked for.
/// Its charge is what the conditions say, else full; a pause draws nothing. `torques_Nm` is by
/// drive and sample, rotors included. docs/derivations/whole_body_check.md eq. (13a).
std::vector<Finding> battery_charge_findings(const CheckedMotion& checked,
                                             const Eigen::MatrixXd& torques_Nm);
/// The same of what a run drew, by supply in the order of drive_supplies(), in Ah.
std::vector<Finding> battery_charge_findings(const Robot& robot,
                                             const actuator::OperatingConditions& conditions,
                                             const std::vector<double>& drawn_Ah,
                                             std::size_t runs = 1);

}  // namespace torquewright::hopper
