// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::report {

/// The Content-Security-Policy of a page that asks no network and runs this one script of its own.
std::string script_policy(std::string_view script);

}  // namespace torquewright::report
