// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "tests/fuzz/program/scene.hpp"

namespace torquewright::fuzz {

/// Whether the word is an option that names a file to be written, such as --report.
bool names_output(const std::string& word);

/// Files that a command line may write: the words after such options, as they stand there and
/// without what stands before a "=".
std::set<std::string> outputs_of(const Words& arguments);

/// Files in the scene that it may read: those that other words name, those in folders that they
/// name, and those that documents among these name, and so on.
std::set<std::string> inputs_of(const Words& arguments, const Scene& scene);

}  // namespace torquewright::fuzz
