// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "io/atomic_file.hpp"

namespace torquewright::cli {

/// While one lives, results are kept here and do not go to stdout. At most one at a time.
class HeldOutput {
 public:
  HeldOutput();
  ~HeldOutput();
  HeldOutput(const HeldOutput&) = delete;
  HeldOutput& operator=(const HeldOutput&) = delete;

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Writes a command's result to stdout. Throws SpecError if not all of it gets there.
void print_result(const std::string& text);

/// The same to the file of -o, where one was named; together with the files beside it, all or none.
void deliver_result(const std::string& text, const std::string& file,
                    std::vector<io::FileContent> beside = {});

}  // namespace torquewright::cli
