// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tests/fuzz/program/case.hpp"
#include "tests/fuzz/program/scene.hpp"
#include "tests/fuzz/program/vocabulary.hpp"

namespace torquewright::fuzz {

/// The case of that number: an example command line with some changes to its arguments, the files
/// that it reads and those that it writes. The same seed and number give the same case.
Case draw_case(std::uint64_t seed, std::uint64_t number,
               const std::vector<DeclaredCommand>& vocabulary, const Scene& scene);

}  // namespace torquewright::fuzz
