// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/workshop/gear_bodies.hpp"

namespace torquewright::report {

/// A STEP file (AP214, mm) of the assembled train: each gear a product with one solid, each place
/// where it stands a named occurrence of it in the product of the gearbox.
std::string gear_step(const GearBodies& bodies);

}  // namespace torquewright::report
