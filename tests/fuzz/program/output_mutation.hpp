// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/program/case.hpp"
#include "tests/fuzz/program/vocabulary.hpp"

namespace torquewright::fuzz {

/// An output onto something where it does harm or cannot go: an input under one of its names, a
/// link, a pipe, a folder, a full device, another output. Where the command line has no output it
/// gets one.
void change_output(Case& one, const std::vector<DeclaredCommand>& vocabulary, Random& random);

}  // namespace torquewright::fuzz
