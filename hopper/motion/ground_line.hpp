// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/contact/ground_profile.hpp"

namespace torquewright::hopper {

/// Returns the ground in words: "z = 0 m up to x = 0.31 m, then z = 0.085 m".
std::string ground_words(const simulation::GroundProfile& ground);

/// Returns the line of a motion's file that says what its ground is, before the header:
/// "# ground profile: " and these words, numbers with all digits; empty where the ground is flat.
std::string ground_line(const simulation::GroundProfile& ground);

/// Reads the ground out of the lines before a file's header, flat where none of them says it.
/// Throws io::SpecError in the name of `file` where such a line is no ground: other words, numbers
/// beyond 1000 m, edges that do not ascend, or two such lines.
simulation::GroundProfile read_ground(const std::vector<std::string>& comments,
                                      const std::string& file);

}  // namespace torquewright::hopper
