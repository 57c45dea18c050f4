// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::report {

/// One line on stderr that is rewritten as work goes on; nothing where stderr is no
/// terminal, or where another process of the same work writes there.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  ///< Wipes the line.
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const std::string& text);

 private:
  bool is_watched_;
};

}  // namespace torquewright::report
