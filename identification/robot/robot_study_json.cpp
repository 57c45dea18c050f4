// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/robot_study_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

ordered_json value_json(const FittedValue& value, const std::vector<std::string>& joints) {
  ordered_json entry = ordered_json::object();
  if (!value.which.is_of_all()) entry["joint"] = joints[value.which.joint];
  if (!value.which.effect.empty()) entry["effect"] = value.which.effect;
  entry["name"] = value.which.name;
  entry["stated"] = value.stated;
  entry["value"] = value.value;
  entry["standard_error"] = value.standard_error;
  entry["told"] = value.is_told();
  return entry;
}

ordered_json number_json(const JointNumber& number, const std::vector<std::string>& joints) {
  return {{"joint", joints[number.joint]},
          {"value", number.value},
          {"standard_error", number.standard_error}};
}

ordered_json alike_json(const AlikeNumber& number, const std::vector<std::string>& joints) {
  ordered_json entry{{"name", number.name},
                     {"value", number.value},
                     {"standard_error", number.standard_error},
                     {"joints", ordered_json::array()},
                     {"unlike", ordered_json::array()}};
  for (const JointNumber& each : number.joints)
    entry["joints"].push_back(number_json(each, joints));
  for (const UnlikeJoint& each : number.unlike) {
    ordered_json one = number_json(each.own, joints);
    one["sigmas"] = each.sigmas;
    one["sentence"] = sentence_of(number, each, joints);
    entry["unlike"].push_back(std::move(one));
  }
  return entry;
}

ordered_json load_error_json(const LoadError& error, const std::vector<std::string>& joints) {
  ordered_json entry{{"sentence", sentence_of(error)},
                     {"sigmas", error.sigmas},
                     {"readings", ordered_json::array()}};
  for (const LoadReading& each : error.readings) {
    entry["readings"].push_back({{"joint", joints[each.which.joint]},
                                 {"body", each.body},
                                 {"name", each.which.name},
                                 {"change", each.change},
                                 {"standard_error", each.standard_error}});
  }
  return entry;
}

ordered_json trade_off_json(const TradeOff& trade_off, const std::vector<std::string>& joints) {
  ordered_json entry{{"joint", joints[trade_off.joint]},
                     {"scale", trade_off.is_scale},
                     {"sentence", sentence_of(trade_off, joints)},
                     {"separated_by", separated_by(trade_off)},
                     {"values", ordered_json::array()}};
  for (const TradedValue& each : trade_off.values) {
    entry["values"].push_back({{"name", each.which.name},
                               {"value", each.value},
                               {"standard_error", each.standard_error},
                               {"ratio", each.ratio},
                               {"ratio_error", each.ratio_error}});
  }
  return entry;
}

}  // namespace

std::string sentence_of(const AlikeNumber& number, const UnlikeJoint& unlike,
                        const std::vector<std::string>& joints) {
  double least = 0.0, most = 0.0;
  bool is_first = true;
  for (const JointNumber& each : number.joints) {
    if (each.joint == unlike.own.joint) continue;
    least = is_first ? each.value : std::min(least, each.value);
    most = is_first ? each.value : std::max(most, each.value);
    is_first = false;
  }
  return fmt::format(
      "{}: {} is {:.3g} ± {:.1g}, its {} sisters have {:.3g} to {:.3g}: it differs from "
      "them by {:.0f} standard errors.",
      joints[unlike.own.joint], number.name, unlike.own.value, unlike.own.standard_error,
      number.joints.size() - 1, least, most, unlike.sigmas);
}

std::string sentence_of(const BaseMotion& motion) {
  if (!motion.moves()) return "";
  return fmt::format(
      "The base is said to be held and moves: one half of the limbs shows the same sway as the "
      "other (correlation {:.2f}, {:.2g} rad of tilt, or {:.2g} m/s2 of push; it takes {:.0f} % of "
      "what is left at all joints). Hold it, or log it.",
      motion.correlation, motion.tilt_rad, 9.81 * motion.tilt_rad, 100.0 * motion.share);
}

void add_study(const RobotStudy& study, const std::vector<std::string>& joints,
               ordered_json& report) {
  ordered_json& values = report["simulated"]["values"] = ordered_json::array();
  for (const FittedValue& each : study.fit.values) values.push_back(value_json(each, joints));
  ordered_json& traded = report["simulated"]["trade_offs"] = ordered_json::array();
  for (const TradeOff& each : study.trade_offs) traded.push_back(trade_off_json(each, joints));
  report["alike"] = ordered_json::array();
  for (const AlikeNumber& each : study.alike) report["alike"].push_back(alike_json(each, joints));
  ordered_json& load = report["load"];
  load["errors"] = ordered_json::array();
  for (const LoadError& each : study.load.errors) {
    load["errors"].push_back(load_error_json(each, joints));
  }
  load["base"] = {{"correlation", study.base.correlation},
                  {"tilt_rad", study.base.tilt_rad},
                  {"share", study.base.share},
                  {"moves", study.base.moves()}};
  load["told"] = ordered_json::array();
  for (const LoadRank& each : study.load.limbs) {
    load["told"].push_back({{"bodies", each.bodies}, {"numbers", each.of}, {"told", each.told}});
  }
}

}  // namespace torquewright::identification
