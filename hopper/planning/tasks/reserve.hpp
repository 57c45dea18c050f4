// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hopper/planning/tasks/plan_options.hpp"

namespace torquewright::hopper {

/// A planning margin, and what a reserve makes of it.
struct MarginPart {
  std::string_view name;      ///< "joint range".
  std::string_view option;    ///< That states it by itself: "--position-margin".
  std::string_view unit;      ///< "rad", or empty of a share.
  std::string_view sentence;  ///< For help: what is kept of what.
  double PlanMargins::*margin;
  double per_reserve = 0.0;  ///< It is at least so many times the reserve; 0: left as it is.
  double most = 1.0;         ///< Of more nothing is left to plan with.
};

/// Every planning margin, in the order in which answers list them.
const std::vector<MarginPart>& margin_parts();

/// Whether a part bounds anything of such a motion: edges are where landings differ in height.
bool is_kept(const MarginPart& part, const PlanOptions& options);

/// The usual margins, each at least what the reserve asks of it. `reserve` is a share of what there
/// is: of voltage itself, of other parts by MarginPart::per_reserve. Throws io::SpecError, which
/// names the part and how much there is, where it is too great.
PlanMargins with_reserve(double reserve);

/// The greatest reserve that with_reserve() takes.
double greatest_reserve();

}  // namespace torquewright::hopper
