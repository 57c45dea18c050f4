// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "io/files/signals_held.hpp"

namespace torquewright::io {

/// A folder for files that are about to be written, made with those around it where they are
/// missing. What was made and is still empty when this goes is removed again; signals wait for
/// that. Of a folder that is there nothing changes, and no signal waits.
class NewFolder {
 public:
  /// Throws SpecError where it cannot be made.
  explicit NewFolder(const std::filesystem::path& folder);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

 private:
  void remove_empty() const;

  std::optional<SignalsHeld> held_;
  std::vector<std::filesystem::path> made_;  ///< Outermost first.
};

}  // namespace torquewright::io
