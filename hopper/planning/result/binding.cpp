// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/result/binding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hopper/planning/constraints/library.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Nearer than this share of its size a limit holds: the solver's barrier keeps some distance.
constexpr double kNear = 2e-3;
constexpr double kViolated = 1e-5;  // of scaled rows: ten times the solver's tolerance (ours)

/// Gathers by phase and name.
class Bindings {
 public:
  void look(const PlanLimit& limit, double time_s, std::string_view unit) {
    if (!std::isfinite(limit.room)) return;
    BindingConstraint& one = entry(limit.name, unit);
    ++one.of;
    if (limit.room > kNear * limit.size) return;
    one.from_s = one.instants == 0 ? time_s : std::min(one.from_s, time_s);
    one.until_s = one.instants == 0 ? time_s : std::max(one.until_s, time_s);
    ++one.instants;
    if (limit.room < -kViolated * limit.size) one.violation = std::max(one.violation, -limit.room);
  }
  void begin_phase(const std::string& stance) {
    stance_ = stance;
    first_ = found_.size();
  }
  std::vector<BindingConstraint> sorted() {
    std::erase_if(found_, [](const BindingConstraint& one) { return one.instants == 0; });
    std::stable_sort(found_.begin(), found_.end(),
                     [](const BindingConstraint& a, const BindingConstraint& b) {
                       return a.instants > b.instants;
                     });
    return std::move(found_);
  }

 private:
  BindingConstraint& entry(const std::string& name, std::string_view unit) {
    for (std::size_t i = first_; i < found_.size(); ++i) {
      if (found_[i].name == name) return found_[i];
    }
    BindingConstraint fresh;
    fresh.name = name;
    fresh.stance = stance_;
    fresh.unit = unit;
    return found_.emplace_back(std::move(fresh));
  }

  std::vector<BindingConstraint> found_;
  std::string stance_;
  std::size_t first_ = 0;  ///< Of those of the phase.
};

/// Of joints, instants and phases, phase by phase.
Bindings limits_of(Site site, const PlannedMotion& plan, const std::vector<double>& values) {
  Bindings bindings;
  const auto ask = [&](Where where, double time_s) {
    for (const Constraint* one : every_constraint()) {
      if (one->where != where || one->limits == nullptr) continue;
      for (const PlanLimit& limit : one->limits(site, values)) {
        bindings.look(limit, time_s, one->unit);
      }
    }
  };
  for (site.phase = 0; site.phase < site.phases.size(); ++site.phase) {
    const PlannedPhase& phase = plan.phases[site.phase];
    bindings.begin_phase(site.stance().name);
    site.index = 0;
    for (; site.index < site.variables().points.size(); ++site.index) {
      const double time_s = phase.instants[site.index].time_s;
      for (site.row = 0; site.row < site.joints(); ++site.row) ask(Where::kJoint, time_s);
      site.row = 0;
      ask(Where::kInstant, time_s);
      ask(Where::kPhase, time_s);  // what a phase as a whole is held by holds throughout
    }
  }
  return bindings;
}

/// A row's name is its stance's, then what it states: "heel: impact".
BindingConstraint constraint_of(const std::string& name) {
  BindingConstraint out;
  const std::size_t colon = name.find(": ");
  out.stance = colon == std::string::npos ? "" : name.substr(0, colon);
  out.name = colon == std::string::npos ? name : name.substr(colon + 2);
  out.has_times = false;
  return out;
}

/// The worst violation of scaled rows, by their name.
std::vector<BindingConstraint> violated(const FlipProgram& program,
                                        const std::vector<double>& values) {
  std::vector<BindingConstraint> out;
  for (const auto& rows : program.program.rows()) {
    VectorXd at(rows->size());
    rows->values(optimization::gathered(*rows, values), at);
    double worst = 0.0;
    for (Index i = 0; i < at.size(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const double beyond =
          std::max(rows->bounds()[row].lower - at[i], at[i] - rows->bounds()[row].upper);
      worst = std::max(worst, beyond / rows->scales()[row]);
    }
    const BindingConstraint named = constraint_of(rows->name());
    const auto same = std::find_if(out.begin(), out.end(), [&](const BindingConstraint& one) {
      return one.name == named.name && one.stance == named.stance;
    });
    BindingConstraint& one = same != out.end() ? *same : out.emplace_back(named);
    ++one.of;
    if (worst > kViolated) ++one.instants;
    one.violation = std::max(one.violation, worst);
  }
  std::erase_if(out, [](const BindingConstraint& one) { return one.instants == 0; });
  std::stable_sort(out.begin(), out.end(),
                   [](const BindingConstraint& a, const BindingConstraint& b) {
                     return a.violation > b.violation;
                   });
  return out;
}

}  // namespace

std::vector<BindingConstraint> binding_constraints(const FlipProgram& program,
                                                   const PlanModel& model, const PlanGoal& goal,
                                                   const PlanOptions& options,
                                                   const PlannedMotion& plan,
                                                   const std::vector<double>& values) {
  const Site site{model, goal, options, program.mesh, program.phases, nullptr};
  std::vector<BindingConstraint> out = limits_of(site, plan, values).sorted();
  for (BindingConstraint& one : violated(program, values)) out.push_back(std::move(one));
  return out;
}

}  // namespace torquewright::hopper
