// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "gearbox/front/front.hpp"
#include "io/documents/document.hpp"

namespace torquewright::gearbox {

/// A front with what it trades.
struct ShownFront {
  Front front;
  Objective first = Objective::kMass;
  Objective second = Objective::kForwardEfficiency;
};

/// The problem with `first` for its objective. Throws io::SpecError where a key of either objective
/// is missing, and for objectives that a synthesis cannot trade.
Problem read_front_problem(const io::Document& document, Objective first, Objective second);

std::string_view objective_unit(Objective objective);

/// A document of kind gearbox_front, without its provenance.
nlohmann::ordered_json front_json(const ShownFront& shown);

}  // namespace torquewright::gearbox
