// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/process.hpp"
#include "bench/scratch_file.hpp"
#include "bench/timed_answer.hpp"
#include "tests/oracles/problem_document.hpp"

namespace torquewright::bench {
namespace {

Answer answer_in(const nlohmann::json& result) {
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

std::string effort_in(const nlohmann::json& result) {
  if (!result.contains("search")) return "";
  const nlohmann::json& search = result.at("search");
  return fmt::format("{} nodes, {} Ipopt solves, {:.3g} s in the search",
                     search.at("nodes").get<std::int64_t>(),
                     search.at("relaxations").get<std::int64_t>(), search.value("seconds", 0.0));
}

}  // namespace

std::optional<TimedAnswer> run_ours(const gearbox::Problem& problem,
                                    const std::filesystem::path& program,
                                    const std::string& relaxation, double timeout_s) {
  const ScratchFile file(oracles::problem_document(problem).dump(), ".json");
  const ProcessOutcome outcome = run_process({program.string(), "gearbox", "optimize", file.path(),
                                              "--json", "--timing", "--relaxation", relaxation},
                                             timeout_s);
  // posix_spawn reports a program that does not exist; 127 is what older systems exit with.
  if (!outcome.started || outcome.exit_code == 127) return std::nullopt;
  const nlohmann::json result = nlohmann::json::parse(outcome.output, nullptr, false);
  return TimedAnswer{outcome.seconds, outcome.cpu_seconds, outcome.timed_out, answer_in(result),
                     effort_in(result)};
}

}  // namespace torquewright::bench
