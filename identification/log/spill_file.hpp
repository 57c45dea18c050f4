// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace torquewright::identification {

/// Numbers on disk in place of memory: a file without a name in the folder for temporary files,
/// which vanishes with this object or the process. Throws io::SpecError where the disk refuses.
class SpillFile {
 public:
  SpillFile();
  ~SpillFile();
  SpillFile(const SpillFile&) = delete;
  SpillFile& operator=(const SpillFile&) = delete;

  /// Writes at the end and returns the place of the first number.
  std::size_t append(std::span<const double> values);
  /// Overwrites the numbers from `place` on.
  void write(std::size_t place, std::span<const double> values);
  /// Reads as many numbers as `values` holds. Requires that they were written.
  void read(std::size_t place, std::span<double> values) const;

 private:
  int file_ = -1;
  std::size_t end_ = 0;  ///< End of the file, in numbers.
};

}  // namespace torquewright::identification
