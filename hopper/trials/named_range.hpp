// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::hopper {

/// A range from which a number is drawn uniformly; least <= greatest.
struct Range {
  double least = 0.0;
  double greatest = 0.0;
};

/// A range for things with names, each of which draws its own number.
struct NamedRange {
  Range range;
  std::vector<std::string> names;  ///< Names; empty: all things.
  std::string path;                ///< JSON pointer to it in the document, for messages.
};

}  // namespace torquewright::hopper
