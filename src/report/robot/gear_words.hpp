// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/check/transmission_load.hpp"

namespace torquewright::report {

/// What passes a transmission, in words, with its verdict where it has a limit: a mean over a
/// window, and how much of it is the rotor's impulse in an impact, which counts by its size
/// whichever way it goes. `time` is the window's begin as the report writes times.
std::string gear_words(const hopper::TransmissionLoad& load, const std::string& time);

}  // namespace torquewright::report
