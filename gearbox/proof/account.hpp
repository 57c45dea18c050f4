// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/json_reading.hpp"
#include "gearbox/proof/refutation.hpp"
#include "gearbox/proof/verdict.hpp"

namespace torquewright::gearbox::proof {

/// What the parts of the checker write into.
struct Account {
  Faults faults;
  Counts counts;
  Budget budget;
};

}  // namespace torquewright::gearbox::proof
