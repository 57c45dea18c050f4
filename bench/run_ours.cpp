// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "bench/process.hpp"
#include "bench/scratch_file.hpp"
#include "bench/timed_answer.hpp"

namespace torquewright::bench {
namespace {

// GMP rounds towards zero; a quotient of doubles is the nearest one, which prints as the decimal
// that the fraction stands for.
double nearest(const io::Rational& value) {
  return value.get_num().get_d() / value.get_den().get_d();
}

nlohmann::json document(const gearbox::Problem& problem) {
  return {{"kind", "gearbox_problem"},
          {"version", 1},
          {"name", problem.name},
          {"topology", problem.topology},
          {"target_ratio", nearest(problem.target_ratio)},
          {"ratio_tolerance", nearest(problem.ratio_tolerance)},
          {"rotor_inner_diameter_mm", nearest(problem.rotor_inner_diameter_mm)},
          {"module_mm", nearest(problem.module_mm.at(0))},
          {"planet_count", problem.planet_count.at(0)},
          {"min_teeth", problem.min_teeth},
          {"min_carrier_clearance_rad", nearest(problem.min_carrier_clearance_rad)},
          {"constraints", "paper"},
          {"objective", "paper_cost"}};
}

Answer answer_in(const std::string& output) {
  const nlohmann::json result = nlohmann::json::parse(output, nullptr, false);
  if (!result.is_object()) return {"no result", {}};
  Answer answer{result.value("status", "none"), {}};
  const auto designs = result.find("designs");
  if (designs != result.end() && !designs->empty()) {
    const nlohmann::json& teeth = designs->at(0).at("teeth");
    for (const char* gear : {"sun", "planet_1", "planet_2"}) {
      answer.teeth.push_back(teeth.at(gear).get<std::int64_t>());
    }
  }
  return answer;
}

}  // namespace

std::optional<TimedAnswer> run_ours(const gearbox::Problem& problem,
                                    const std::filesystem::path& program, double timeout_s) {
  const ScratchFile file(document(problem).dump(), ".json");
  const ProcessOutcome outcome = run_process(
      {program.string(), "gearbox", "optimize", file.path(), "--json", "--timing"}, timeout_s);
  // posix_spawn reports a program that does not exist; 127 is what older systems exit with.
  if (!outcome.started || outcome.exit_code == 127) return std::nullopt;
  return TimedAnswer{outcome.seconds, outcome.timed_out, answer_in(outcome.output)};
}

}  // namespace torquewright::bench
