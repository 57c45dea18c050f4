// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/gearbox_rules.hpp"

namespace torquewright::oracles {

bool is_3k(const gearbox::Problem& problem);
bool is_buildable(const gearbox::Problem& problem);

/// Rules between integers and fractions: decided exactly.
std::vector<Rule> exact_rules(const Setting& setting);

/// Rules with angles and roots: decided in long double, near-ties flagged.
std::vector<Rule> real_rules(const Setting& setting);

/// Rules on reported quantities, as far as the problem states them.
std::vector<Rule> floor_rules(const Setting& setting);

}  // namespace torquewright::oracles
