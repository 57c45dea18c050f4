// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::journeys {

/// What the program asks on the terminal, and what is typed then.
struct Answer {
  std::string question;
  std::string typed;
};

/// What a user types next.
struct Step {
  std::vector<std::string> typed;    ///< Lines; several where a file is written.
  std::vector<std::string> printed;  ///< What is shown of the answer; "..." stands for any lines.
  std::vector<Answer> answers;
};

/// The steps of a page: a fenced block below a line that ends with "`NAME`:" is that file, typed
/// into it; in an indented block a line that begins with a program's name is a command, and what
/// stands below it is its answer. Below a command that asks (--from-sheet) "Gear ratio [9]: 10.5"
/// is a question and what is typed.
std::vector<Step> steps_of(const std::string& page);

}  // namespace torquewright::journeys
