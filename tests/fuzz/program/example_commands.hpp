// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tests/fuzz/program/case.hpp"

namespace torquewright::fuzz {

/// Command lines that work, from the repository's root: at least one of every command, with every
/// kind of option. The fuzzer starts from them.
const std::vector<Words>& example_commands();

}  // namespace torquewright::fuzz
