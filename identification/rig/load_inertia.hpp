// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// Inertia of the load about its axis (mass in kg on a linear axis); 0 where one number does not
/// say it.
double load_inertia_kg_m2(const Load& load);

}  // namespace torquewright::identification
