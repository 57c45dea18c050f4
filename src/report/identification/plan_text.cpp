// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/plan_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/text/wording.hpp"

namespace torquewright::report {
namespace {

using identification::Plan;
using identification::PlannedParameter;

std::string sigma_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", value) : std::string("none");
}

std::string parameter_text(const PlannedParameter& each) {
  std::string text = fmt::format(
      "{} {}{}: standard error {} ({} by the chirp), separability {:.3g} ({:.3g})\n",
      each.column.effect, each.column.parameter, each.column.at.empty() ? "" : " " + each.column.at,
      sigma_text(each.plan.standard_error), sigma_text(each.chirp.standard_error), each.plan.share,
      each.chirp.share);
  if (!each.is_separable) {
    const bool is_its_own = each.plan.nearest == each.column.effect;
    text += fmt::format("  This plan does not separate it from {}. What would: {}.\n",
                        is_its_own ? "its own " + each.plan.nearest_parameter : each.plan.nearest,
                        each.remedy);
  }
  return text;
}

}  // namespace

std::string plan_text(const Plan& plan, const identification::PlanOptions& options) {
  std::string text = fmt::format(
      "The excitation lasts {:g} s in {} run(s); in brackets stands a plain chirp as "
      "long.\nSeparability is 1 where nothing else acts like the parameter, 0 where "
      "something does.\n",
      options.duration_s, plan.runs.size());
  for (const PlannedParameter& each : plan.parameters) text += parameter_text(each);
  text +=
      "The plan is made for the parameter that is worst off; the chirp may give others smaller "
      "errors.\n";
  text += fmt::format("The smallest eigenvalue of the scaled information is {:.3g} ({:.3g}).\n",
                      plan.smallest_eigenvalue, plan.chirp_smallest_eigenvalue);
  for (const Plan::Unseen& each : plan.unseen) {
    text += fmt::format("{}: {}. What would separate it: {}.\n", io::listed(each.effects), each.why,
                        each.remedy);
  }
  text += "White noise is assumed, by its standard deviation:";
  for (const auto& [quantity, sigma] : plan.noise) {
    text += fmt::format(" {} {:.3g}", identification::name_of(quantity), sigma);
  }
  text += fmt::format(
      ".\nThis is the best of {} that were tried, from seed {}; every sample of the nominal "
      "actuator is inside its region.\n",
      plan.tried, options.seed);
  text += plan.is_separable() ? "The effects are separable.\n"
                              : "Not all of the effects are separable on this rig.\n";
  return text;
}

}  // namespace torquewright::report
