// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/actuator_export.hpp"

#include <fmt/format.h>

#include "actuator/exporters/simulator_file_json.hpp"
#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "src/commands/shared/origin_lines.hpp"
#include "src/commands/shared/result_json.hpp"

namespace torquewright::cli {

std::string exported_file(const actuator::ReadActuator& read, const actuator::Exporter& exporter,
                          const actuator::ExportChoices& choices, bool as_json) {
  const actuator::Region region(read.actuator, choices.conditions, choices.side);
  if (region.at(0.0).is_empty) {
    throw io::SpecError({{read.documents.front().file, "",
                          fmt::format("no torque is possible at rest (limiter {}): there is no "
                                      "region to write",
                                      actuator::name_of(region.at(0.0).why_empty))}});
  }
  const actuator::ExportedDrive drive(read.actuator, exporter, choices);
  const actuator::SimulatorFile file = actuator::simulator_file(
      drive.subject(), exporter, origin_of("actuator mor", read.documents));
  if (!as_json) return file.text;
  return result_text(actuator::simulator_file_json(drive.subject(), file), read.documents);
}

actuator::FrictionPlace friction_place(const std::string& option,
                                       const actuator::Actuator& actuator,
                                       const actuator::Exporter& exporter, actuator::Side side) {
  using actuator::FrictionPlace;
  if (option == name_of(FrictionPlace::kLimits)) return FrictionPlace::kLimits;
  const FrictionPlace usual = usual_place(exporter, actuator, side);
  if (option.empty() || usual == FrictionPlace::kJoint) return usual;
  if (exporter.friction.dry == actuator::DryFriction::kNone) {
    io::refuse("--friction", fmt::format("joint, but {} has no field for it", exporter.name));
  }
  if (side == actuator::Side::kMotor) {
    io::refuse("--friction", "joint, but --side motor is before any friction");
  }
  io::refuse("--friction", fmt::format("joint, but the gear of {} locks itself: no friction of a "
                                       "joint holds that",
                                       actuator.name));
}

}  // namespace torquewright::cli
