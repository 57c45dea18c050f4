// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/verdict.hpp"

namespace torquewright::bench {

/// What one solver made of a problem. Seconds are those of the whole process, start included.
struct TimedAnswer {
  double seconds = 0;
  double cpu_seconds = 0;
  bool timed_out = false;
  Answer answer;
  std::string effort = {};  ///< What the solver says of its own work; only ours does.
};

/// Our search: the installed program as a whole process,
/// `PROGRAM gearbox optimize FILE --json --timing --relaxation WHEN`. Nothing if the program cannot
/// be run.
std::optional<TimedAnswer> run_ours(const gearbox::Problem& problem,
                                    const std::filesystem::path& program,
                                    const std::string& relaxation, double timeout_s);

struct BonminSettings {
  bool rings_eliminated = false;
  int resolves = 0;
};
std::optional<TimedAnswer> run_bonmin(const gearbox::Problem& problem,
                                      const std::filesystem::path& driver,
                                      const BonminSettings& settings, double timeout_s);

/// MiniZinc with Gecode on bench/peers/gearbox.mzn.
std::optional<TimedAnswer> run_minizinc(const gearbox::Problem& problem, double timeout_s);

/// The data of gearbox.mzn. Throws std::invalid_argument where a number exceeds Gecode's 31 bits.
std::string minizinc_data(const gearbox::Problem& problem);

}  // namespace torquewright::bench
