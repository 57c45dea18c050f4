// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <matio.h>

#include <string>

namespace torquewright::io {

/// The functions of matio that are used, loaded by the first who asks: linked to every command, the
/// library and the 30 that it needs would make each start 28 ms later.
struct MatioLibrary {
  decltype(&Mat_Open) open = nullptr;
  decltype(&Mat_Close) close = nullptr;
  decltype(&Mat_VarReadNext) read_next = nullptr;
  decltype(&Mat_VarFree) free = nullptr;
  decltype(&Mat_VarGetNumberOfFields) count_fields = nullptr;
  decltype(&Mat_VarGetStructFieldnames) field_names = nullptr;
  decltype(&Mat_VarGetStructFieldByIndex) field = nullptr;
};

/// Returns the library. Throws SpecError about the file that needs it where it is not installed.
const MatioLibrary& matio_library(const std::string& file);

}  // namespace torquewright::io
