// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/sizes.hpp"

#include <cmath>
#include <utility>

#include "tests/oracles/sampled_bench/outside.hpp"

namespace torquewright::oracles::sampled {
namespace {

using Course = std::vector<double>;

/// Difference of two channels of two logs, each course per run.
Course difference(const std::vector<Row>& of, const std::vector<Row>& from, std::size_t channel) {
  Course course(of.size());
  for (std::size_t k = 0; k < of.size(); ++k) course[k] = of[k][channel] - from[k][channel];
  return course;
}

/// How deviations of channels change the torque balance: to first order, derivatives taken in band.
Course torque_deviation(const Situation& situation, const std::vector<Row>& of,
                        const std::vector<Row>& from, double period_s) {
  const Plant& plant = situation.plant;
  const auto& sensors = situation.chain.sensors;
  Course sum(of.size(), 0.0);
  const auto add = [&](const Course& course, double factor) {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * course[k];
  };
  const auto banded = [&](std::size_t channel) {
    return in_band(difference(of, from, channel), period_s);
  };
  if (sensors[kTorque].is_logged) add(banded(kTorque), 1.0);
  if (sensors[kCurrent].is_logged) add(banded(kCurrent), -plant.Nm_per_A());
  if (plant.is_voltage_driven()) {
    const double Nm_per_V = plant.Nm_per_A() / plant.resistance_ohm;
    if (sensors[kWindingVoltage].is_logged) add(banded(kWindingVoltage), -Nm_per_V);
    if (sensors[kDuty].is_logged) add(banded(kDuty), -Nm_per_V * plant.bus_V);
    if (sensors[kBusVoltage].is_logged) add(banded(kBusVoltage), -0.3 * Nm_per_V);
  }
  const bool has_motor = sensors[kMotorPosition].is_logged;
  const double per_output = has_motor ? 1.0 / plant.ratio : 1.0;
  const double inertia = plant.moved_kg_m2() * per_output;
  const Course speed = rate_of(banded(has_motor ? kMotorPosition : kOutputPosition), period_s);
  add(rate_of(speed, period_s), inertia);
  if (plant.is_voltage_driven()) {
    add(speed, plant.Nm_per_A() * plant.Nm_per_A() / plant.resistance_ohm * per_output);
  }
  return sum;
}

std::size_t logged_velocity(const Situation& situation) {
  return situation.chain.sensors[kOutputVelocity].is_logged ? kOutputVelocity : kMotorVelocity;
}

/// Deviations of channels as they enter an equation.
Course deviation(const Situation& situation, const std::vector<Row>& of,
                 const std::vector<Row>& from, Equation equation, double period_s) {
  if (equation == Equation::kTorque) return torque_deviation(situation, of, from, period_s);
  if (equation == Equation::kBus) return difference(of, from, kBusVoltage);
  if (equation == Equation::kVelocity) {
    const std::size_t channel = logged_velocity(situation);
    Course course = difference(of, from, channel);
    const std::size_t beside = channel == kOutputVelocity ? kOutputPosition : kMotorPosition;
    const Course rate = rate_of(in_band(difference(of, from, beside), period_s), period_s);
    for (std::size_t k = 0; k < course.size(); ++k) course[k] -= rate[k];
    return course;
  }
  Course course = difference(of, from, kMotorPosition);
  const Course output = difference(of, from, kOutputPosition);
  for (std::size_t k = 0; k < course.size(); ++k) {
    course[k] = course[k] / situation.plant.ratio - output[k];
  }
  return course;
}

/// Prediction with and without at one instant, in the effect's equation.
double change_at(const Situation& situation, const Laws& with, const Laws& without,
                 Equation equation, const Instant& at) {
  if (equation == Equation::kTwist) return at.motor_angle_rad - at.angle_rad;
  if (equation == Equation::kBus) return with.sag_ohm * at.winding_V / at.bus_V * at.current_A;
  const Plant& plant = situation.plant;
  return predicted_torque_Nm(plant, with, at) - predicted_torque_Nm(plant, without, at) -
         load_torque_Nm(plant, with, at) + load_torque_Nm(plant, without, at);
}

double law_change_rms(const Situation& situation, const Record& record, const Laws& without,
                      Equation equation) {
  Courses courses;
  for (const RunLog& run : record.runs) {
    Course course;
    course.reserve(run.truth.size());
    for (const Instant& at : run.truth) {
      course.push_back(change_at(situation, record.laws, without, equation, at));
    }
    courses.push_back(std::move(course));
  }
  return band_rms(courses, record.period_s);
}

double fault_rms(const Situation& situation, const Record& record, const Record& faultless,
                 Equation equation) {
  Courses courses;
  for (std::size_t k = 0; k < record.runs.size(); ++k) {
    courses.push_back(deviation(situation, record.runs[k].measured, faultless.runs[k].measured,
                                equation, record.period_s));
  }
  return band_rms(courses, record.period_s);
}

/// At rest friction is what it must be, and no law says how much.
bool is_at_rest(const Plant& plant, const Instant& at) {
  return std::abs(at.motor_speed_rad_s) < 2e-3 * plant.used_speed_rad_s;
}

double imbalance_Nm(const Situation& situation, const Laws& laws, const Instant& at) {
  const double measured = situation.plant.load.is_dynamometer()
                              ? at.torque_Nm
                              : load_torque_Nm(situation.plant, laws, at);
  return predicted_torque_Nm(situation.plant, laws, at) - measured;
}

/// Each run has a mass of its own.
double payload_rms(const Situation& situation, const Record& record) {
  Courses courses;
  for (std::size_t k = 0; k < record.runs.size(); ++k) {
    Laws other = record.laws;
    other.load_mass_factor *= situation.runs[k].mass_factor;
    Course course;
    for (const Instant& at : record.runs[k].truth) {
      course.push_back(change_at(situation, other, record.laws, Equation::kTorque, at));
    }
    courses.push_back(std::move(course));
  }
  return band_rms(courses, record.period_s);
}

}  // namespace

Equation equation_of(const std::string& effect) {
  if (effect == "velocity_mismatch") return Equation::kVelocity;
  if (effect == "backlash" || effect == "torsional_compliance") return Equation::kTwist;
  return effect == "voltage_sag" ? Equation::kBus : Equation::kTorque;
}

double noise_rms(const Situation& situation, const Record& faultless, Equation equation) {
  Courses courses;
  for (const RunLog& run : faultless.runs) {
    courses.push_back(deviation(situation, run.measured, run.ideal, equation, faultless.period_s));
  }
  return band_rms(courses, faultless.period_s);
}

double change_rms(const Situation& situation, const Record& record, const Record& faultless,
                  const std::string& effect) {
  const Equation equation = equation_of(effect);
  if (is_log_fault(effect)) return fault_rms(situation, record, faultless, equation);
  Laws without = record.laws;
  neutralise(effect, without);
  return law_change_rms(situation, record, without, equation);
}

double oddity_rms(const Situation& situation, const Record& record, const Record& faultless) {
  const Equation equation = equation_of_outside(situation.odd_kind);
  if (situation.odd_kind == "payload_changes") return payload_rms(situation, record);
  const double fault = fault_rms(situation, record, faultless, equation);
  Laws without = record.laws;
  without.odd = {};
  return std::hypot(fault, law_change_rms(situation, record, without, equation));
}

std::vector<double> size_floors(const Situation& situation, const Record& record,
                                const Record& faultless) {
  std::vector<double> floors;
  for (const Effect& effect : situation.hidden) {
    floors.push_back(change_rms(situation, record, faultless, effect.name) /
                     noise_rms(situation, faultless, equation_of(effect.name)));
  }
  if (!situation.odd_kind.empty()) {
    floors.push_back(oddity_rms(situation, record, faultless) /
                     noise_rms(situation, faultless, equation_of_outside(situation.odd_kind)));
  }
  return floors;
}

double numerical_floors(const Situation& situation, const Record& faultless) {
  Courses courses;
  for (std::size_t k = 0; k < faultless.runs.size(); ++k) {
    Laws laws = faultless.laws;
    laws.load_mass_factor *= situation.runs[k].mass_factor;
    Course course;
    for (const Instant& at : faultless.runs[k].truth) {
      course.push_back(is_at_rest(situation.plant, at) ? 0.0 : imbalance_Nm(situation, laws, at));
    }
    courses.push_back(std::move(course));
  }
  return band_rms(courses, faultless.period_s) / noise_rms(situation, faultless, Equation::kTorque);
}

double lag_against_delay_floors(const Situation& situation, const Record& faultless,
                                double time_s) {
  Courses courses;
  const double period_s = faultless.period_s;
  const double follow = -std::expm1(-period_s / time_s);
  const auto late = static_cast<std::size_t>(time_s / period_s);
  const double share = time_s / period_s - static_cast<double>(late);
  for (const RunLog& run : faultless.runs) {
    Course course(run.ideal.size(), 0.0);
    double lagged = run.ideal.front()[kCurrent];
    for (std::size_t k = 1; k < run.ideal.size(); ++k) {
      const double now = 0.5 * (run.ideal[k][kCurrent] + run.ideal[k - 1][kCurrent]);
      lagged += follow * (now - lagged);
      if (k < late + 1) continue;
      const double delayed =
          (1.0 - share) * run.ideal[k - late][kCurrent] + share * run.ideal[k - late - 1][kCurrent];
      course[k] = situation.plant.Nm_per_A() * (lagged - delayed);
    }
    courses.push_back(std::move(course));
  }
  return band_rms(courses, period_s) / noise_rms(situation, faultless, Equation::kTorque);
}

}  // namespace torquewright::oracles::sampled
