// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace torquewright::report {

/// Samples that the cursor of a page may stand on, at most, those that are wanted apart.
constexpr Eigen::Index kMostCursorSamples = 1500;

/// A page with a time cursor as far as its `<main>`, under the policy that its own scripts alone
/// run. `further_style` comes after the stylesheet of such pages.
std::string cursor_page_begin(const std::string& title, const std::string& further_style);

/// Returns a page from its last section on: the tool's version, and the script with its numbers
/// (cursor_json); no script where these are empty. `turns`: with that of the turning view.
std::string cursor_page_end(const std::string& numbers, bool turns = false);

}  // namespace torquewright::report
