// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/calibration/calibrate.hpp"
#include "src/report/parts/gnuplot.hpp"

namespace torquewright::report {

/// What `hopper calibrate` was asked and what it found.
struct CalibrationReport {
  std::string robot;
  hopper::calibration::Question question;
  hopper::calibration::Calibration found;
};

/// Are the figures met, and do they say where the free values stand? One sentence.
std::string calibration_verdict(const CalibrationReport& report);

/// Where the value at a pointer comes from, of the free value of that index. Requires a best fit.
std::string calibration_provenance(const CalibrationReport& report, std::size_t index,
                                   const std::string& pointer);

std::string calibration_text(const CalibrationReport& report);

/// The valley: along each free value how near the others bring the figures, as a gnuplot script.
std::string calibration_plot(const CalibrationReport& report, PlotFormat format);

}  // namespace torquewright::report
