// SPDX-License-Identifier: Apache-2.0
// identification_rates CLASS FIRST_SEED COUNT [FOLDER]: how often the right effect is named in logs
// with a known truth; CLASS may be a situation to which a regression is blind. One line for each
// log, then the counts and the table of confusions. The last log and its documents stay in the
// FOLDER, if one is given.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/identification/rates/trial.hpp"

namespace {

using torquewright::oracles::LogClass;

using torquewright::oracles::Scenario;

/// A class of logs, or a situation to which a regression is blind.
Scenario drawn(const std::string& name, unsigned long long seed) {
  for (const LogClass each : {LogClass::kNone, LogClass::kOne, LogClass::kTwo,
                              LogClass::kCannotTell, LogClass::kOutside, LogClass::kShort}) {
    if (name == torquewright::oracles::name_of(each))
      return torquewright::oracles::draw(each, seed);
  }
  try {
    return torquewright::oracles::draw_blind(name, seed);
  } catch (const std::invalid_argument& fault) {
    fmt::print(stderr,
               "{}; classes: none, one, two, cannot_tell, outside, short; situations: nothing, "
               "backlash_output_encoder, backlash_motor_encoder, breakaway, standstill, "
               "backlash_and_friction\n",
               fault.what());
    std::exit(2);
  }
}

/// What stands in one row of the table of confusions: one truth, many logs.
struct Confusions {
  std::array<int, 4> naming{};  ///< Effects, by Naming; where nothing is there, logs.
  std::map<std::string, int> wrong;
  int logs = 0;
};

void add(const torquewright::rates::Outcome& outcome, std::map<std::string, Confusions>& rows) {
  Confusions& row = rows[outcome.truth];
  ++row.logs;
  for (const auto naming : outcome.naming) ++row.naming[static_cast<std::size_t>(naming)];
  for (const std::string& name : outcome.wrong_names) ++row.wrong[name];
  if (outcome.naming.empty() && outcome.wrong_names.empty()) ++row.naming[3];
}

void print_confusions(const std::map<std::string, Confusions>& rows) {
  fmt::print(
      "\n| what is there | logs | named alone | by an exact identity | in a group of the log | not "
      "named | a wrong name |\n|---|---|---|---|---|---|---|\n");
  for (const auto& [truth, row] : rows) {
    std::string wrong;
    for (const auto& [name, many] : row.wrong) {
      wrong += fmt::format("{}{} {}", wrong.empty() ? "" : ", ", many, name);
    }
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", truth.empty() ? "nothing" : truth,
               row.logs, row.naming[0], row.naming[1], row.naming[2], row.naming[3], wrong);
  }
}

/// Of `all`, with Wilson's interval at 95 %.
void print_share(const char* what, int part, unsigned long long all) {
  constexpr double z = 1.959964;
  const auto n = static_cast<double>(all);
  const double share = part / n, shrink = 1.0 + z * z / n;
  const double centre = (share + z * z / (2.0 * n)) / shrink;
  const double half = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n)) / shrink;
  fmt::print("  {} {} of {}: {:.1f} % ({:.1f} to {:.1f} %)\n", what, part, all, 100.0 * share,
             100.0 * std::max(0.0, centre - half), 100.0 * std::min(1.0, centre + half));
}

/// Held-out errors over a noise, where something was named and nothing wrongly.
void print_spread(const char* noise, std::vector<double> ratios) {
  if (ratios.empty()) return;
  std::sort(ratios.begin(), ratios.end());
  const auto within =
      std::count_if(ratios.begin(), ratios.end(), [](double r) { return r <= 1.15; });
  fmt::print(
      "after over noise {}: median {:.2f}, ninetieth percentile {:.2f}, within 1.15: {} of {}\n",
      noise, ratios[ratios.size() / 2], ratios[ratios.size() * 9 / 10], within, ratios.size());
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4 && count != 5) {
    fmt::print(stderr, "usage: identification_rates CLASS FIRST_SEED COUNT [FOLDER]\n");
    return 2;
  }
  const auto first = std::strtoull(arguments[2], nullptr, 10);
  const auto many = std::strtoull(arguments[3], nullptr, 10);
  const auto scratch =
      std::filesystem::temp_directory_path() / fmt::format("identification_rates_{}", getpid());
  const std::filesystem::path folder = count == 5 ? arguments[4] : scratch;
  int first_right = 0, all = 0, wrong = 0, grouped = 0, coordinate = 0, named = 0, parameters = 0,
      within = 0;
  std::map<std::string, Confusions> confusions;
  std::vector<double> over_estimate, over_truth;
  for (unsigned long long seed = first; seed < first + many; ++seed) {
    const auto scenario = drawn(arguments[1], seed);
    const auto start = std::chrono::steady_clock::now();
    const auto outcome = torquewright::rates::try_out(scenario, folder);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    first_right += outcome.first_is_right;
    all += outcome.all_found && !outcome.any_wrong;
    wrong += outcome.any_wrong;
    grouped += outcome.is_grouped;
    coordinate += outcome.coordinate_is_right;
    named += !outcome.names.empty();
    add(outcome, confusions);
    std::string names;
    for (const std::string& name : outcome.names) names += " " + name;
    names += outcome.parameter_note;
    parameters += outcome.parameters;
    within += outcome.parameters_within;
    if (!outcome.names.empty() && !outcome.any_wrong && outcome.after_over_truth > 0.0) {
      over_estimate.push_back(outcome.after_over_estimate);
      over_truth.push_back(outcome.after_over_truth);
    }
    fmt::print("{:4} {:40} {:18} {}{}{}{} {:5.2f} {:5.2f} {:4.1f} s:{}\n", seed, outcome.truth,
               torquewright::identification::name_of(outcome.verdict),
               outcome.first_is_right ? 'F' : '-', outcome.all_found ? 'A' : '-',
               outcome.any_wrong ? 'W' : '-', outcome.coordinate_is_right ? 'C' : '-',
               outcome.after_over_estimate, outcome.after_over_truth, seconds, names);
    std::fflush(stdout);
  }
  fmt::print(
      "{}: {} logs; named {}, first right {}, all and nothing wrong {}, wrong {}, grouped {}, "
      "coordinate right {}, parameters within 3 errors {} of {}\n",
      arguments[1], many, named, first_right, all, wrong, grouped, coordinate, within, parameters);
  print_share("something named", named, many);
  print_share("first right, alone or in a group", first_right, many);
  print_share("all found, nothing wrong", all, many);
  print_share("a wrong name", wrong, many);
  print_share("a coordinate right", coordinate, many);
  print_spread("as estimated", over_estimate);
  print_spread("put in", over_truth);
  print_confusions(confusions);
  std::filesystem::remove_all(scratch);
  return 0;
}
