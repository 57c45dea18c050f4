// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace torquewright::bench {

/// A temporary file that goes with its owner.
class ScratchFile {
 public:
  ScratchFile(const std::string& text, const std::string& ending) {
    std::string name =
        (std::filesystem::temp_directory_path() / ("torquewright-bench-XXXXXX" + ending)).string();
    const int file = mkstemps(name.data(), static_cast<int>(ending.size()));
    if (file < 0) throw std::runtime_error("cannot write " + name);
    path_ = name;
    const bool written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    close(file);
    if (!written) throw std::runtime_error("cannot write " + name);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace torquewright::bench
