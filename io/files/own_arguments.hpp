// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::io {

/// The words that this process was started with, as the system keeps them: with these
/// /proc/self/exe is started as it was. Where a loader was started that started the program
/// (packages/portable) they are the loader's, which main does not get. Empty where nothing tells.
/// Uses nothing that has to begin before it.
std::vector<std::string> own_arguments();

}  // namespace torquewright::io
