// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identification/equation.hpp"
#include "identification/shape.hpp"
#include "identification/signal_source.hpp"

namespace torquewright::identification {

/// A shape parameter as found.
struct ShapeEstimate {
  std::size_t member = 0;  ///< Place in the model.
  std::string name;
  double value = 0.0;
  double standard_error = 0.0;
  double spread = 0.0;  ///< Over the starts that agree: wide means a valley.
};

/// The model with its curved parameters found between the grid's values: NLopt over the shapes,
/// everything linear solved for at each. docs/derivations/identification.md section 7.
struct RefinedModel {
  Dictionary dictionary;
  Target target;  ///< Less what is all shape.
  std::shared_ptr<Gram> gram;
  Fit fit;  ///< Members in the model's order; those that are all shape have no coefficient.
  std::vector<ShapeEstimate> shapes;
  std::size_t starts = 0;
  std::size_t agreeing = 0;
};

/// Empty where the model has no curved parameter, or the search does not improve on the grid.
std::optional<RefinedModel> refined(const Bench& bench, const Equation& equation, const Fit& model,
                                    const SignalSource& source,
                                    const std::vector<std::size_t>& fold_of_run,
                                    const std::vector<std::size_t>& fold_of_block,
                                    const BandOptions& band);

/// Its members as effects with the contract's parameters.
std::vector<Named> refined_names(const RefinedModel& model, std::size_t always_count,
                                 const Balance& balance);

}  // namespace torquewright::identification
