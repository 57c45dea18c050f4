// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/spoilt_log.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test::bad_logs {

constexpr std::size_t kRuns = 4, kRowsPerRun = 1600;

nlohmann::json rig_document();

/// A log by `identify simulate` of an actuator with a Coulomb friction of 0.6 Nm. Columns by name:
/// i_A, q_rad, run, t_s, tau_Nm, w_rad_s; 200 rows a second. `speed_scale` 0: it stands still.
SpoiltLog simulated(double speed_scale);

/// The one good log that all are made of.
SpoiltLog good();

struct Answer {
  Outcome outcome;
  nlohmann::json report;             ///< Of the shape of its schema, without NaN.
  std::vector<std::string> written;  ///< Files that were not there before.
};

/// `identify` with --json and --refined refined.json, with the actuator that declares no friction.
Answer identify(const SpoiltLog& log, const nlohmann::json& rig = rig_document());

/// Exit code 2, a sentence, nothing on stdout, no file.
void expect_refused(const SpoiltLog& log, const std::string& said,
                    const nlohmann::json& rig = rig_document());

void expect_finding(const Answer& answer, const std::string& severity, const std::string& said);

/// The truth is still found, and nothing else.
void expect_truth(const Answer& answer);

/// Exit code 3 with an error among the findings; no name, no file.
void expect_cannot_tell(const Answer& answer, const std::string& said);

}  // namespace torquewright::cli_test::bad_logs
