// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_search/simulated_search.hpp"

#include <algorithm>

#include "identification/robot_search/limb_search.hpp"
#include "identification/robot_search/simulated_candidates.hpp"

namespace torquewright::identification {
namespace {

using Of = FreeValue::Of;

constexpr std::size_t kLastRounds = 3;
constexpr double kLastFit_s = 20.0;  ///< Of the training runs, in one round.

/// The study's values without the waves of friction that it found: they are candidates.
std::vector<FreeValue> values_of(const RobotStudy& study, const RobotModel& stated) {
  std::vector<FreeValue> values;
  for (const FittedValue& each : study.fit.values) {
    const bool is_wave = each.which.of == Of::kWave;
    if (is_wave && !has_wave_of_friction(stated.drives[each.which.joint])) continue;
    values.push_back(each.which);
  }
  return values;
}

/// As stated, with plain friction, and with what all limbs have in common as it was fitted.
RobotModel centre_of(const RobotModel& stated, const RobotStudy& study) {
  RobotModel centre = stated;
  add_plain_friction(centre);
  centre.controllers = study.fit.model.controllers;
  return centre;
}

RobotModel without_found_waves(RobotModel model, const RobotModel& stated) {
  for (std::size_t joint = 0; joint < model.drives.size(); ++joint) {
    if (!has_wave_of_friction(stated.drives[joint])) erase_waves_of_friction(model.drives[joint]);
  }
  return model;
}

bool is_of(const Limb& limb, const FreeValue& value) {
  return !value.is_of_all() &&
         std::find(limb.joints.begin(), limb.joints.end(), value.joint) != limb.joints.end();
}

/// All limbs together: where each begins, and what they come to.
class RobotSearch {
 public:
  RobotSearch(const Log& log, const RobotModel& stated, const RobotStudy& study)
      : log_(log),
        stated_(stated),
        study_(study),
        limbs_(limbs_of(stated.load)),
        centre_(centre_of(stated, study)),
        begin_(without_found_waves(study.fit.model, stated)),
        all_(values_of(study, stated)) {
    for (const FreeValue& each : all_) {
      if (each.is_of_all()) values_.push_back(each);
    }
  }

  std::size_t limbs() const { return limbs_.size(); }

  void search(std::size_t place, const NamedByJoint& named,
              const std::function<bool(const std::string&)>& asks, SimulatedSearch& search) {
    const Limb& limb = limbs_[place];
    LimbState own = begin_of(limb);
    if (own.values.empty()) return;
    own = search_limb(log_, std::move(own), place, had_waves(limb), named, asks, search);
    for (const FreeValue& each : own.values) {
      if (!each.is_of_all()) values_.push_back(each);
    }
    for (const std::size_t joint : limb.joints) {
      centre_.drives[joint] = own.stated.drives[joint];
      begin_.drives[joint] = own.model.drives[joint];
    }
    if (limbs_.size() == 1) begin_ = own.model;
  }

  ValueFit fit(const std::function<void(double)>& on_progress) const {
    ValueFitOptions options;
    options.begin = begin_;
    options.most_rounds = kLastRounds;
    options.most_simulated_s = kLastFit_s;
    options.on_progress = on_progress;
    return fit_values(log_, centre_, values_, options);
  }

 private:
  /// What all limbs have in common is free where there is one of them, and stays as fitted else.
  LimbState begin_of(const Limb& limb) const {
    LimbState state{centre_of(stated_, study_), without_found_waves(study_.fit.model, stated_), {}};
    for (const FreeValue& each : all_) {
      const bool is_common = each.is_of_all() && limbs_.size() > 1;
      if (is_common) set_value(state.stated, each, value_in(state.model, each));
      if (is_of(limb, each) || (each.is_of_all() && !is_common)) state.values.push_back(each);
    }
    const bool has_own = std::any_of(state.values.begin(), state.values.end(),
                                     [](const FreeValue& each) { return !each.is_of_all(); });
    if (!has_own) state.values.clear();
    return state;
  }

  bool had_waves(const Limb& limb) const {
    return std::any_of(limb.joints.begin(), limb.joints.end(), [&](std::size_t joint) {
      return study_.varies[joint] && !has_wave_of_friction(stated_.drives[joint]);
    });
  }

  const Log& log_;
  const RobotModel& stated_;
  const RobotStudy& study_;
  std::vector<Limb> limbs_;
  RobotModel centre_, begin_;
  std::vector<FreeValue> all_, values_;
};

}  // namespace

SimulatedSearch search_by_simulation(const Log& log, const RobotModel& stated,
                                     const NamedByJoint& named,
                                     const std::vector<std::vector<std::size_t>>& alike,
                                     const std::function<bool(const std::string&)>& asks,
                                     RobotStudy& study,
                                     const std::function<void(double share)>& on_progress) {
  constexpr double kSearching = 0.8;  // of the work
  SimulatedSearch search;
  search.tried.resize(stated.drives.size());
  if (study.fit.values.empty() || !any_is_asked(asks)) return search;
  const auto show = [&](double share) {
    if (on_progress) on_progress(share);
  };
  RobotSearch robot(log, stated, study);
  for (std::size_t limb = 0; limb < robot.limbs(); ++limb) {
    robot.search(limb, named, asks, search);
    show(kSearching * static_cast<double>(limb + 1) / static_cast<double>(robot.limbs()));
  }
  if (search.found.empty()) return search;
  ValueFit fit = robot.fit([&](double share) { show(kSearching + (1.0 - kSearching) * share); });
  // Waves of friction that the study found may say more: then nothing was shown to be missing.
  if (fit.values.empty() || !(fit.rms_after_rad < study.fit.rms_after_rad)) return {};
  fit.rms_before_rad = study.fit.rms_before_rad;
  study.fit = std::move(fit);
  for (std::size_t joint = 0; joint < study.varies.size(); ++joint)
    study.varies[joint] = has_wave_of_friction(study.fit.model.drives[joint]);
  tell_of(log, stated, alike, study);
  return search;
}

}  // namespace torquewright::identification
