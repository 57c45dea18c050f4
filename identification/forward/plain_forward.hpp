// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/forward/equation.hpp"

namespace torquewright::identification {

/// The equations beside the torque balance, each where its channels are there: twist between motor
/// and output, winding voltage against current and speed, bus voltage against bus current, logged
/// velocity against that of the position. Keeps a reference to the bench.
std::vector<ForwardEquation> plain_forward(const Bench& bench, const std::vector<Signals>& signals);

}  // namespace torquewright::identification
