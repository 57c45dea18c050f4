// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace torquewright::fuzz {

/// Something that reads files from outside. It accepts a file, or throws SpecError; it throws
/// Misbehaviour where it sees itself that it was fooled.
struct Reader {
  std::string name;
  std::string ending;  ///< Of the corpus files that are mutated for it, such as ".json".
  std::function<void(const std::filesystem::path&)> read;
};

struct Misbehaviour : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// All there are: one line each.
std::vector<Reader> readers();

}  // namespace torquewright::fuzz
