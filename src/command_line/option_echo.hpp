// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/command_line/declaration.hpp"

namespace torquewright::command_line {

/// A key under "options" of a result, and what stands there.
struct EchoedOption {
  std::string key;
  OptionValue value;
};

/// Returns what a result says of the options of a command whose arguments were read, in its order.
std::vector<EchoedOption> echoed_options(const DeclaredCommand& command);

/// Returns that and what the result says elsewhere: all that an answer depends on beside its files.
std::vector<EchoedOption> counted_options(const DeclaredCommand& command);

/// The names of options that ask for what shows one answer, where they were named.
std::vector<std::string> named_of_one_answer(const DeclaredCommand& command);

}  // namespace torquewright::command_line
