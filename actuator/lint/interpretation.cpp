// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/interpretation.hpp"

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

Interpretation as_stated(const Actuator& document) {
  Interpretation interpretation;
  interpretation.document = document;
  const bool is_dc = document.motor.torque_constant_convention == CurrentConvention::kDc;
  interpretation.emf_measure = is_dc ? EmfMeasure::kLinePeak : EmfMeasure::kPhasePeak;
  return interpretation;
}

std::vector<Interpretation> convention_interpretations(const Interpretation& stated) {
  const Motor& motor = stated.document.motor;
  std::vector<Interpretation> interpretations;
  for (const CurrentConvention convention : kConventions) {
    for (const Modulation modulation : kModulations) {
      const bool is_dc = convention == CurrentConvention::kDc;
      if (is_dc && modulation != Modulation::kSvpwm) continue;  // modulation plays no part in dc
      if (convention == motor.torque_constant_convention &&
          (is_dc || modulation == stated.document.drive.modulation)) {
        continue;
      }
      Interpretation interpretation = stated;
      interpretation.sentence = fmt::format("torque constant per {}", ampere_of(convention));
      interpretation.sentence +=
          is_dc ? std::string(" (Kt = Ke)") : fmt::format(", {} modulation", name_of(modulation));
      interpretation.document.motor.torque_constant_convention = convention;
      interpretation.document.drive.modulation = modulation;
      interpretations.push_back(interpretation);
    }
  }
  return interpretations;
}

std::vector<Interpretation> measure_interpretations(const Interpretation& stated) {
  if (!stated.document.motor.back_emf_constant_V_s_rad) return {};
  std::vector<Interpretation> interpretations;
  for (const EmfMeasure measure : kMeasures) {
    if (measure == stated.emf_measure) continue;
    Interpretation interpretation = stated;
    interpretation.sentence = fmt::format("back-EMF constant as {}", name_of(measure));
    interpretation.emf_measure = measure;
    interpretations.push_back(interpretation);
  }
  return interpretations;
}

std::vector<Interpretation> speed_measure_interpretations(const Interpretation& stated) {
  const std::optional<Datasheet>& sheet = stated.document.datasheet;
  if (!sheet || !sheet->velocity_constant_rpm_V) return {};
  std::vector<Interpretation> interpretations;
  for (const EmfMeasure measure : kMeasures) {
    if (measure == stated.speed_constant_measure) continue;
    Interpretation interpretation = stated;
    interpretation.sentence = fmt::format("velocity constant per volt {}", name_of(measure));
    interpretation.speed_constant_measure = measure;
    interpretations.push_back(interpretation);
  }
  return interpretations;
}

std::vector<Interpretation> speed_interpretations(const Interpretation& stated) {
  return stated.document.motor.back_emf_constant_V_s_rad ? measure_interpretations(stated)
                                                         : convention_interpretations(stated);
}

std::vector<Interpretation> emf_interpretations(const Interpretation& stated) {
  std::vector<Interpretation> interpretations;
  for (const CurrentConvention convention : kConventions) {
    for (const EmfMeasure measure : kMeasures) {
      Interpretation interpretation = stated;
      interpretation.sentence = fmt::format("torque constant per {}, back-EMF as {}",
                                            ampere_of(convention), name_of(measure));
      interpretation.document.motor.torque_constant_convention = convention;
      interpretation.emf_measure = interpretation.speed_constant_measure = measure;
      interpretations.push_back(interpretation);
    }
  }
  return interpretations;
}

std::vector<Interpretation> ampere_interpretations(const Interpretation& stated) {
  const CurrentConvention own = stated.document.motor.torque_constant_convention;
  std::vector<Interpretation> interpretations;
  for (const CurrentConvention convention : kConventions) {
    if (convention == own) continue;
    Interpretation interpretation = stated;
    interpretation.sentence = fmt::format("current in {}s, torque constant per {}",
                                          ampere_of(convention), ampere_of(own));
    interpretation.current_factor =
        phase_amperes_per_ampere(convention) / phase_amperes_per_ampere(own);
    interpretations.push_back(interpretation);
  }
  return interpretations;
}

std::vector<Interpretation> ohm_interpretations(const Interpretation& stated) {
  Interpretation interpretation = stated;
  ResistanceConvention& convention = interpretation.document.motor.resistance_convention;
  const bool is_phase = convention == ResistanceConvention::kPhase;
  convention = is_phase ? ResistanceConvention::kLineToLine : ResistanceConvention::kPhase;
  interpretation.sentence = is_phase ? "resistance between two lines" : "resistance of one phase";
  return {interpretation};
}

std::vector<Interpretation> side_interpretations(const Interpretation& stated) {
  if (!stated.document.datasheet) return {};
  Interpretation interpretation = stated;
  bool& joint_side = interpretation.document.datasheet->joint_side;
  joint_side = !joint_side;
  interpretation.sentence = joint_side ? "data sheet at the joint" : "data sheet at the motor";
  return {interpretation};
}

std::vector<Interpretation> loss_interpretations(const Interpretation& stated) {
  Interpretation interpretation = stated;
  interpretation.document.transmission.forward_efficiency = 1.0;
  interpretation.document.transmission.backward_efficiency = 1.0;
  interpretation.sentence = "without the gears' losses";
  return {interpretation};
}

}  // namespace torquewright::actuator::lint
