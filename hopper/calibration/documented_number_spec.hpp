// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper::calibration {

/// A number of a robot's document, and the body or joint that it belongs to.
struct DocumentedNumber {
  std::vector<std::string>
      parts;          ///< Parts of its pointer: "/bodies/0/mass_kg" gives bodies, 0, mass_kg.
  std::string owner;  ///< Name of the body or joint that it belongs to; empty: to neither.
  double value = 0.0;
};

/// Finds the number that a JSON pointer leads to. Throws io::SpecError, for the `option` that
/// stated it, where the text is no pointer or no number stands there. Requires a document of kind
/// `robot`.
DocumentedNumber documented_number(const std::string& pointer, const io::Document& document,
                                   const char* option);

}  // namespace torquewright::hopper::calibration
