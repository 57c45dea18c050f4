// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/program/case.hpp"
#include "tests/fuzz/program/vocabulary.hpp"

namespace torquewright::fuzz {

/// A value that somebody might give by accident or malice, near the one that stands there.
std::string nasty_value(const std::string& value, Random& random);

/// One change to a command line: a value, a word less, a word twice, an option more, another order.
/// `files` are names to put in place of others.
void change_arguments(Words& arguments, const std::vector<DeclaredCommand>& vocabulary,
                      const std::vector<std::string>& files, Random& random);

}  // namespace torquewright::fuzz
