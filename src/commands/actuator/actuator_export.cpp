// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/actuator_export.hpp"

#include <fmt/format.h>

#include "actuator/exporters/simulator_file_json.hpp"
#include "io/faults/spec_error.hpp"
#include "src/commands/shared/origin_lines.hpp"
#include "src/commands/shared/result_json.hpp"

namespace torquewright::cli {

std::string exported_file(const actuator::ReadActuator& read,
                          const actuator::OperatingConditions& conditions,
                          const actuator::Region& region, double table_accuracy,
                          const actuator::Exporter& exporter, actuator::LawFit fit, bool as_json) {
  if (region.at(0.0).is_empty) {
    throw io::SpecError({{read.documents.front().file, "",
                          fmt::format("no torque is possible at rest (limiter {}): there is no "
                                      "region to write",
                                      actuator::name_of(region.at(0.0).why_empty))}});
  }
  // A table holds what the document says; a law of few numbers what it can.
  const bool has_law = !exporter.parameters.empty();
  const actuator::Actuator written =
      has_law ? actuator::as_laws_brake(read.actuator) : read.actuator;
  const actuator::Region written_region(written, conditions, region.side());
  const actuator::MorTable table = actuator::mor_table(written_region, table_accuracy);
  const actuator::Subject subject{written, conditions, written_region, table, fit};
  const actuator::SimulatorFile file =
      actuator::simulator_file(subject, exporter, origin_of("actuator mor", read.documents));
  if (!as_json) return file.text;
  return result_text(actuator::simulator_file_json(subject, file), read.documents);
}

}  // namespace torquewright::cli
