// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/simulator_file.hpp"

#include <fmt/format.h>

#include "actuator/region/mor_table_spec.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::ordered_json;

/// What the region's own documents say of it.
ordered_json header_of(const Subject& subject) {
  const MorHeader header{&subject.actuator, subject.conditions, subject.region.side()};
  return mor_table_json(header, MorTable{});
}

std::string armature_line(const Subject& subject) {
  if (subject.region.side() == Side::kMotor) {
    return fmt::format("Armature: {:.6g} kg m^2, the rotor alone.", subject.armature_kg_m2());
  }
  const double gears_kg_m2 = subject.actuator.transmission.inertia_kg_m2;
  return fmt::format(
      "Armature: {:.6g} kg m^2 = N^2 J, N = {:.6g}, J = {:.6g} kg m^2{}. Do not add the rotor to a "
      "link as well.",
      subject.armature_kg_m2(), subject.ratio(), subject.actuator.motor.rotor_inertia_kg_m2,
      gears_kg_m2 > 0.0 ? fmt::format(", plus {:.6g} kg m^2 of the gears", gears_kg_m2) : "");
}

std::string fit_line(const Exporter& exporter, const Subject& subject) {
  if (exporter.parameters.empty()) {
    return subject.fit == LawFit::kConservative
               ? "Fit: conservative (the region's table, drawn in by its interpolation error)."
               : "Fit: best (the region's table).";
  }
  return subject.fit == LawFit::kConservative
             ? "Fit: conservative (inside the region wherever that holds zero torque)."
             : "Fit: best (least squares of both bounds).";
}

std::string_view text_of(const ordered_json& document, std::string_view key) {
  return document.at(std::string(key)).get_ref<const std::string&>();
}

std::vector<std::string> note_of(const Subject& subject, const Exporter& exporter,
                                 std::span<const double> shape, const ErrorReport& errors,
                                 const std::vector<std::string>& origin) {
  const ordered_json header = header_of(subject);
  std::vector<std::string> note = origin;
  note.push_back(fmt::format("{} for {}.", subject.actuator.name, exporter.simulator));
  note.push_back(fmt::format("Fields as in {}", exporter.source));
  note.push_back(fit_line(exporter, subject));
  note.push_back(
      fmt::format("Side: {}. Rating: {}. Bus voltage: {:.6g} V. Winding temperature: {:.6g} K.",
                  text_of(header, "side"), text_of(header, "rating"), subject.bus_voltage_V(),
                  header.at("winding_temperature_K").get<double>()));
  note.push_back(fmt::format("Friction included: {}. Do not also apply friction or an efficiency.",
                             text_of(header, "friction_included")));
  note.push_back(armature_line(subject));
  note.emplace_back(exporter.advice);
  for (const ordered_json& entry : header.at("left_out")) {
    note.push_back("Left out: " + entry.get<std::string>());
  }
  for (const ordered_json& entry : header.at("assumed")) {
    note.push_back("Assumed: " + entry.get<std::string>());
  }
  for (std::size_t i = 0; i < exporter.parameters.size(); ++i) {
    note.push_back(fmt::format("{} = {:.10g}", exporter.parameters[i].name, shape[i]));
  }
  for (std::string& line : error_lines(errors)) note.push_back(std::move(line));
  return note;
}

ordered_json worst_json(const WorstError& error) {
  return {{"torque_Nm", error.torque_Nm}, {"speed_rad_s", error.speed_rad_s}};
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

}  // namespace

SimulatorFile simulator_file(const Subject& subject, const Exporter& exporter,
                             const std::vector<std::string>& origin) {
  SimulatorFile file;
  file.exporter = &exporter;
  file.shape = exporter.shape(subject);
  file.errors = error_report(subject, exporter, file.shape);
  file.note = note_of(subject, exporter, file.shape, file.errors, origin);
  file.text = exporter.write(subject, file.shape, file.note);
  return file;
}

ordered_json simulator_file_json(const Subject& subject, const SimulatorFile& file) {
  const ordered_json header = header_of(subject);
  ordered_json errors = ordered_json::array();
  for (const QuadrantError& quadrant : file.errors.quadrants) {
    errors.push_back({{"speed", quadrant.direction > 0 ? "positive" : "negative"},
                      {"bound", quadrant.is_upper ? "upper" : "lower"},
                      {"optimistic", worst_json(quadrant.optimistic)},
                      {"cautious", worst_json(quadrant.cautious)}});
  }
  ordered_json entry{{"kind", "simulator_file"},
                     {"version", 1},
                     {"format", file.exporter->name},
                     {"simulator", file.exporter->simulator},
                     {"source", file.exporter->source},
                     {"fit", name_of(subject.fit)},
                     {"parameters", shape_json(*file.exporter, file.shape)},
                     {"armature_kg_m2", subject.armature_kg_m2()}};
  for (const auto& item : header.items()) {
    const bool is_of_the_region = item.key() != "kind" && item.key() != "version" &&
                                  item.key() != "rows" && item.key() != "interpolation_error_Nm";
    if (is_of_the_region) entry[item.key()] = item.value();
  }
  entry["greatest_speed_rad_s"] = file.errors.greatest_speed_rad_s;
  entry["errors"] = errors;
  entry["share_outside"] = file.errors.share_outside;
  entry["sentences"] = file.errors.sentences;
  entry["file"] = file.text;
  return entry;
}

}  // namespace torquewright::actuator
