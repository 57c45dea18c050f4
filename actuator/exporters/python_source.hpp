// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace torquewright::actuator {

/// Python that is the same for every actuator: a class of regions, which clips arrays of any
/// library, and what Isaac Lab and mjlab make of one. Nothing but `sys` is imported.
extern const std::string_view kPythonSource;

}  // namespace torquewright::actuator
