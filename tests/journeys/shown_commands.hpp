// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::journeys {

/// A command of a page and what the page says that it prints.
struct ShownCommand {
  std::vector<std::string> arguments;  ///< Of the program.
  std::vector<std::string> printed;    ///< Lines; "..." stands for any number of them.
};

/// In the indented blocks of a page of Markdown: a line that begins with "torquewright", and what
/// follows it in its block. Words are split at blanks: pages quote nothing.
std::vector<ShownCommand> commands_of(const std::string& page);

/// The first shown line that is not in the output where it should be; empty where all are. Blank
/// lines do not count, runs of blanks count as one, a line that ends with "..." may go on, and
/// numbers may differ by `share`, or by 5e-3 where they are small: the page is of another machine.
std::string first_unprinted(const std::vector<std::string>& shown, const std::string& output,
                            double share);

}  // namespace torquewright::journeys
