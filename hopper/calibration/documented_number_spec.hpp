// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper::calibration {

/// A number of a robot's document, and whose it is.
struct DocumentedNumber {
  std::vector<std::string>
      parts;          ///< Of its pointer: "/bodies/0/mass_kg" gives bodies, 0, mass_kg.
  std::string owner;  ///< Name of the body or joint that it stands in; empty: in neither.
  double value = 0.0;
};

/// Where the JSON pointer leads. Throws io::SpecError, for the `option` that stated it, where the
/// text is no pointer or no number stands there. Requires a document of kind `robot`.
DocumentedNumber documented_number(const std::string& pointer, const io::Document& document,
                                   const char* option);

}  // namespace torquewright::hopper::calibration
