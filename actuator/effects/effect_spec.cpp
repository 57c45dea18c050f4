// SPDX-License-Identifier: Apache-2.0
#include "actuator/effects/effect_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "actuator/effects/library.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {
namespace {

/// " Nm", as the parameter's name ends; empty: it has none.
std::string unit_behind(std::string_view name) {
  struct Ending {
    std::string_view text;
    std::string_view unit;
  };
  // Longer ones first, where one ends in another.
  constexpr Ending kEndings[] = {{"_Nm_s2_rad2", " Nm s^2/rad^2"},
                                 {"_Nm_s_rad", " Nm s/rad"},
                                 {"_Nm_rad", " Nm/rad"},
                                 {"_kg_m2", " kg m^2"},
                                 {"_rad_s", " rad/s"},
                                 {"_1_K", " 1/K"},
                                 {"_ohm", " ohm"},
                                 {"_rad", " rad"},
                                 {"_Nm", " Nm"},
                                 {"_s", " s"},
                                 {"_A", " A"},
                                 {"_V", " V"}};
  for (const Ending& ending : kEndings) {
    if (name.ends_with(ending.text)) return std::string(ending.unit);
  }
  return "";
}

/// "0 or more Nm", "-1 to 1".
std::string possible(const Parameter& parameter) {
  const std::string unit = unit_behind(parameter.name);
  if (std::isinf(parameter.highest)) return fmt::format("{} or more{}", parameter.lowest, unit);
  if (std::isinf(parameter.lowest)) return fmt::format("{} or less{}", parameter.highest, unit);
  return fmt::format("{} to {}{}", parameter.lowest, parameter.highest, unit);
}

using nlohmann::json;

constexpr std::size_t kMostHarmonics = 64;

/// Reads the parameters of one effect; faults gather.
class EffectReader {
 public:
  EffectReader(const json& entry, const std::string& file, const std::string& path,
               std::vector<io::Fault>& faults)
      : entry_(entry), file_(file), path_(path), faults_(faults) {}

  std::optional<Effect> read() {
    const std::size_t faults_before = faults_.size();
    const std::string name = entry_["effect"];
    const EffectKind* kind = find_effect(name);
    if (kind == nullptr) {
      report("/effect",
             fmt::format("\"{}\" is no effect of an actuator{}", name, known_effects(name)));
      return std::nullopt;
    }
    effect_.kind = kind;
    read_provenance();
    check_names();
    for (const Parameter& parameter : kind->parameters) read_value(parameter);
    if (kind->has_harmonics) read_harmonics();
    if (faults_.size() == faults_before) check_together();
    if (faults_.size() > faults_before) return std::nullopt;
    return std::move(effect_);
  }

 private:
  const json& parameters() const { return entry_["parameters"]; }

  void report(const std::string& path, std::string message) {
    faults_.push_back({file_, path_ + path, std::move(message)});
  }

  /// A word, or an object whose "source" is the word: what identification writes.
  void read_provenance() {
    if (!entry_.contains("provenance")) return;
    const json& provenance = entry_["provenance"];
    effect_.provenance = provenance.is_string() ? provenance.get<std::string>()
                                                : provenance["source"].get<std::string>();
  }

  static std::string known_effects(const std::string& name) {
    std::vector<std::string> known;
    for (const EffectKind* kind : effect_library()) known.emplace_back(kind->name);
    const std::optional<std::string> nearest = io::nearest(name, known);
    return nearest ? fmt::format("; did you mean \"{}\"?", *nearest)
                   : fmt::format("; known are {}", io::listed(known));
  }

  std::vector<std::string> known_names() const {
    std::vector<std::string> names;
    for (const Parameter& parameter : effect_.kind->parameters) names.emplace_back(parameter.name);
    if (effect_.kind->has_harmonics) names.emplace_back("harmonics");
    if (effect_.kind->may_be_proportional) names.emplace_back("proportional");
    return names;
  }

  void check_names() {
    const std::vector<std::string> known = known_names();
    for (const auto& item : parameters().items()) {
      if (std::find(known.begin(), known.end(), item.key()) != known.end()) continue;
      report("/parameters/" + item.key(), fmt::format("{} has no such parameter, only {}",
                                                      effect_.kind->name, io::listed(known)));
    }
  }

  void read_value(const Parameter& parameter) {
    const std::string name(parameter.name);
    const std::string path = "/parameters/" + name;
    if (!parameters().contains(name)) {
      report(path, fmt::format("missing; {}", parameter.meaning));
      return;
    }
    const json& value = parameters()[name];
    if (!value.is_number()) {
      report(path, fmt::format("{} is not a number", io::as_written(value)));
      return;
    }
    const double number = value.get<double>();
    if (number < parameter.lowest || number > parameter.highest) {
      report(path, fmt::format("{} is outside what is possible, {}: {}", io::as_written(value),
                               possible(parameter), parameter.meaning));
    }
    effect_.values.push_back(number);
  }

  void read_harmonics() {
    effect_.proportional = parameters().value("proportional", false);
    const json& list = parameters().contains("harmonics") ? parameters()["harmonics"] : json();
    if (!list.is_array() || list.empty() || list.size() > kMostHarmonics) {
      report("/parameters/harmonics",
             fmt::format("must be a list of 1 to {} harmonics, each {{\"order\", \"{}\", "
                         "\"phase_rad\"}}",
                         kMostHarmonics, amplitude_key()));
      return;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      read_harmonic(list[i], fmt::format("/parameters/harmonics/{}", i));
    }
  }

  std::string amplitude_key() const {
    return effect_.proportional ? "amplitude_ratio" : "amplitude_Nm";
  }

  void read_harmonic(const json& wave, const std::string& path) {
    const std::vector<std::string> keys = {"order", amplitude_key(), "phase_rad"};
    for (const std::string& key : keys) {
      if (!wave.is_object() || !wave.contains(key) || !wave[key].is_number()) {
        report(path,
               fmt::format("{} is missing or no number; a harmonic has {}", key, io::listed(keys)));
        return;
      }
    }
    for (const auto& item : wave.items()) {
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) {
        report(path + "/" + item.key(),
               fmt::format("a harmonic has no such key, only {}", io::listed(keys)));
      }
    }
    const Harmonic harmonic{wave["order"], wave[amplitude_key()], wave["phase_rad"]};
    if (harmonic.order <= 0.0 || harmonic.order > 10000.0) {
      report(path + "/order", fmt::format("{} is outside 0 to 10000 waves a turn", harmonic.order));
    }
    if (effect_.proportional && std::abs(harmonic.amplitude) >= 1.0) {
      report(path + "/amplitude_ratio", "must be below 1: the ripple would exceed the load");
    }
    effect_.harmonics.push_back(harmonic);
  }

  void check_together() {
    const std::span<const Parameter> all = effect_.kind->parameters;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k].name != all[i].at_least || effect_.values[i] >= effect_.values[k]) continue;
        report(fmt::format("/parameters/{}", all[i].name),
               fmt::format("{} is below {}, {}: {}", effect_.values[i], all[k].name,
                           effect_.values[k], all[i].meaning));
      }
    }
  }

  const json& entry_;
  const std::string& file_;
  const std::string& path_;
  std::vector<io::Fault>& faults_;
  Effect effect_;
};

}  // namespace

std::optional<Effect> read_effect(const json& entry, const std::string& file,
                                  const std::string& path, std::vector<io::Fault>& faults) {
  return EffectReader(entry, file, path, faults).read();
}

nlohmann::ordered_json effect_json(const Effect& effect) {
  nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    parameters[std::string(effect.kind->parameters[i].name)] = effect.values[i];
  }
  if (effect.kind->may_be_proportional) parameters["proportional"] = effect.proportional;
  for (const Harmonic& wave : effect.harmonics) {
    parameters["harmonics"].push_back(
        {{"order", wave.order},
         {effect.proportional ? "amplitude_ratio" : "amplitude_Nm", wave.amplitude},
         {"phase_rad", wave.phase_rad}});
  }
  nlohmann::ordered_json json{{"effect", effect.kind->name}, {"parameters", parameters}};
  if (!effect.provenance.empty()) json["provenance"] = effect.provenance;
  return json;
}

}  // namespace torquewright::actuator
