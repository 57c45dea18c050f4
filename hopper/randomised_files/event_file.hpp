// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/randomised_files/event_writer.hpp"

namespace torquewright::hopper {

/// Null where that format holds no randomisation.
const EventWriter* find_event_writer(std::string_view format);
/// The formats that do.
std::vector<std::string> randomised_formats();

/// The text to put behind the format's file, its notes included.
std::string events_of(const EventWriter& writer, const Randomisation& randomisation,
                      const Robot& robot, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
