// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::hopper {

/// A range from which a number is drawn, every value as likely as any other; never upside down.
struct Range {
  double least = 0.0;
  double greatest = 0.0;
};

/// A range for things with names, each of which draws a number of its own.
struct NamedRange {
  Range range;
  std::vector<std::string> names;  ///< Empty: all there are.
  std::string path;                ///< JSON pointer to it in the document, for objections.
};

}  // namespace torquewright::hopper
