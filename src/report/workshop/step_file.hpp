// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torquewright::report {

/// The number of an entity in its file.
struct StepId {
  int number = 0;
};

/// The text of a STEP file (ISO 10303-21) of application protocol AP214: entities, a line each.
class StepFile {
 public:
  /// `name` is that of what it describes.
  explicit StepFile(std::string name) : name_(std::move(name)) {}

  /// An entity as it stands behind its number: "DIRECTION('',(0.,0.,1.))".
  StepId add(std::string_view entity);

  /// The whole file. Its time stamp is a fixed one, so that the same gears are the same bytes.
  std::string finished() const;

 private:
  std::string name_;
  std::string data_;
  int count_ = 0;
};

/// "#12", and "(#12,#13)".
std::string step_reference(StepId id);
std::string step_list(const std::vector<StepId>& ids);

/// A length in mm, to a picometre: "12.5", "3.".
std::string step_length(double length_mm);
/// A number without unit, as a direction's.
std::string step_number(double number);
/// A string in its quotes, what is no ASCII as its code.
std::string step_string(std::string_view text);

}  // namespace torquewright::report
