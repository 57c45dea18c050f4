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
  /// Throws cli::Interrupted where that is asked for (src/interrupt.hpp): work that shows its
  /// progress can be left there.
  void show(const std::string& text);

 private:
  void write(const std::string& text) const;

  bool is_watched_;
};

}  // namespace torquewright::report
