// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/oracles/loop_bench/motion.hpp"
#include "tests/oracles/loop_bench/sensing.hpp"

namespace torquewright::oracles::loop {

/// A rig, what is asked of it, how it is recorded, and what its documents do not say.
struct Situation {
  std::string kind;  ///< none, one, two, undecidable or outside.
  std::uint64_t seed = 0;
  Rig rig;
  Loop loop;
  std::vector<Run> runs;
  Sensing sensing;
  std::size_t joint = 0;                         ///< Whose documents lack something.
  std::vector<std::string> hidden;               ///< Names, in the drive's and the sensing's terms.
  std::vector<std::vector<std::string>> accept;  ///< For each, what is right to say.
  std::vector<std::string> coordinates;          ///< Along which a law outside shows.
};

/// What follows from a situation: its log, and what a least squares of the true law makes of it.
struct Made {
  Situation situation;
  std::vector<Record> records;
  std::vector<double> floors;        ///< What the true law leaves: of the current [A], or of the
                                     ///< winding's and the bus' voltage [V].
  std::vector<double> size_floors;   ///< Of each hidden law: rms over what the true law leaves.
  std::vector<bool> is_recoverable;  ///< Every value of it beyond three of its errors.
};

/// Throws std::invalid_argument where the class is unknown.
Situation drawn(const std::string& kind, std::uint64_t seed);
/// The same law hidden by another amount, until it is 1 to 300 floors (at most eight tries).
Made made(const std::string& kind, std::uint64_t seed);

}  // namespace torquewright::oracles::loop
