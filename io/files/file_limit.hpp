// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace torquewright::io {

/// Most bytes of a file that is read: no document comes near this, and a larger file is some other
/// file.
constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20;

}  // namespace torquewright::io
