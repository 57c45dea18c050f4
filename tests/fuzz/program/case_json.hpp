// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "tests/fuzz/program/case.hpp"

namespace torquewright::fuzz {

/// A case as a text that keeps every byte, and back. A text that is none throws.
std::string text_of(const Case& one);
Case case_of(const std::string& text);

Case read_case(const std::filesystem::path& file);

}  // namespace torquewright::fuzz
