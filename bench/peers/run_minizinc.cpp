// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "bench/process.hpp"
#include "bench/scratch_file.hpp"
#include "bench/timed_answer.hpp"

namespace torquewright::bench {
namespace {

constexpr std::int64_t kGecodeLimit = 2147483646;

// The greatest a/b <= limit with b <= parts.
std::pair<std::int64_t, std::int64_t> fraction_below(long double limit, std::int64_t parts) {
  std::pair<std::int64_t, std::int64_t> best{0, 1};
  for (std::int64_t b = 1; b <= parts; ++b) {
    const auto a = static_cast<std::int64_t>(std::floor(limit * static_cast<long double>(b)));
    if (a * best.second > best.first * b) best = {a, b};
  }
  return best;
}

long double carrier_sine(const gearbox::Problem& problem) {
  const long double n = static_cast<long double>(problem.planet_count.at(0));
  const long double alpha_min = problem.min_carrier_clearance_rad.get_d();
  return std::sin(std::numbers::pi_v<long double> / n - alpha_min);
}

void write_fraction(std::ostream& out, const std::string& name, const io::Rational& value) {
  out << name << "_num = " << value.get_num() << ";\n"
      << name << "_den = " << value.get_den() << ";\n";
}

// S d and 2 P1 O, the greatest products in the model, are at most N^2/8 and N^2.
void require_small(const io::Rational& value, std::int64_t bore) {
  const io::Rational largest = std::max<io::Rational>(value.get_num() / 8, value.get_den());
  if (largest * bore * bore > kGecodeLimit) {
    throw std::invalid_argument("the ratio's fraction exceeds Gecode's integers");
  }
}

Answer answer_in(const std::string& output) {
  if (output.find("=====UNSATISFIABLE=====") != std::string::npos) return {"infeasible", {}};
  Answer answer{output.find("==========") == std::string::npos ? "limit" : "optimal", {0, 0, 0}};
  // Solutions come in improving order, each followed by a line of dashes.
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    std::vector<std::int64_t> teeth(3);
    if (numbers >> teeth[0] >> teeth[1] >> teeth[2]) answer.teeth = teeth;
  }
  return answer;
}

}  // namespace

std::string minizinc_data(const gearbox::Problem& problem) {
  const io::Rational exact_bore = problem.rotor_inner_diameter_mm / problem.module_mm.at(0);
  const auto bore =
      static_cast<std::int64_t>(mpz_class(exact_bore.get_num() / exact_bore.get_den()).get_si());
  const io::Rational least = problem.target_ratio * (1 - problem.ratio_tolerance);
  const io::Rational greatest = problem.target_ratio * (1 + problem.ratio_tolerance);
  require_small(least, bore);
  require_small(greatest, bore);
  const auto [a, b] = fraction_below(carrier_sine(problem), bore);
  std::ostringstream out;
  out << "planets = " << problem.planet_count.at(0) << ";\nbore = " << bore << ";\n";
  for (const auto& [gear, teeth] : problem.min_teeth) {
    out << "least_" << gear << " = " << teeth << ";\n";
  }
  write_fraction(out, "least_ratio", least);
  write_fraction(out, "greatest_ratio", greatest);
  write_fraction(out, "bore", exact_bore);
  out << "carrier_num = " << a << ";\ncarrier_den = " << b << ";\n";
  return out.str();
}

std::optional<TimedAnswer> run_minizinc(const gearbox::Problem& problem, double timeout_s) {
  const ScratchFile data(minizinc_data(problem), ".dzn");
  const ProcessOutcome outcome =
      run_process({"minizinc", "--solver", "gecode", GEARBOX_MZN, data.path()}, timeout_s);
  if (!outcome.started || outcome.exit_code == 127) return std::nullopt;
  return TimedAnswer{outcome.seconds, outcome.timed_out, answer_in(outcome.output)};
}

}  // namespace torquewright::bench
