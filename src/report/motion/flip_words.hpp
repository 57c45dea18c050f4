// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/planning/search/plan.hpp"

namespace torquewright::report {

/// What a plan came to in words, as its text and its page have them; no line's end.

/// The verdict and its sentence.
std::string verdict_words(const hopper::PlanOptions& options, const hopper::PlanResult& result);
/// A sentence that a plan which was not found proves nothing; empty where it needs no saying.
std::string proof_words(const hopper::PlanResult& result);
/// The task, what drives are held to, and what was to be done best.
std::string task_words(const hopper::PlanOptions& options, const hopper::PlanResult& result);
/// CAM, CAV and height of the longest flight; empty without one.
std::string flight_words(const hopper::PlanResult& result);
/// Says how far from its limit it is, at which value, where and when.
std::string margin_words(const hopper::LeastMargin& margin);
/// What bounds a plan, what samples keep of a margin, and what more of it costs.
std::string price_words(const hopper::BoundPrice& part);
/// What more of the reserve costs, all parts together.
std::string reserve_words(double reserve, const hopper::PlanResult& result);
/// Says in how many instants of which stance it binds, and when; by how much where it is violated.
std::string binding_words(const hopper::BindingConstraint& binding);
/// Two digits and the unit of a size that a motion which runs away may have without bound.
std::string size_words(double value, const std::string& unit);
/// Mesh, iterations, what the solver said; errors.
std::string round_words(const hopper::PlanRound& round);
/// What was changed, from what to what, and whether there is a plan.
std::string change_words(const hopper::ChangeTried& change);

}  // namespace torquewright::report
