// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace torquewright::io {

/// One thing wrong with the user's input: where (file, JSON pointer, possibly empty) and a sentence
/// that names the value and what is allowed.
struct Fault {
  std::string file;
  std::string path;
  std::string message;
};

/// The user's input is wrong: all faults found at once. Caught in main only, exit code 2.
/// what() is one line per fault: `file#/path: message`, or `file: message` where the path is empty.
/// Control characters of the user's text are escaped there, so that a fault stays on its line.
class SpecError : public std::runtime_error {
 public:
  /// Requires at least one fault.
  explicit SpecError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

}  // namespace torquewright::io
