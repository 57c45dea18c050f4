// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "actuator/severity.hpp"
#include "identification/answer/identify.hpp"

namespace torquewright::report {

/// What an identification was asked, beside its outcome.
struct IdentificationContext {
  std::vector<std::string> log_files;
  std::string rig_file;
  std::string rig_name;
  std::vector<std::string> actuator_files;  ///< In the order of the rig's joints.
  /// Written; the same order, with an empty name where none was, or empty.
  std::vector<std::string> refined_files;
  std::vector<std::string> logged;  ///< Quantities of the rig's columns.
  bool select = true;               ///< False: `identify residual`.
  std::string as_written = {};      ///< What those written leave (written_sentence).
  /// Whether an actuator's file is one that other commands read, and not made of a robot's joint.
  std::vector<bool> has_actuator_files = {};
  /// What is refined are values that a simulation of the robot gave, and not what equations named.
  bool is_fitted_by_simulation = false;
  /// Of what is said of the log.
  actuator::Severity least = actuator::Severity::kNote;
};

/// What texts and pictures of an identification share.

/// 0.1234 ± 0.0012: as many digits as the standard error bears.
std::string with_error(double value, double standard_error);

/// "driving_coefficient 0.123 ± 0.004", one for each parameter, with its unit where it has one.
std::vector<std::string> parameter_texts(const identification::NamedEffect& effect);

/// The same for a value that the rig calls uncertain.
std::string correction_text(const identification::Correction& correction);

/// "output_torque_Nm", with the joint before it on a serial arm.
std::string name_of_equation(const identification::EquationResult& equation);

/// Returns the band that counts, "up to 8 Hz"; of a map without time, whose rows have none, "row by
/// row".
std::string band_words(const identification::EquationResult& equation);

/// "load_torque_Nm x direction".
std::string name_of_coordinate(const identification::ResidualStructure& structure);

/// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& names);

/// The effects of a model: "a + b"; of none: "as stated".
std::string name_of_model(const identification::ModelWithinNoise& model);

/// What to do now: commands or measurements, a line each.
std::vector<std::string> next_steps(const identification::Identification& found,
                                    const IdentificationContext& context);

/// What documents with what was found leave, by `judged`, which is the logs with them; and what
/// stands in them although the log does not tell it from others.
std::string written_sentence(const identification::Identification& found,
                             const identification::Identification& judged);

/// Held-out error where there is one, else that of the fitted runs.
double shown_error(const identification::Errors& errors);

/// One bar of a waterfall: the error with all effects up to this one.
struct WaterfallStep {
  std::string label;
  double rms = 0.0;
};

/// The nominal model, then the effects in the order in which they were added.
std::vector<WaterfallStep> waterfall(const identification::EquationResult& equation);

/// True where there is more to say of it than that it is noise.
bool is_of_interest(const identification::EquationResult& equation);

}  // namespace torquewright::report
