// SPDX-License-Identifier: Apache-2.0
#include "io/files/new_folder.hpp"

#include <algorithm>
#include <system_error>

#include "io/faults/refusal.hpp"

namespace torquewright::io {

namespace fs = std::filesystem;

NewFolder::NewFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  std::vector<fs::path> missing;  // innermost first
  for (fs::path each = folder; !each.empty() && !fs::exists(each, error);) {
    if (each.has_filename()) missing.push_back(each);
    each = each.parent_path();
  }
  held_.emplace();
  std::reverse(missing.begin(), missing.end());
  for (const fs::path& each : missing) {
    if (fs::create_directory(each, error)) made_.push_back(each);
    if (error) break;
  }
  if (!error) fs::create_directories(folder, error);  // refuses what is there and no folder
  if (!error) return;
  remove_empty();
  refuse(folder.string(), "cannot be made: " + error.message());
}

NewFolder::~NewFolder() { remove_empty(); }

void NewFolder::remove_empty() const {
  std::error_code is_used;
  std::for_each(made_.rbegin(), made_.rend(),
                [&](const fs::path& each) { fs::remove(each, is_used); });
}

}  // namespace torquewright::io
