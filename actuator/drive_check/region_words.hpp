// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/drive_check/report.hpp"

namespace torquewright::actuator {

/// Describes what a drive can do at a sample outside its region, and what is asked of it, by its
/// direction: with its motion it pushes, against it it brakes. Beyond its no-load speed it has to
/// brake, so that the bound has the other sign than the torque asked for.
std::string outside_words(const WorstSample& sample);

}  // namespace torquewright::actuator
