// SPDX-License-Identifier: Apache-2.0
#include "identification/naming.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

using Json = nlohmann::ordered_json;
using Values = Eigen::VectorXd;

/// Parameters by name, from a member's coefficients.
using Parameters = std::vector<std::pair<std::string, double>>;
using Map = std::function<Parameters(const Values&)>;

double weighted_log_mean(const Values& weights, std::size_t first,
                         const std::vector<std::vector<double>>& shape) {
  double top = 0.0, bottom = 0.0;
  for (std::size_t j = first; j < shape.size(); ++j) {
    const double weight = std::max(0.0, weights[static_cast<Eigen::Index>(j)]);
    top += weight * std::log(shape[j][0]);
    bottom += weight;
  }
  return bottom > 0.0 ? std::exp(top / bottom) : shape[first][0];
}

Parameters stribeck(const Values& v, const Variant& variant) {
  double beyond = 0.0;
  for (Eigen::Index j = 1; j < v.size(); ++j) beyond += v[j];
  return {{"coulomb_Nm", v[0]},
          {"breakaway_Nm", v[0] + beyond},
          {"stribeck_velocity_rad_s", weighted_log_mean(v, 1, variant.shape)}};
}

/// Where a sensor measures the load, the columns hold the torque that the nominal actuator would
/// deliver; the law's is the torque on the load, tau_nominal / (1 + k_d) or tau_nominal / (1 -
/// k_b).
Parameters load_friction(const Values& v, const Variant& variant, bool is_sensor) {
  const bool is_same = !variant.shape.empty() && variant.shape[0][0] == 1.0;
  const double driving = v[0];
  const double back = v.size() > 1 ? v[1] : is_same ? v[0] : 0.0;
  if (!is_sensor) return {{"driving_coefficient", driving}, {"backdriving_coefficient", back}};
  return {{"driving_coefficient", driving / std::max(1.0 - driving, 0.01)},
          {"backdriving_coefficient", back / (1.0 + back)}};
}

/// Neighbours on the grid act together like one current: the sum of their powers.
Parameters saturation(const Values& v, const Variant& variant) {
  const double p = variant.shape[0][1];
  if (v.size() == 0) return {{"saturation_current_A", variant.shape[0][0]}, {"exponent", p}};
  double sum = 0.0;
  for (std::size_t j = 0; j < variant.shape.size(); ++j) {
    sum += v[static_cast<Eigen::Index>(j)] * std::pow(variant.shape[j][0], -p);
  }
  return {{"saturation_current_A", std::pow(std::max(sum, 1e-300), -1.0 / p)}, {"exponent", p}};
}

/// Neighbours on the grid add up; their slopes at reversal do too.
Parameters presliding(const Values& v, const Variant& variant) {
  double coulomb = 0.0, stiffness = 0.0;
  for (std::size_t j = 0; j < variant.shape.size(); ++j) {
    coulomb += v[static_cast<Eigen::Index>(j)];
    stiffness += v[static_cast<Eigen::Index>(j)] / variant.shape[j][0];
  }
  return {{"coulomb_Nm", coulomb}, {"stiffness_Nm_rad", stiffness}};
}

/// Which parameters the coefficients of a scalar effect stand for.
Map map_of(const Variant& variant, const Balance& balance) {
  const std::string& name = variant.effect;
  const bool is_sensor = balance.is_sensor();
  if (name == "stribeck_friction") return [&](const Values& v) { return stribeck(v, variant); };
  if (name == "load_dependent_friction") {
    return [&variant, is_sensor](const Values& v) { return load_friction(v, variant, is_sensor); };
  }
  if (name == "torque_constant_saturation") {
    return [&](const Values& v) { return saturation(v, variant); };
  }
  if (name == "presliding_friction") {
    return [&variant](const Values& v) { return presliding(v, variant); };
  }
  if (name == "torque_constant_error") {
    return [is_sensor](const Values& v) {
      return Parameters{{"factor", is_sensor ? 1.0 + v[0] : 1.0 / (1.0 - v[0])}};
    };
  }
  if (name == "torque_lag") {
    const double lag_s = variant.shape[0][0];
    return [lag_s](const Values& v) {
      return Parameters{{"time_constant_s", v.size() == 0 ? lag_s : lag_s * v[0]}};
    };
  }
  if (name == "backlash") {
    const double gap_rad = variant.shape[0][0];
    return [gap_rad](const Values& v) {
      return Parameters{{"gap_rad", v.size() == 0 ? gap_rad : gap_rad * v[0]}};
    };
  }
  if (name == "channel_delay") {
    return [](const Values& v) { return Parameters{{"delay_s", std::abs(v[0])}}; };
  }
  if (name == "torque_offset") {
    // Measured = true + value; the motor's side is measured where no sensor is.
    return [is_sensor](const Values& v) { return Parameters{{"value", is_sensor ? v[0] : -v[0]}}; };
  }
  return [&variant](const Values& v) {
    const actuator::EffectKind& kind = *actuator::find_effect(variant.effect);
    Parameters parameters;
    for (Eigen::Index j = 0; j < v.size(); ++j) {
      if (static_cast<std::size_t>(j) >= kind.parameters.size()) break;
      parameters.emplace_back(kind.parameters[static_cast<std::size_t>(j)].name, v[j]);
    }
    return parameters;
  };
}

/// Standard errors of mapped parameters, by differences of the map.
std::vector<double> errors_of(const Map& map, const Values& values,
                              const Eigen::MatrixXd& covariance) {
  const Parameters at = map(values);
  Eigen::MatrixXd slope(static_cast<Eigen::Index>(at.size()), values.size());
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    Values moved = values;
    const double step = 1e-4 * std::max(std::abs(values[j]), 1e-9);
    moved[j] += step;
    const Parameters there = map(moved);
    for (std::size_t p = 0; p < at.size(); ++p) {
      slope(static_cast<Eigen::Index>(p), j) = (there[p].second - at[p].second) / step;
    }
  }
  const Eigen::MatrixXd spread = slope * covariance * slope.transpose();
  std::vector<double> errors;
  for (Eigen::Index p = 0; p < spread.rows(); ++p)
    errors.push_back(std::sqrt(std::max(0.0, spread(p, p))));
  return errors;
}

/// The change that was fitted, on top of what the document states.
Values with_stated(const Values& values, const Variant& variant) {
  Values whole = values;
  for (std::size_t j = 0; j < variant.stated.size(); ++j) {
    whole[static_cast<Eigen::Index>(j)] += variant.stated[j];
  }
  return whole;
}

bool is_driving_only(const Variant& variant) {
  return variant.effect == "load_dependent_friction" && !variant.shape.empty() &&
         variant.shape[0][0] == 0.0;
}

/// What a grid stands for until it is refined.
std::vector<const char*> curved_parameters(const Variant& variant) {
  if (variant.shape.empty()) return {};
  if (variant.effect == "stribeck_friction") return {"stribeck_velocity_rad_s"};
  if (variant.effect == "presliding_friction") return {"stiffness_Nm_rad"};
  if (variant.effect == "torque_constant_saturation") return {"saturation_current_A", "exponent"};
  if (variant.effect == "torque_lag") return {"time_constant_s"};
  if (variant.effect == "backlash") return {"gap_rad"};
  return {};
}

void add_scalar(NamedEffect& named, const Variant& variant, const Values& values,
                const Eigen::MatrixXd& covariance, const Balance& balance) {
  const Map map = map_of(variant, balance);
  const Values whole = with_stated(values, variant);
  const Parameters parameters = map(whole);
  const std::vector<double> errors = errors_of(map, whole, covariance);
  named.parameters = Json::object();
  named.standard_error = Json::object();
  if (variant.effect == "channel_delay") {
    const bool measured_is_late = values[0] > 0.0;
    const Bench& bench = balance.bench();
    const Quantity other = balance.is_sensor() ? bench.drive_channel
                           : bench.is_linear   ? Quantity::kLinearPosition
                                               : Quantity::kOutputPosition;
    named.parameters["channel"] =
        std::string(name_of(measured_is_late ? balance.quantity() : other));
  }
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    named.parameters[parameters[p].first] = parameters[p].second;
    named.standard_error[parameters[p].first] = errors[p];
    if (errors[p] == 0.0) named.standard_error[parameters[p].first] = nullptr;
  }
  // Known on a grid only, whatever was fitted: no error is claimed.
  for (const char* curved : curved_parameters(variant)) named.standard_error[curved] = nullptr;
  // Of a log that is never back-driven: as stated, none, and no error is claimed.
  if (is_driving_only(variant)) named.standard_error["backdriving_coefficient"] = nullptr;
}

/// A sin + B cos as amplitude and phase.
void add_harmonic(NamedEffect& named, const Variant& variant, const Values& values,
                  const Eigen::MatrixXd& covariance) {
  const bool is_ratio = variant.proportional;
  const Map map = [is_ratio](const Values& v) {
    return Parameters{{is_ratio ? "amplitude_ratio" : "amplitude_Nm", std::hypot(v[0], v[1])},
                      {"phase_rad", std::atan2(v[1], v[0])}};
  };
  const Parameters parameters = map(values);
  const std::vector<double> errors = errors_of(map, values, covariance);
  Json harmonic = Json::object(), error = Json::object();
  if (variant.effect != "gravity_imbalance") harmonic["order"] = variant.order;
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    harmonic[parameters[p].first] = parameters[p].second;
    error[parameters[p].first] = errors[p];
  }
  if (variant.effect == "gravity_imbalance") {
    named.parameters = harmonic;
    named.standard_error = error;
    return;
  }
  named.parameters["harmonics"].push_back(harmonic);
  named.standard_error["harmonics"].push_back(error);
  if (variant.effect == "gear_ripple") named.parameters["proportional"] = is_ratio;
}

bool is_same_effect(const Variant& a, const Variant& b) {
  return a.effect == b.effect && a.order > 0.0 && a.proportional == b.proportional;
}

}  // namespace

std::size_t count_always(const Fit& fit, const std::vector<Variant>& variants) {
  std::size_t own = 0;
  for (const std::size_t member : fit.members) own += variants[member].coefficients.size();
  return fit.coefficients.size() - own;
}

std::vector<Named> named_effects(const Fit& fit, const Dictionary& dictionary,
                                 std::size_t always_count, const Balance& balance) {
  std::vector<Named> all;
  for (std::size_t m = 0; m < fit.members.size(); ++m) {
    const Variant& variant = dictionary.variants[fit.members[m]];
    const auto first = static_cast<Eigen::Index>(fit.first_of_member(dictionary, m, always_count));
    const auto count = static_cast<Eigen::Index>(variant.coefficients.size());
    const Values values = fit.values.segment(first, count);
    const Eigen::MatrixXd covariance = fit.covariance.block(first, first, count, count);
    auto known = std::find_if(all.begin(), all.end(), [&](const Named& each) {
      return is_same_effect(dictionary.variants[fit.members[each.members.front()]], variant);
    });
    if (known == all.end()) known = all.emplace(all.end());
    Named& named = *known;
    named.members.push_back(m);
    named.effect.effect = variant.effect;
    named.effect.family = variant.family;
    if (variant.order > 0.0) {
      add_harmonic(named.effect, variant, values, covariance);
    } else {
      add_scalar(named.effect, variant, values, covariance, balance);
    }
    for (const actuator::Effect& stated : balance.bench().actuator().effects) {
      const std::string part(stated.kind->name);
      const bool is_part = std::find(variant.replaces.begin(), variant.replaces.end(), part) !=
                           variant.replaces.end();
      if (!is_part && (part != variant.effect || variant.stated.empty())) continue;
      named.effect.replaces += (named.effect.replaces.empty() ? "" : ", ") + part;
    }
  }
  return all;
}

}  // namespace torquewright::identification
