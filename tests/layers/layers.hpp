// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::layers {

/// Why the file (named from the repository's root) may not include `included`; empty if it may.
/// Names of headers that are not ours are free, but for the solvers, each at home in optimization/.
std::string objection(std::string_view file, std::string_view included);

/// The names in the #include directives of a text, whether "quoted" or <bracketed>.
std::vector<std::string> included_names(std::string_view text);

/// One sentence for every objectionable include of every source under the root. Tests and
/// benchmarks may include anything.
std::vector<std::string> find_objections(const std::filesystem::path& root);

}  // namespace torquewright::layers
