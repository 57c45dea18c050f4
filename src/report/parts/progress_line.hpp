// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace torquewright::report {

/// While one lives, what lines of progress show goes to its function and not to stderr: from the
/// thread that does the work, as often as a terminal would see it. At most one at a time.
class ProgressListener {
 public:
  explicit ProgressListener(std::function<void(const std::string&)> heard);
  ~ProgressListener();
  ProgressListener(const ProgressListener&) = delete;
  ProgressListener& operator=(const ProgressListener&) = delete;
};

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
