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

/// Whether the file keeps what is done point by point: it is written as they are done.
bool is_journal(const Words& arguments, const std::string& file);

/// Files that a command line may write: the words after such options, as they stand there and
/// without what stands before a "=", and of what is done point by point their journals.
std::set<std::string> outputs_of(const Words& arguments);

/// Files in the scene that it may read: those that other words name, those in folders that they
/// name, and those that documents among these name, and so on.
std::set<std::string> inputs_of(const Words& arguments, const Scene& scene);

}  // namespace torquewright::fuzz
