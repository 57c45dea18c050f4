// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::actuator {

/// The exported module's parts, in the order in which they stand there.

/// Lines between points, with rows that are found by arithmetic.
std::string_view python_lines();

/// What array libraries have in common, and what not.
std::string_view python_libraries();

/// A region, its friction and gear as arrays.
std::string_view python_tables();

/// The same over voltage and temperature.
std::string_view python_conditions();

/// The same as one launch on a GPU.
std::string python_launches();

}  // namespace torquewright::actuator
