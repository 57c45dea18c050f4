// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/check/report.hpp"

namespace torquewright::actuator {

/// What a drive can do at a sample that lies outside its region, and what is asked of it, told by
/// the way it moves: with its motion it pushes, against it it brakes. Beyond its no-load speed it
/// has to brake, so that the bound stands on the other side of zero than the torque asked for.
std::string outside_words(const WorstSample& sample);

}  // namespace torquewright::actuator
