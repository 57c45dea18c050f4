// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/mor_compare.hpp"

#include <fmt/format.h>

#include "actuator/mor/mor_table.hpp"
#include "actuator/mor/region_comparison.hpp"
#include "io/text/one_line.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/report/actuator/comparison_json.hpp"
#include "src/report/actuator/comparison_text.hpp"

namespace torquewright::cli {
namespace {

using actuator::Region;

Region region_of(const ComparedActuator& compared, actuator::Side side) {
  return Region(compared.read.actuator, compared.conditions, side);
}

/// The actuator's name, and its file, since refined actuators keep their name.
std::string label_of(const ComparedActuator& compared) {
  return fmt::format("{} ({})", compared.read.actuator.name, io::name_in_text(compared.file));
}

}  // namespace

std::string comparison_result(const ComparedActuator& from, const ComparedActuator& to,
                              actuator::Side side, bool as_json) {
  const actuator::RegionComparison comparison =
      actuator::compare(region_of(from, side), region_of(to, side));
  if (!as_json) return report::comparison_text(label_of(from), label_of(to), comparison);
  std::vector<io::Document> inputs = from.read.documents;
  inputs.insert(inputs.end(), to.read.documents.begin(), to.read.documents.end());
  return result_text(
      report::comparison_json(from.read.actuator.name, to.read.actuator.name, comparison, side),
      inputs);
}

std::string comparison_plot(report::PlotFormat format, const ComparedActuator& from,
                            const ComparedActuator& to, actuator::Side side) {
  const std::vector<report::PlottedRegion> regions{
      {io::name_in_text(to.file), actuator::mor_table(region_of(to, side)),
       to.read.actuator.battery.has_value()},
      {io::name_in_text(from.file), actuator::mor_table(region_of(from, side)),
       from.read.actuator.battery.has_value()}};
  return report::region_plot(
      format, fmt::format("{}: motor operating regions compared", to.read.actuator.name), regions);
}

}  // namespace torquewright::cli
