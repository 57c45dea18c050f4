// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace torquewright::cli {

/// Columns of the window that standard output is; 0 where it is none.
std::size_t window_columns();

/// A text for people with no line longer than `columns`: longer ones go on below where their own
/// text begins, behind a label or a number. Words stay whole. 0 columns: as it is.
std::string broken_into(const std::string& text, std::size_t columns);

/// The same for the window that standard output is, with colours where it shows them. With -q its
/// first line alone, or `answer` where that says more; with -v also the documents that were read
/// and what they assume.
std::string for_window(const std::string& text, const std::string& answer = "");

}  // namespace torquewright::cli
