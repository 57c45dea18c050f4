// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::test {

/// How often this program has asked for memory, by new or by malloc and its kin. Only for programs
/// linked with the wrapping of malloc (tests/dynamics/CMakeLists.txt).
long allocation_count();

}  // namespace torquewright::test
