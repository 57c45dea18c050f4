// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/contact_search.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "hopper/demand/demand.hpp"

namespace torquewright::hopper {
namespace {

// From what a rigid contact shows to the radius of a foot; speeds up to any.
constexpr std::array kHeights_m{2e-3, 1e-4, 5e-4, 1e-3, 4e-3, 8e-3, 16e-3, kHighestTouch_m};
constexpr std::array kSpeeds_m_s{
    0.1, 0.02, 0.05, 0.2, 0.5, 1.0, std::numeric_limits<double>::infinity()};
constexpr double kHardlyMore = 0.05;         // of the least that any pair leaves,
constexpr double kHardlyMoreWeights = 1e-3;  // what an accurate motion leaves

std::vector<ContactThresholds> pairs(const ContactRule& rule) {
  std::vector<double> heights_m(kHeights_m.begin(), kHeights_m.end());
  std::vector<double> speeds_m_s(kSpeeds_m_s.begin(), kSpeeds_m_s.end());
  if (rule.height_m) heights_m = {*rule.height_m};
  if (rule.speed_m_s) speeds_m_s = {*rule.speed_m_s};
  std::vector<ContactThresholds> all;
  for (const double height_m : heights_m) {
    for (const double speed_m_s : speeds_m_s) all.push_back({height_m, speed_m_s});
  }
  return all;
}

}  // namespace

ContactSchedule find_contacts(const Robot& robot, const ContactRule& rule, Motion& motion) {
  ContactSchedule schedule = schedule_contacts(robot, rule, motion);
  const bool is_open = schedule.speed_m_s.size() > 0 && !rule.is_stated() &&
                       robot.tree.base != dynamics::BaseKind::kFixed;
  if (!is_open) return schedule;
  const std::vector<ContactThresholds> all = pairs(rule);
  std::vector<Touching> presses;
  std::vector<Eigen::Index> touches;
  for (const ContactThresholds& thresholds : all) {
    const Touching touching = touching_by(thresholds, schedule);
    touches.push_back(touching.count());
    presses.push_back(pressing(touching, motion));
  }
  const std::vector<double> left = unexplained_shares(robot, motion, schedule, presses);
  const double least = *std::min_element(left.begin(), left.end());
  const double enough = std::max((1.0 + kHardlyMore) * least, least + kHardlyMoreWeights);
  std::size_t best = 0;  // the usual pair
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (left[i] > enough) continue;
    const bool is_better = left[best] > enough || (best != 0 && touches[i] < touches[best]);
    if (is_better) best = i;
  }
  schedule.thresholds = all[best];
  schedule.is_searched = true;
  schedule.unexplained_share = left[best];
  schedule.near_ground_m = all[best].height_m;
  schedule.touches = touching_by(all[best], schedule);
  schedule.presses = presses[best];
  return schedule;
}

}  // namespace torquewright::hopper
