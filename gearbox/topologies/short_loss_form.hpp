// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/train/power_flow.hpp"

namespace torquewright::gearbox {

/// The efficiencies of a reported design if every mesh lost by the short form of the loss integral,
/// Lambda = e_A^2 + e_R^2 - e_A - e_R + 1, which many tables use beyond its domain.
/// docs/derivations/efficiency.md, after eq. (8).
TrainEfficiency short_form_efficiency(std::string_view topology, const DesignReport& report);

}  // namespace torquewright::gearbox
