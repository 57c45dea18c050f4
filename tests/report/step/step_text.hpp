// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace torquewright::test {

/// An entity of a STEP file: "DIRECTION" and what stands in its brackets. Of a complex one the name
/// is empty and the brackets hold its parts.
struct StepEntity {
  std::string kind;
  std::string content;

  /// The numbers behind #, in their order.
  std::vector<int> references() const;
  /// Strings in their order, as they are written.
  std::vector<std::string> strings() const;
};

/// The entities of a file's DATA section by number; a parser of the few things that tests ask for.
std::map<int, StepEntity> step_entities(const std::string& text);

/// Numbers of the entities of a kind.
std::vector<int> of_kind(const std::map<int, StepEntity>& entities, const std::string& kind);

}  // namespace torquewright::test
