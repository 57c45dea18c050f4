// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/simulator_file.hpp"

#include <fmt/format.h>

#include "actuator/mor/mor_header.hpp"
#include "actuator/region/left_out.hpp"

namespace torquewright::actuator {
namespace {

/// Which number counts where the file's field is not the armature.
std::string_view field_words(const Exporter& exporter) {
  if (!exporter.inertia_at_rotor) return "";
  return " The file's field is of the rotor, this over N^2: the simulator makes this number of it, "
         "and where both are touched the field wins.";
}

std::string armature_line(const Subject& subject, const Exporter& exporter) {
  if (subject.armature_kg_m2() == 0.0) {
    return "Armature: left out, the document states no inertia of the rotor; find and set it.";
  }
  if (subject.region.side() == Side::kMotor) {
    return fmt::format("Armature: {:.6g} kg m^2, the rotor alone.", subject.armature_kg_m2());
  }
  const double gears_kg_m2 = subject.actuator.transmission.inertia_kg_m2;
  return fmt::format(
      "Armature: {:.6g} kg m^2 = N^2 J, N = {:.6g}, J = {:.6g} kg m^2{}. Do not add the rotor to a "
      "link as well.{}",
      subject.armature_kg_m2(), subject.ratio(), subject.actuator.motor.rotor_inertia_kg_m2,
      gears_kg_m2 > 0.0 ? fmt::format(", plus {:.6g} kg m^2 of the gears", gears_kg_m2) : "",
      field_words(exporter));
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

/// " Bus voltage: 67.2 V. Winding temperature: 298.15 K."; of a curve what it states.
std::string electrical_words(const Subject& subject) {
  const std::optional<Envelope>& envelope = subject.actuator.envelope;
  if (envelope && !envelope->voltage_V) return "";
  std::string text = fmt::format(" Bus voltage: {:.6g} V.", subject.bus_voltage_V());
  if (envelope) return text;
  return text + fmt::format(" Winding temperature: {:.6g} K.",
                            winding_temperature_K(subject.actuator, subject.conditions));
}

/// "0.4 Nm dry (0.6 Nm at rest), 0.02 Nm s/rad viscous".
std::string joint_friction_words(const JointFriction& friction) {
  std::string words = fmt::format("{:.6g} Nm dry", friction.coulomb_Nm);
  if (friction.breakaway_Nm > friction.coulomb_Nm) {
    words += fmt::format(" ({:.6g} Nm at rest)", friction.breakaway_Nm);
  }
  return words + fmt::format(", {:.6g} Nm s/rad viscous", friction.viscous_Nm_s_rad);
}

/// Which friction is where, and what a command is of.
void say_friction(const Subject& subject, const Exporter& exporter,
                  std::vector<std::string>& note) {
  const MorHeader header{&subject.actuator, subject.conditions, subject.region.side()};
  const std::string limits = friction_sentence(header);
  if (!subject.friction) {
    note.push_back(
        fmt::format("Friction included: {}. Do not also apply friction or an efficiency.", limits));
    return;
  }
  const bool is_composed = exporter.friction.dry == DryFriction::kComposed;
  note.push_back(fmt::format(
      "Friction: {}, {}. Do not apply it again. A command is the torque that the motor brings to "
      "the joint, and the limits are of that: {}.",
      is_composed ? "taken off by torque()" : "the joint's",
      joint_friction_words(*subject.friction), limits));
  note.emplace_back(exporter.friction.law);
}

std::vector<std::string> note_of(const Subject& subject, const Exporter& exporter,
                                 std::span<const double> shape, const ErrorReport& errors,
                                 const std::vector<std::string>& origin) {
  const MorHeader header{&subject.actuator, subject.conditions, subject.region.side()};
  std::vector<std::string> note = origin;
  note.push_back(fmt::format("{} for {}.", subject.actuator.name, exporter.simulator));
  note.push_back(fmt::format("Fields as in {}", exporter.source));
  note.push_back(fit_line(exporter, subject));
  note.push_back(fmt::format("Side: {}. Rating: {}.{}", name_of(header.side),
                             name_of(header.conditions.rating), electrical_words(subject)));
  say_friction(subject, exporter, note);
  const std::optional<Envelope>& envelope = subject.actuator.envelope;
  if (envelope && envelope->braking == Braking::kFull) {
    note.emplace_back(
        "Braking: the document states none; here the greatest torque brakes at every speed, as "
        "simulators have it. A check takes no more than drives.");
  }
  note.push_back(armature_line(subject, exporter));
  const bool has_own_advice = subject.friction && !exporter.friction.advice.empty();
  note.emplace_back(has_own_advice ? exporter.friction.advice : exporter.advice);
  for (const std::string& entry : left_out_of(subject)) note.push_back("Left out: " + entry);
  for (const std::string& entry : subject.actuator.assumed) note.push_back("Assumed: " + entry);
  for (std::size_t i = 0; i < exporter.parameters.size(); ++i) {
    note.push_back(fmt::format("{} = {:.10g}", exporter.parameters[i].name, shape[i]));
  }
  for (std::string& line : error_lines(errors)) note.push_back(std::move(line));
  return note;
}

}  // namespace

std::vector<std::string> left_out_of(const Subject& subject) {
  if (!subject.friction) return left_out(subject.actuator, Part::kRegion);
  // What has become the joint's is no effect of the limited drive any more, and not left out.
  std::vector<std::string> sentences = left_out(subject.actuator, Part::kRegion);
  if (subject.whole->effects.empty()) return sentences;
  std::erase_if(sentences, [](const std::string& entry) {
    return entry.starts_with("friction: no effects stated");
  });
  return sentences;
}

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

}  // namespace torquewright::actuator
