// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/fuzz/program/case.hpp"

namespace torquewright::fuzz {

struct DeclaredOption {
  std::string name;  ///< The longest, such as --output.
  bool has_value = false;
  Words choices{};  ///< Where only some words are allowed.
};

struct DeclaredCommand {
  Words name;  ///< Such as {"actuator", "mor"}.
  std::vector<DeclaredOption> options;
};

/// All commands that the program's help lists, with their options. Throws where there is none.
std::vector<DeclaredCommand> read_vocabulary(const std::filesystem::path& program);

}  // namespace torquewright::fuzz
