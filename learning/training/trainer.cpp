// SPDX-License-Identifier: Apache-2.0
#include "learning/training/trainer.hpp"

#include <stdexcept>
#include <vector>

namespace torquewright::learning {

struct Trainer::State {
  Sizes sizes;
  TrainerOptions options;
  std::vector<std::unique_ptr<Environment>> copies;
  Policy policy;
};

Trainer::Trainer(const Sizes& sizes, const MakeEnvironment& make, const TrainerOptions& options)
    : state_(std::make_unique<State>()) {
  state_->sizes = sizes;
  state_->options = options;
  for (int copy = 0; copy < options.copies; ++copy) state_->copies.push_back(make(copy));
}

Trainer::~Trainer() = default;

IterationReport Trainer::iterate() { throw std::domain_error("nothing is learned yet"); }

const Policy& Trainer::policy() const { return state_->policy; }

void Trainer::save(std::ostream&) const {}

void Trainer::restore(std::istream&) { throw std::invalid_argument("nothing is restored yet"); }

}  // namespace torquewright::learning
