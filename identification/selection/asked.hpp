// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "identification/preparation/held_signals.hpp"
#include "identification/selection/search.hpp"

namespace torquewright::identification {

/// Returns the equation without those uncertain values that the log cannot tell: they stay as
/// stated.
ForwardEquation with_what_is_determined(ForwardEquation equation, const HeldSignals& held,
                                        const std::vector<std::size_t>& fold_of_run);

/// Returns the band in which what the stated model leaves stands out of the channels' noise by most
/// of that noise's own scatter; the lowest where nothing does.
double telling_band_Hz(const ForwardEquation& equation, const HeldSignals& held,
                       const std::vector<std::size_t>& fold_of_run);

/// An equation with all that asks it, and what was found. It keeps references to rows and replica.
struct Asked {
  Asked(ForwardEquation asked, const Rows& rows, const std::vector<Signals>& replica,
        const SearchRules& rules)
      : equation(std::move(asked)), fitter(equation, rows, replica), search(fitter, rules) {}

  ForwardEquation equation;
  ModelFitter fitter;
  Search search;
  Found found;
};

/// Searches an equation without the instants of its samples: a search with more values that are
/// free goes other ways. Where one shows beside any model on the way, a large effect having hidden
/// it before, all is asked once more with it free. Without `select` the stated model alone.
std::unique_ptr<Asked> searched(const ForwardEquation& equation, const Rows& rows,
                                const std::vector<Signals>& replica, const SearchRules& rules,
                                bool select);

}  // namespace torquewright::identification
