// SPDX-License-Identifier: Apache-2.0
#include "learning/training/options_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <vector>

namespace torquewright::learning {
namespace {

std::string objection_to_mirror(const MirroredVector& mirror, int size, const std::string& name) {
  const auto count = static_cast<std::size_t>(size);
  if (mirror.from.size() != count || mirror.sign.size() != count) {
    return "the mirror of the " + name + " is to have " + std::to_string(size) + " entries";
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int from = mirror.from[i];
    if (from < 0 || from >= size || std::abs(mirror.sign[i]) != 1.0) {
      return "entry " + std::to_string(i) + " of the mirror of the " + name +
             " is to be an entry's number and a sign";
    }
    const auto back = static_cast<std::size_t>(from);
    if (mirror.from[back] != static_cast<int>(i) || mirror.sign[back] != mirror.sign[i]) {
      return "mirroring entry " + std::to_string(i) + " of the " + name +
             " twice is to be no change";
    }
  }
  return "";
}

std::string objection_to_layers(const std::vector<int>& layers, const std::string& name) {
  const bool is_good =
      std::all_of(layers.begin(), layers.end(), [](int width) { return width > 0; });
  return is_good ? "" : "a layer of the " + name + " has no output";
}

/// The first of the sentences whose condition does not hold.
struct Demand {
  bool holds;
  const char* sentence;
};

std::string first_broken(const std::vector<Demand>& demands) {
  const auto broken = std::find_if(demands.begin(), demands.end(),
                                   [](const Demand& demand) { return !demand.holds; });
  return broken == demands.end() ? "" : broken->sentence;
}

std::string objection_to_numbers(const Sizes& sizes, const TrainerOptions& options) {
  const auto heads = static_cast<std::size_t>(std::max(0, sizes.heads));
  const auto is_discount = [](double discount) { return discount >= 0.0 && discount <= 1.0; };
  return first_broken({
      {sizes.actor_inputs > 0 && sizes.critic_inputs > 0, "the actor or the critic sees nothing"},
      {sizes.actions > 0, "an action has no numbers"},
      {sizes.heads > 0, "there is no reward"},
      {options.threads > 0, "there is to be at least one thread"},
      {options.copies > 0 && options.steps_per_iteration > 0, "an iteration has no steps"},
      {options.epochs > 0 && options.minibatch > 0, "an iteration learns from no samples"},
      {options.discounts.size() == 1 || options.discounts.size() == heads,
       "there is to be one discount, or one for each head"},
      {std::all_of(options.discounts.begin(), options.discounts.end(), is_discount) &&
           is_discount(options.lambda),
       "discounts and lambda are from 0 to 1"},
      {options.clip > 0.0 && options.entropy >= 0.0 && options.target_kl > 0.0,
       "clip and target divergence are above 0, the price of certainty is not below"},
      {options.least_rate > 0.0 && options.least_rate <= options.greatest_rate &&
           options.first_rate > 0.0 && options.value_rate > 0.0,
       "rates are above 0, the least not above the greatest"},
      {options.greatest_gradient > 0.0, "the greatest gradient is above 0"},
      {options.least_deviation > 0.0 && options.first_deviation >= options.least_deviation,
       "deviations are above 0, the first not below the least"},
      {options.least_input_deviation > 0.0, "the least deviation of inputs is above 0"},
      {options.activation.alpha >= 0.0, "an activation's alpha is not below 0"},
      {options.symmetry >= 0.0, "the weight of symmetry is not below 0"},
  });
}

}  // namespace

std::string objection_to(const Sizes& sizes, const TrainerOptions& options) {
  std::string objection = objection_to_numbers(sizes, options);
  for (const auto& [layers, name] :
       {std::pair{&options.actor_layers, "actor"}, std::pair{&options.critic_layers, "critic"},
        std::pair{&options.estimator_layers, "estimator"}}) {
    if (objection.empty()) objection = objection_to_layers(*layers, name);
  }
  if (!objection.empty()) return objection;
  for (const int entry : options.estimated) {
    if (entry < 0 || entry >= sizes.critic_inputs) {
      return "the critic sees no entry " + std::to_string(entry) + " that could be estimated";
    }
  }
  if (!options.mirror) return "";
  objection = objection_to_mirror(options.mirror->actor, sizes.actor_inputs, "actor's view");
  if (!objection.empty()) return objection;
  return objection_to_mirror(options.mirror->action, sizes.actions, "action");
}

std::string fingerprint_of(const Sizes& sizes, const TrainerOptions& options) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::hexfloat;
  const auto list = [&](const char* name, const auto& entries) {
    text << ' ' << name;
    for (const auto& entry : entries) text << ',' << entry;
  };
  text << "sizes " << sizes.actor_inputs << ' ' << sizes.critic_inputs << ' ' << sizes.actions
       << ' ' << sizes.heads << " seed " << options.seed << " samples " << options.copies << ' '
       << options.steps_per_iteration << ' ' << options.epochs << ' ' << options.minibatch;
  list("discounts", options.discounts);
  text << " ppo " << options.lambda << ' ' << options.clip << ' ' << options.entropy << ' '
       << options.target_kl << " rates " << options.first_rate << ' ' << options.least_rate << ' '
       << options.greatest_rate << ' ' << options.value_rate << ' ' << options.greatest_gradient
       << " deviations " << options.first_deviation << ' ' << options.least_deviation << ' '
       << options.least_input_deviation;
  list("actor", options.actor_layers);
  list("critic", options.critic_layers);
  list("estimated", options.estimated);
  list("estimator", options.estimator_layers);
  text << " separate " << options.separate_critics << " activation "
       << name_of(options.activation.kind) << ' ' << options.activation.alpha;
  if (options.mirror) {
    for (const MirroredVector* mirror : {&options.mirror->actor, &options.mirror->action}) {
      list("mirror", mirror->from);
      list("signs", mirror->sign);
    }
    text << " symmetry " << options.symmetry;
  }
  return text.str();
}

}  // namespace torquewright::learning
