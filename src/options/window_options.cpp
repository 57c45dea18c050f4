// SPDX-License-Identifier: Apache-2.0
#include "src/options/window_options.hpp"

#include <fmt/format.h>

#include "io/faults/refusal.hpp"
#include "src/options/echo_places.hpp"

namespace torquewright::cli {

std::vector<command_line::Option> add_window_options(command_line::Command& command,
                                                     WindowOptions& options) {
  return {command.add_option("--from", options.from_s, "Take only rows from this time on, in s")
              .otherwise("the first row")
              .between(-1e12, 1e12)
              .stated_as("from_s", kInputsPlace),
          command.add_option("--until", options.until_s, "Take only rows up to this time, in s")
              .otherwise("the last row")
              .between(-1e12, 1e12)
              .stated_as("until_s", kInputsPlace)};
}

actuator::Window window_of(const WindowOptions& options) {
  actuator::Window window;
  if (options.from_s) window.from_s = *options.from_s;
  if (options.until_s) window.until_s = *options.until_s;
  if (window.from_s > window.until_s) {
    io::refuse("--from",
               fmt::format("{} s lies after --until {} s", window.from_s, window.until_s));
  }
  return window;
}

}  // namespace torquewright::cli
