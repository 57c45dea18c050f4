// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {

/// Index of the name among the known ones. None, and a fault at that place with the nearest name,
/// if it is not among them. `what` is in words: "body".
std::optional<std::size_t> find_name(const std::vector<std::string>& known, const std::string& name,
                                     const std::string& what, io::Fault place,
                                     std::vector<io::Fault>& faults);

}  // namespace torquewright::hopper
