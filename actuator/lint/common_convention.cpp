// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/common_convention.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

/// Of the factors, without their rounding.
constexpr double kSamePrintedFactor = 1e-3;

std::optional<RoundedInterval> stated_speed(const Actuator& document) {
  return sheet_number(document, &Datasheet::no_load_speed_rad_s, "no_load_speed_rad_s");
}

RoundedInterval sheet_voltage(const Actuator& document) {
  return sheet_condition(document, &Datasheet::voltage_V, "voltage_V")
      .value_or(exact(document.drive.bus_voltage_V, "/drive/bus_voltage_V"));
}

/// V / (Kt N).
RoundedInterval plain_speed(const Actuator& document) {
  return derive([](double volts, double constant_Nm_A,
                   double turns) { return volts / (constant_Nm_A * turns); },
                sheet_voltage(document), torque_constant(document),
                sheet_ratio(document, "no_load_speed_rad_s"));
}

/// c = w Kt N / V: each number once, so that the corners are the extremes.
RoundedInterval required_factor(const Actuator& document) {
  return derive([](double speed_rad_s, double constant_Nm_A, double turns,
                   double volts) { return speed_rad_s * constant_Nm_A * turns / volts; },
                *stated_speed(document), torque_constant(document),
                sheet_ratio(document, "no_load_speed_rad_s"), sheet_voltage(document));
}

/// Share of the voltage that the stated no-load current takes, at the most.
double share_of_no_load_current(const Actuator& document) {
  const auto current_A = sheet_number(document, &Datasheet::no_load_current_A, "no_load_current_A");
  if (!current_A) return 0.0;
  const Interpretation reading = as_stated(document);
  const double drop_V =
      phase_resistance(document).high *
      phase_current(reading,
                    torque_constant_amperes(reading, *current_A, "/datasheet/no_load_current_A"))
          .high;
  return std::min(drop_V / phase_voltage(document).value, 1.0);
}

/// A sheet may state `tolerance` of what follows, (1 - share) c V / (Kt N).
FactorRange tolerated_factors(const Actuator& document, const RoundedInterval& required) {
  const Tolerance tolerance = catalogue({document, *stated_speed(document), plain_speed(document)});
  const double left = tolerance.least * (1.0 - share_of_no_load_current(document));
  return {required.low / tolerance.greatest, left > 0.0 ? required.high / left : kUnlimited};
}

bool assumes_convention(const Actuator& document) {
  return std::any_of(document.assumed.begin(), document.assumed.end(), [](const auto& pointer) {
    return pointer == "/motor" || pointer == "/motor/torque_constant_convention";
  });
}

/// c of a convention: phase volts per bus volt over phase back-EMF per torque constant.
double factor_of(CurrentConvention convention, Modulation modulation) {
  return phase_volts_per_bus_volt(convention, modulation) /
         (back_emf_per_torque_constant(convention) * phase_volts_per_winding_volt(convention));
}

std::vector<FactorCandidate> bare_candidates() {
  using enum CurrentConvention;
  std::vector<FactorCandidate> list{
      {kDc, "Kt = Ke (dc ampere)", factor_of(kDc, Modulation::kSvpwm), {}, Agreement::kExcludes}};
  for (const CurrentConvention convention : {kPeakPhase, kRmsPhase}) {
    for (const Modulation modulation :
         {Modulation::kSvpwm, Modulation::kSine, Modulation::kSixStep}) {
      list.push_back({convention,
                      fmt::format("Nm per {} ampere, {}", convention == kPeakPhase ? "peak" : "rms",
                                  name_of(modulation)),
                      factor_of(convention, modulation),
                      {},
                      Agreement::kExcludes});
    }
  }
  return list;
}

bool is_tolerated_by_all(const CommonFactor& common, double factor) {
  return std::all_of(common.required.begin(), common.required.end(), [factor](const auto& one) {
    return factor >= one.tolerated.low && factor <= one.tolerated.high;
  });
}

Agreement fit_of(const CommonFactor& common, double factor) {
  if (factor >= common.low && factor <= common.high) return Agreement::kFits;
  const bool exceeds_all =
      std::all_of(common.required.begin(), common.required.end(),
                  [factor](const RequiredFactor& one) { return factor >= one.factor.low; });
  return exceeds_all ? Agreement::kAdmits : Agreement::kExcludes;
}

std::string joined(const CommonFactor& common, const char* separator,
                   std::string (*text)(const RequiredFactor&)) {
  std::string all;
  for (const RequiredFactor& one : common.required) {
    all += (all.empty() ? "" : separator) + text(one);
  }
  return all;
}

/// Candidates that every sheet's tolerance leaves open, as a list.
std::string tolerated_ones(const CommonFactor& common) {
  std::string names;
  for (const FactorCandidate& candidate : common.candidates) {
    if (!candidate.is_tolerated) continue;
    names += fmt::format("{}{}", names.empty() ? "" : " or ", candidate.sentence);
  }
  return names;
}

std::string sentence_of(const CommonFactor& common) {
  const std::string factors = joined(common, " and ", [](const RequiredFactor& one) {
    return fmt::format("{:.3f} ({:.3f} to {:.3f})", one.factor.value, one.factor.low,
                       one.factor.high);
  });
  std::string sentence = fmt::format(
      "the no-load speeds of {} need c = {} in c V / (Kt N): ",
      joined(common, " and ", [](const RequiredFactor& one) { return one.actuator; }), factors);
  if (common.is_common_as_printed) {
    sentence += "the same for all, but no convention's";
  } else {
    sentence += fmt::format("no single factor fits {} as printed",
                            common.required.size() == 2 ? "both" : "all");
    sentence += common.low <= common.high
                    ? fmt::format(
                          ", and with rounding only c = {:.3f} to {:.3f}, where no "
                          "convention lies",
                          common.low, common.high)
                    : ", nor with rounding";
  }
  const std::string tolerated = tolerated_ones(common);
  if (!tolerated.empty())
    sentence += fmt::format("; within what catalogues leave open {}", tolerated);
  return sentence +
         ": ask the maker which ampere and which speed (no-load, loaded, capped) is meant.";
}

/// A stated current per rms ampere is larger in amplitude: what the drive would have to deliver.
std::string consequence(const FactorCandidate& candidate, const CommonFactor& common) {
  if (candidate.convention != CurrentConvention::kRmsPhase) return candidate.sentence;
  const double stated_A = common.required.front().peak_current_A;
  return fmt::format("{}: then {:g} A are {:.1f} A of amplitude", candidate.sentence, stated_A,
                     stated_A * phase_amperes_per_ampere(candidate.convention));
}

/// Ke / (Ke - p L_d i), i the greatest d current; 1 where the document weakens no field.
double greatest_weakening(const Actuator& document) {
  if (!document.drive.field_weakening) return 1.0;
  Interpretation reading = as_stated(document);
  reading.document.motor.torque_constant_convention = CurrentConvention::kDc;
  reading.document.motor.back_emf_constant_V_s_rad.reset();
  const double limit_A =
      std::min(peak_current(reading).value, demagnetisation_current(reading).value);
  const double back_emf = phase_back_emf(reading).value;
  const double left = back_emf - document.motor.pole_pairs * document.motor.inductance_d_H *
                                     phase_current(reading, exact(limit_A)).value;
  return left > 0.0 ? back_emf / left : kUnlimited;
}

/// Kt = Ke for all, with field weakening on those that need more than that, as far as it goes.
std::optional<Explanation> weakened_by(const CommonFactor& common) {
  std::string names;
  for (const RequiredFactor& one : common.required) {
    if (one.factor.high < 1.0) return std::nullopt;
    if (one.factor.low <= 1.0) continue;
    if (one.factor.low > one.greatest_weakening) return std::nullopt;
    names += fmt::format("{}{} by {:.1f} %", names.empty() ? "" : " and ", one.actuator,
                         100.0 * (one.factor.value - 1.0));
  }
  return Explanation{fmt::format("Kt = Ke (dc ampere), and field weakening only on {}", names),
                     std::nullopt, Agreement::kFits};
}

}  // namespace

std::optional<CommonFactor> common_factor(std::span<const Actuator> documents) {
  CommonFactor common;
  common.low = 0.0;
  common.high = kUnlimited;
  common.candidates = bare_candidates();
  for (const Actuator& document : documents) {
    if (!stated_speed(document)) continue;
    const RoundedInterval factor = required_factor(document);
    if (is_one_sided(factor)) continue;  // a bound of a speed needs no one factor
    common.required.push_back({document.name, factor, *stated_speed(document),
                               document.drive.peak_current_A, greatest_weakening(document),
                               tolerated_factors(document, factor), assumes_convention(document)});
    common.low = std::max(common.low, common.required.back().factor.low);
    common.high = std::min(common.high, common.required.back().factor.high);
    for (FactorCandidate& candidate : common.candidates) {
      candidate.speeds_rad_s.push_back(
          derive(product, plain_speed(document), exact(candidate.factor)));
    }
  }
  if (common.required.size() < 2) return std::nullopt;
  const double first = common.required.front().factor.value;
  common.is_common_as_printed = std::all_of(
      common.required.begin(), common.required.end(), [first](const RequiredFactor& one) {
        return std::abs(one.factor.value - first) <= kSamePrintedFactor * first;
      });
  for (FactorCandidate& candidate : common.candidates) {
    candidate.fit = fit_of(common, candidate.factor);
    candidate.is_tolerated = is_tolerated_by_all(common, candidate.factor);
  }
  return common;
}

std::optional<Finding> finding_of(const CommonFactor& common) {
  const bool is_tolerated = !tolerated_ones(common).empty();
  const bool is_any_assumed = std::any_of(common.required.begin(), common.required.end(),
                                          [](const auto& one) { return one.assumes_convention; });
  if (is_tolerated && !is_any_assumed) return std::nullopt;
  Finding finding;
  for (const FactorCandidate& candidate : common.candidates) {
    if (candidate.fit == Agreement::kFits) return std::nullopt;
    if (candidate.fit == Agreement::kExcludes) continue;  // they stand in common.candidates
    finding.explanations.push_back(
        {consequence(candidate, common), exact(candidate.factor), candidate.fit});
  }
  if (const auto weakened = weakened_by(common)) finding.explanations.push_back(*weakened);
  finding.severity = is_tolerated ? Severity::kNote : contradiction(finding.explanations);
  finding.rule = "common-convention";
  finding.actuator = joined(common, ", ", [](const RequiredFactor& one) { return one.actuator; });
  finding.sentence = sentence_of(common);
  finding.stated = common.required.back().factor;
  finding.expected = common.required.front().factor;
  return finding;
}

}  // namespace torquewright::actuator::lint
