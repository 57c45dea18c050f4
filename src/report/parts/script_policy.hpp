// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torquewright::report {

/// The Content-Security-Policy of a page that asks no network and runs these scripts of its own
/// alone.
std::string script_policy(const std::vector<std::string_view>& scripts);

}  // namespace torquewright::report
