// SPDX-License-Identifier: Apache-2.0
// Hops of public robots, simulated by MuJoCo and cut into logs: what `hopper check` makes of each,
// beside MuJoCo's own state and forces at its fine step. Prints the tables of
// bench/simulator_logs.md, which docs/simulator_logs.md sums up.
#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "io/faults/spec_error.hpp"
#include "tests/hopper/logs/hop_log.hpp"

namespace torquewright::test {
namespace {

constexpr int kRates_Hz[] = {200, 500, 1000, 2000};

std::vector<LogContent> contents() {
  std::vector<LogContent> all;
  for (const double noise : {0.0, 1.0}) {
    for (const int rate_Hz : kRates_Hz) {
      all.push_back({rate_Hz, false, false, false, false, noise});
      all.push_back({rate_Hz, true, false, false, false, noise});
      all.push_back({rate_Hz, true, false, false, true, noise});
      all.push_back({rate_Hz, true, false, true, false, noise});
      all.push_back({rate_Hz, true, true, false, false, noise});
      all.push_back({rate_Hz, true, true, true, false, noise});
      all.push_back({rate_Hz, true, false, true, false, noise, true});
      all.push_back({rate_Hz, true, true, false, true, noise, true});
      all.push_back({rate_Hz, true, true, true, false, noise, true});
    }
  }
  return all;
}

/// What is wrong, in words; empty: nothing.
std::string misses(const HopErrors& errors) {
  std::string text;
  const auto add = [&text](bool is_wrong, const char* word) {
    if (is_wrong) text += (text.empty() ? "" : ", ") + std::string(word);
  };
  add(!errors.is_known, "torque");
  add(errors.flight_momentum > kMomentumGoal, "CAM");
  add(errors.impulse > kImpulseGoal, "impulse");
  return text;
}

class Table {
 public:
  void add(const PublicHopper& hopper, const SimulatedHop& hop, const LogContent& content) {
    rows_ += fmt::format("| {} | {} | {} | {} | ", hopper.name, content.rate_Hz, words_of(content),
                         content.noise > 0 ? "yes" : "");
    hopper::Motion log = log_of(hopper, hop, content);
    try {
      const auto report = hopper::check_motion(hopper.robot, log, {});
      add_errors(errors_of(hop, log, report), log, content);
    } catch (const io::SpecError& refusal) {
      const std::string text = refusal.what();
      const std::size_t from = text.find("s: ") + 3;
      rows_ += fmt::format("| | | | | | refused: {} ... |\n", text.substr(from, 60));
      count("refused", content);
    }
  }

  void print() const {
    fmt::print("| outcome | clean | noise |\n|---|---|---|\n");
    for (const auto& [outcome, counts] : counts_) {
      fmt::print("| {} | {} | {} |\n", outcome, counts[0], counts[1]);
    }
    fmt::print(
        "\n| robot | Hz | log | noise | window | peak % | rms % | range % | CAM % | impulse % | "
        "outcome |\n|---|---|---|---|---|---|---|---|---|---|---|\n{}",
        rows_);
  }

 private:
  void add_errors(const HopErrors& errors, const hopper::Motion& log, const LogContent& content) {
    const bool is_close = errors.peak <= kTorqueGoal && errors.rms <= kTorqueGoal;
    const std::string wrong = misses(errors);
    const std::string outcome = !wrong.empty() ? "missed" : is_close ? "within" : "doubted";
    count(outcome, content);
    rows_ += fmt::format("{} | {:.2f} | {:.2f} | {:.0f} | {:.3f} | {:.2f} | {}{} |\n",
                         log.reach > 0 ? std::to_string(2 * log.reach + 1) : "-", 100 * errors.peak,
                         100 * errors.rms, 100 * errors.doubt, 100 * errors.flight_momentum,
                         100 * errors.impulse, outcome, wrong.empty() ? "" : ": " + wrong);
  }

  void count(const std::string& outcome, const LogContent& content) {
    ++counts_[outcome][content.noise > 0 ? 1 : 0];
  }

  std::string rows_;
  std::map<std::string, std::array<int, 2>> counts_;
};

}  // namespace
}  // namespace torquewright::test

int main(int argc, char** argv) {
  using namespace torquewright::test;
  const std::vector<std::string> asked(argv + 1, argv + argc);
  Table table;
  for (const std::string& name : asked.empty() ? public_hoppers() : asked) {
    const auto hopper = read_public_hopper(name);
    if (!hopper) continue;
    const SimulatedHop hop = simulate_hop(*hopper);
    for (const LogContent& content : contents()) table.add(*hopper, hop, content);
  }
  table.print();
}
