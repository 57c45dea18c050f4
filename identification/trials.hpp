// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/acceptance.hpp"
#include "identification/search.hpp"

namespace torquewright::identification {

/// The questions that every part of a search asks of sets of variants. Keeps references to both.
class Trials {
 public:
  Trials(const Fitter& fitter, const SearchOptions& options)
      : fitter_(fitter), options_(options), empty_(fitter.fit({})) {}

  const Fitter& fitter() const { return fitter_; }
  const SearchOptions& options() const { return options_; }
  const Variant& variant(std::size_t index) const { return fitter_.dictionary().variants[index]; }

  /// Nothing but what stands always.
  const Fit& empty() const { return empty_; }

  bool may_join(const Members& members, std::size_t added) const;

  /// True if `with` earns what it has beyond `without`. What others build on stays: where the fit
  /// without it is not determined, a valid fit is enough.
  bool accepts(const Fit& without, const Fit& with) const;

  /// The fit without the member at a place, its coefficients unlimited.
  Fit without(const Fit& fit, std::size_t place) const;

  /// True if every member earns its place on top of all others.
  bool is_sound(const Fit& fit) const;

 private:
  const Fitter& fitter_;
  const SearchOptions& options_;
  Fit empty_;
};

/// Members less the one at a place; with one more.
Members less_one(Members members, std::size_t place);
Members plus_one(Members members, std::size_t added);

/// True if a fit is valid and its loss lower than the best's, or there is no best yet.
bool beats(const Fit& fit, const Fit& best);

}  // namespace torquewright::identification
