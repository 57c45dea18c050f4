// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::cli {

/// While one lives, results are kept here and do not go to stdout. At most one at a time.
class HeldOutput {
 public:
  HeldOutput();
  ~HeldOutput();
  HeldOutput(const HeldOutput&) = delete;
  HeldOutput& operator=(const HeldOutput&) = delete;

  const std::string& text() const { return text_; }
  void add(const std::string& text) { text_ += text; }

 private:
  std::string text_;
};

/// The one that lives, or null.
HeldOutput* held_output();

}  // namespace torquewright::cli
