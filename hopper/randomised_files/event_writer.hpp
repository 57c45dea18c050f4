// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/randomised_files/drawn_parts.hpp"

namespace torquewright::hopper {

/// Python behind a simulator's file of drives, and what it leaves out.
struct EventText {
  std::string text;
  std::vector<std::string> left_out;
};

/// A simulator's own form of randomisation. One file each in this folder, one line in
/// every_event_writer.hpp.
struct EventWriter {
  std::vector<std::string_view> formats;  ///< Of `robot export --format` that it stands behind.
  std::string_view source;                ///< Where its terms are defined.
  std::string_view advice;                ///< How to use what is written; sentences.
  EventText (*write)(const DrawnParts&, const Robot&);
};

}  // namespace torquewright::hopper
