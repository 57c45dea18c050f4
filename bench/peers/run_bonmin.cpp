// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "bench/peers/problem_options.hpp"
#include "bench/process.hpp"
#include "bench/timed_answer.hpp"

namespace torquewright::bench {

std::optional<TimedAnswer> run_bonmin(const gearbox::Problem& problem,
                                      const std::filesystem::path& driver,
                                      const BonminSettings& settings, double timeout_s) {
  // Bonmin's own limit is set beyond ours: whoever needs longer is reported as timed out.
  std::vector<std::string> arguments{driver.string(), "--no-check",
                                     "--resolves",    std::to_string(settings.resolves),
                                     "--time-limit",  std::to_string(timeout_s + 10)};
  if (settings.rings_eliminated) arguments.push_back("--eliminate-rings");
  for (const std::string& argument : problem_arguments(problem)) arguments.push_back(argument);
  const ProcessOutcome outcome = run_process(arguments, timeout_s);
  if (!outcome.started || outcome.exit_code == 127) return std::nullopt;
  // Libraries below Bonmin may print before it.
  const std::size_t brace = outcome.output.rfind("\n{");
  const std::string text =
      brace == std::string::npos ? outcome.output : outcome.output.substr(brace + 1);
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  return TimedAnswer{outcome.seconds, outcome.timed_out,
                     json.is_object() ? read_answer(json) : Answer{"no result", {}}};
}

}  // namespace torquewright::bench
