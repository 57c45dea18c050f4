// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "io/faults/spec_error.hpp"

namespace torquewright::test {

/// What a call refuses, without the file's folder; empty: it does not.
template <typename Call>
std::string refusal(const Call& call, const std::filesystem::path& folder = {}) {
  try {
    call();
    return "";
  } catch (const io::SpecError& error) {
    std::string lines = error.what();
    const std::string prefix = folder.empty() ? "" : folder.string() + "/";
    for (auto at = lines.find(prefix); !prefix.empty() && at != std::string::npos;
         at = lines.find(prefix)) {
      lines.erase(at, prefix.size());
    }
    return lines;
  }
}

}  // namespace torquewright::test
