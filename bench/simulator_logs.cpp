// SPDX-License-Identifier: Apache-2.0
// Hops of public robots, simulated by MuJoCo and cut into logs: what `hopper check` makes of each,
// beside MuJoCo's own state and forces at its fine step. Prints the table of
// docs/simulator_logs.md.
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "io/spec_error.hpp"
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
    }
  }
  return all;
}

void print_hop(const std::string& name) {
  const auto hopper = read_public_hopper(name);
  if (!hopper) return;
  const SimulatedHop hop = simulate_hop(*hopper);
  if (const char* debug = std::getenv("HOP_DEBUG"); debug != nullptr) {
    for (Eigen::Index i = 1540; name == "hopper" && i < 1660; i += 2) {
      fmt::print(
          "{} {:.3f} base {:.3f} {:.3f} {:.3f} {:.3f} touch {} F {:.0f} tau {:.0f} L {:.3f}\n",
          name, hop.motion.time_s(i), hop.motion.positions(0, i), hop.motion.positions(1, i),
          hop.motion.positions(2, i), hop.motion.positions(3, i), hop.motion.touching.col(i).sum(),
          hop.motion.forces_N.col(i)(Eigen::seq(2, Eigen::last, 3)).sum(),
          hop.motion.touching(0, i) + 10 * hop.motion.touching(1, i),
          hop.angular_momentum_Nm_s.col(i).norm());
    }
    return;
  }
  for (const LogContent& content : contents()) {
    fmt::print("| {} | {} | {} | {} | ", name, content.rate_Hz, words_of(content),
               content.noise > 0 ? "noise" : "");
    hopper::Motion log = log_of(*hopper, hop, content);
    try {
      const auto report = hopper::check_motion(hopper->robot, log, {});
      const HopErrors errors = errors_of(hop, log, report);
      fmt::print(
          "{:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.2f} | {} r{} h{:g} s{:g} u{:.2g} {} jolts {} fl "
          "{}\n",
          100 * errors.peak, 100 * errors.rms, 100 * errors.flight_momentum, 100 * errors.momentum,
          100 * errors.impulse,
          (errors.is_known ? "known " : "MISS ") + fmt::format("{:.2f}", errors.doubt), log.reach,
          report.contact_thresholds.height_m, report.contact_thresholds.speed_m_s,
          report.unexplained_share, actuator::name_of(report.check.verdict),
          report.demand.jolts.size(), report.flights.size());
      if (std::getenv("HOP_WHY") != nullptr)
        for (const auto& f : report.check.findings)
          if (f.severity != actuator::Severity::kNote)
            fmt::print("   {} {}\n", f.rule, f.sentence.substr(0, 200));
    } catch (const io::SpecError& refusal) {
      fmt::print("| | | | | {} |\n", std::string(refusal.what()).substr(0, 250));
    }
  }
}

}  // namespace
}  // namespace torquewright::test

int main() {
  for (const std::string& name : torquewright::test::public_hoppers()) {
    torquewright::test::print_hop(name);
  }
}
