// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/motor/actuator_spec.hpp"
#include "actuator/region/joint_region.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "src/report/actuator/region_plot.hpp"

namespace torquewright::cli {

/// An actuator under the conditions that a region is asked for.
struct ComparedActuator {
  std::string file;
  actuator::ReadActuator read;
  actuator::OperatingConditions conditions;
};

/// Writes both regions as a table: text, or JSON with its provenance.
std::string comparison_result(const ComparedActuator& from, const ComparedActuator& to,
                              actuator::Side side, bool as_json);

/// A script for gnuplot: the region of `to` shaded, that of `from` dashed over it.
std::string comparison_plot(report::PlotFormat format, const ComparedActuator& from,
                            const ComparedActuator& to, actuator::Side side);

}  // namespace torquewright::cli
