// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/simulator_file_json.hpp"

#include <nlohmann/json.hpp>

#include "actuator/mor/mor_header.hpp"
#include "actuator/mor/mor_table_spec.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::ordered_json;

ordered_json worst_json(const WorstError& error) {
  return {{"torque_Nm", error.torque_Nm}, {"speed_rad_s", error.speed_rad_s}};
}

ordered_json error_json(const QuadrantError& error) {
  const char* speed = error.direction > 0 ? "positive" : error.direction < 0 ? "negative" : "zero";
  return {{"speed", speed},
          {"bound", error.is_upper ? "upper" : "lower"},
          {"mode", mode_of(error)},
          {"optimistic", worst_json(error.optimistic)},
          {"cautious", worst_json(error.cautious)}};
}

ordered_json shape_json(const Exporter& exporter, const Shape& shape) {
  ordered_json entry = ordered_json::object();
  for (std::size_t i = 0; i < exporter.parameters.size(); ++i) {
    entry[std::string(exporter.parameters[i].name)] = shape[i];
  }
  if (!exporter.parameters.empty()) return entry;
  const auto rows = static_cast<std::ptrdiff_t>(shape.size() / 3);
  const auto block = [&](std::ptrdiff_t i) {
    return std::vector<double>(shape.begin() + i * rows, shape.begin() + (i + 1) * rows);
  };
  return {{"speed_rad_s", block(0)}, {"torque_min_Nm", block(1)}, {"torque_max_Nm", block(2)}};
}

/// What the region's own documents say of it; of the drive with its friction, what it states.
ordered_json header_json(const Subject& subject) {
  const MorHeader limits{&subject.actuator, subject.conditions, subject.region.side()};
  if (!subject.friction) return mor_table_json(limits, MorTable{});
  const MorHeader whole{subject.whole, subject.conditions, subject.region.side()};
  ordered_json header = mor_table_json(whole, MorTable{});
  header["friction_included"] = friction_sentence(limits);
  header["left_out"] = left_out_of(subject);
  return header;
}

/// Where the joint has the friction: what it has, and the errors below the limits.
void add_joint_friction(const Subject& subject, const ErrorReport& errors, ordered_json& entry) {
  if (!subject.friction) return;
  entry["joint_friction"] = {{"coulomb_Nm", subject.friction->coulomb_Nm},
                             {"breakaway_Nm", subject.friction->breakaway_Nm},
                             {"viscous_Nm_s_rad", subject.friction->viscous_Nm_s_rad}};
  entry["errors_at_half"] = ordered_json::array();
  for (const QuadrantError& error : *errors.at_half) {
    entry["errors_at_half"].push_back(error_json(error));
  }
}

}  // namespace

ordered_json simulator_file_json(const Subject& subject, const SimulatorFile& file) {
  const ordered_json header = header_json(subject);
  ordered_json errors = ordered_json::array();
  for (const QuadrantError& error : file.errors.quadrants) errors.push_back(error_json(error));
  for (const QuadrantError& error : file.errors.at_rest) errors.push_back(error_json(error));
  ordered_json entry{
      {"kind", "simulator_file"},
      {"version", 1},
      {"format", file.exporter->name},
      {"simulator", file.exporter->simulator},
      {"source", file.exporter->source},
      {"fit", name_of(subject.fit)},
      {"parameters", shape_json(*file.exporter, file.shape)},
      {"armature_kg_m2",
       subject.armature_kg_m2() > 0.0 ? ordered_json(subject.armature_kg_m2()) : ordered_json()}};
  for (const auto& item : header.items()) {
    const bool is_of_the_region = item.key() != "kind" && item.key() != "version" &&
                                  item.key() != "rows" && item.key() != "interpolation_error_Nm";
    if (is_of_the_region) entry[item.key()] = item.value();
  }
  entry["greatest_speed_rad_s"] = file.errors.greatest_speed_rad_s;
  entry["errors"] = errors;
  add_joint_friction(subject, file.errors, entry);
  entry["share_outside"] = file.errors.share_outside;
  entry["sentences"] = file.errors.sentences;
  entry["file"] = file.text;
  return entry;
}

}  // namespace torquewright::actuator
