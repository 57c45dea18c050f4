// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>
#include <vector>

namespace torquewright::fuzz {

using Random = std::mt19937_64;

/// A text near one of the corpus: a few random changes to its bytes or, where it is JSON, to its
/// structure. The same state of `random` gives the same text on every machine.
std::string mutated(const std::vector<std::string>& corpus, Random& random);

}  // namespace torquewright::fuzz
