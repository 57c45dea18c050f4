// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/reading.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::actuator::lint {
namespace {

constexpr CurrentConvention kConventions[] = {CurrentConvention::kDc, CurrentConvention::kPeakPhase,
                                              CurrentConvention::kRmsPhase};
constexpr Modulation kModulations[] = {Modulation::kSvpwm, Modulation::kSine, Modulation::kSixStep};
constexpr EmfMeasure kMeasures[] = {EmfMeasure::kLinePeak, EmfMeasure::kPhasePeak,
                                    EmfMeasure::kLineRms, EmfMeasure::kPhaseRms};

std::string_view ampere_of(CurrentConvention convention) {
  switch (convention) {
    case CurrentConvention::kPeakPhase:
      return "peak ampere";
    case CurrentConvention::kRmsPhase:
      return "rms ampere";
    case CurrentConvention::kDc:
      break;
  }
  return "dc ampere";
}

std::vector<Reading> convention_readings(const Reading& stated) {
  const Motor& motor = stated.document.motor;
  std::vector<Reading> readings;
  for (const CurrentConvention convention : kConventions) {
    for (const Modulation modulation : kModulations) {
      const bool is_dc = convention == CurrentConvention::kDc;
      if (is_dc && modulation != Modulation::kSvpwm) continue;  // modulation plays no part in dc
      if (convention == motor.torque_constant_convention &&
          (is_dc || modulation == stated.document.drive.modulation)) {
        continue;
      }
      Reading reading = stated;
      reading.sentence = fmt::format("torque constant per {}", ampere_of(convention));
      reading.sentence +=
          is_dc ? std::string(" (Kt = Ke)") : fmt::format(", {} modulation", name_of(modulation));
      reading.document.motor.torque_constant_convention = convention;
      reading.document.drive.modulation = modulation;
      readings.push_back(reading);
    }
  }
  return readings;
}

std::vector<Reading> measure_readings(const Reading& stated) {
  std::vector<Reading> readings;
  for (const EmfMeasure measure : kMeasures) {
    if (measure == stated.emf_measure) continue;
    Reading reading = stated;
    reading.sentence = fmt::format("back-EMF constant as {}", name_of(measure));
    reading.emf_measure = measure;
    readings.push_back(reading);
  }
  return readings;
}

}  // namespace

std::string_view name_of(EmfMeasure measure) {
  switch (measure) {
    case EmfMeasure::kPhasePeak:
      return "phase peak";
    case EmfMeasure::kLineRms:
      return "line-to-line rms";
    case EmfMeasure::kPhaseRms:
      return "phase rms";
    case EmfMeasure::kLinePeak:
      break;
  }
  return "line-to-line peak";
}

double volts_per_phase_volt(EmfMeasure measure) {
  switch (measure) {
    case EmfMeasure::kPhasePeak:
      return 1.0;
    case EmfMeasure::kLineRms:
      return std::sqrt(1.5);
    case EmfMeasure::kPhaseRms:
      return std::sqrt(0.5);
    case EmfMeasure::kLinePeak:
      break;
  }
  return std::sqrt(3.0);
}

Reading as_stated(const Actuator& document) {
  Reading reading;
  reading.document = document;
  const bool is_dc = document.motor.torque_constant_convention == CurrentConvention::kDc;
  reading.emf_measure = is_dc ? EmfMeasure::kLinePeak : EmfMeasure::kPhasePeak;
  return reading;
}

std::vector<Reading> speed_readings(const Reading& stated) {
  return stated.document.motor.back_emf_constant_V_s_rad ? measure_readings(stated)
                                                         : convention_readings(stated);
}

std::vector<Reading> emf_readings(const Reading& stated) {
  std::vector<Reading> readings;
  for (const CurrentConvention convention : kConventions) {
    for (const EmfMeasure measure : kMeasures) {
      Reading reading = stated;
      reading.sentence = fmt::format("torque constant per {}, back-EMF as {}",
                                     ampere_of(convention), name_of(measure));
      reading.document.motor.torque_constant_convention = convention;
      reading.emf_measure = reading.speed_constant_measure = measure;
      readings.push_back(reading);
    }
  }
  return readings;
}

std::vector<Reading> ampere_readings(const Reading& stated) {
  const CurrentConvention own = stated.document.motor.torque_constant_convention;
  std::vector<Reading> readings;
  for (const CurrentConvention convention : kConventions) {
    if (convention == own) continue;
    Reading reading = stated;
    reading.sentence = fmt::format("current in {}s, torque constant per {}", ampere_of(convention),
                                   ampere_of(own));
    reading.current_factor = phase_amperes_per_ampere(convention) / phase_amperes_per_ampere(own);
    readings.push_back(reading);
  }
  return readings;
}

std::vector<Reading> ohm_readings(const Reading& stated) {
  Reading reading = stated;
  ResistanceConvention& convention = reading.document.motor.resistance_convention;
  const bool is_phase = convention == ResistanceConvention::kPhase;
  convention = is_phase ? ResistanceConvention::kLineToLine : ResistanceConvention::kPhase;
  reading.sentence = is_phase ? "resistance between two lines" : "resistance of one phase";
  return {reading};
}

std::vector<Reading> side_readings(const Reading& stated) {
  if (!stated.document.datasheet) return {};
  Reading reading = stated;
  bool& joint_side = reading.document.datasheet->joint_side;
  joint_side = !joint_side;
  reading.sentence = joint_side ? "data sheet at the joint" : "data sheet at the motor";
  return {reading};
}

std::vector<Reading> loss_readings(const Reading& stated) {
  Reading reading = stated;
  reading.document.transmission.forward_efficiency = 1.0;
  reading.document.transmission.backward_efficiency = 1.0;
  reading.sentence = "without the gears' losses";
  return {reading};
}

}  // namespace torquewright::actuator::lint
