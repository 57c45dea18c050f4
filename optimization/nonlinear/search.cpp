// SPDX-License-Identifier: Apache-2.0
#include "optimization/nonlinear/search.hpp"

#include <tuple>

namespace torquewright::optimization {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Adds what it lives to a total.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total) {}
  ~Stopwatch() { total_ += seconds_since(begin_); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& total_;
  Clock::time_point begin_ = Clock::now();
};

std::tuple<bool, double> price(double objective, double violation, double tolerance) {
  const bool is_violating = violation > tolerance;
  return {is_violating, is_violating ? violation : objective};
}

}  // namespace

bool is_better(const Evaluation& trial, const Candidate& best, double tolerance) {
  if (!trial.is_finite) return false;
  return best.values.empty() || price(trial.objective, trial.largest_violation, tolerance) <
                                    price(best.objective, best.largest_violation, tolerance);
}

Search::Search(const Program& program, const NonlinearOptions& options)
    : program_(program), options_(options), begin_(Clock::now()), assembly_(program) {}

const Evaluation& Search::at(std::span<const double> scaled) {
  const Stopwatch stopwatch(derivative_seconds_);
  const Evaluation& here = assembly_.at(scaled);
  if (is_better(here, best_, options_.tolerance)) {
    best_.values = here.values;
    best_.objective = here.objective;
    best_.largest_violation = here.largest_violation;
  }
  if (here.is_finite) last_finite_ = {0, here.objective, here.largest_violation};
  return here;
}

bool Search::gradient(std::span<const double> scaled, std::span<double> slopes) {
  const Stopwatch stopwatch(derivative_seconds_);
  return assembly_.gradient(scaled, slopes);
}

bool Search::jacobian(std::span<const double> scaled, std::span<double> entries) {
  const Stopwatch stopwatch(derivative_seconds_);
  return assembly_.jacobian(scaled, entries);
}

bool Search::hessian(std::span<const double> scaled, double objective_factor,
                     std::span<const double> multipliers, std::span<double> entries) {
  const Stopwatch stopwatch(derivative_seconds_);
  return assembly_.hessian(scaled, objective_factor, multipliers, entries);
}

std::optional<NonlinearStatus> Search::interruption() const {
  if (seconds() >= options_.most_seconds) return NonlinearStatus::kTimeLimit;
  if (options_.should_stop && options_.should_stop()) return NonlinearStatus::kInterrupted;
  return std::nullopt;
}

double Search::seconds() const { return seconds_since(begin_); }

}  // namespace torquewright::optimization
