// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/fuzz/mutation.hpp"

namespace torquewright::fuzz {

/// A table (CSV) with one change that logs suffer: to a cell, a row, a column, the header, the
/// clock, or the bytes.
std::string changed_table(const std::string& table, Random& random);

}  // namespace torquewright::fuzz
