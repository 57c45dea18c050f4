// SPDX-License-Identifier: Apache-2.0
// Fields: URDF, <limit effort velocity> and <dynamics damping friction> of <joint>
// (wiki.ros.org/urdf/XML/joint); MJCF, body/joint armature, damping, frictionloss and
// actuator/general forcerange, which lies before gear (mujoco.readthedocs.io, XMLreference).
#include "robot/simulators/patched_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "actuator/mor/region_summary.hpp"
#include "actuator/region/joint_region.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"
#include "robot/xml/xml_source.hpp"

namespace torquewright::hopper {
namespace {

/// Six digits: more than any drive's sheet knows, and as simulators' files have it.
std::string digits(double value) { return fmt::format("{:.6g}", value); }

std::size_t line_of(const std::string& text, std::size_t place) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(place);
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

/// What both formats do alike: which joints there are, and whose numbers they get.
class Patch {
 public:
  Patch(const std::string& file, const std::string& text, const std::vector<PatchedDrive>& drives)
      : file_(file), text_(text), drives_(drives), elements_(elements_of(text)) {}

  PatchedFile run() {
    const std::string root = elements_.empty() ? "" : elements_.front().name;
    if (root != "robot" && root != "mujoco") {
      io::refuse(file_, fmt::format("begins with <{}>; patched are files of URDF (<robot>) and of "
                                    "MJCF (<mujoco>)",
                                    root));
    }
    is_urdf_ = root == "robot";
    find_joints();
    require_fits();
    for (const auto& [name, joint] : joints_) {
      if (const PatchedDrive* drive = drive_of(name)) {
        is_urdf_ ? patch_urdf(name, joint, drive->numbers)
                 : patch_mjcf(name, joint, drive->numbers);
      }
    }
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    result_.text = edited(text_, edits_);
    return std::move(result_);
  }

 private:
  void report(std::size_t element, const std::string& message) {
    faults_.push_back(
        {file_, "", fmt::format("line {}: {}", line_of(text_, elements_[element].begin), message)});
  }

  bool is_below(std::size_t element, std::string_view ancestor) const {
    for (std::size_t at = elements_[element].parent; at != SourceElement::kNone;
         at = elements_[at].parent) {
      if (elements_[at].name == ancestor) return true;
    }
    return false;
  }

  std::optional<std::size_t> child_of(std::size_t parent, std::string_view name) const {
    for (std::size_t i = parent + 1; i < elements_.size(); ++i) {
      if (elements_[i].parent == parent && elements_[i].name == name) return i;
    }
    return std::nullopt;
  }

  void find_joints() {
    for (std::size_t i = 1; i < elements_.size(); ++i) {
      if (elements_[i].name != "joint" || elements_[i].value("name").empty()) continue;
      const bool is_of_tree = is_urdf_ ? elements_[i].parent == 0 : is_below(i, "worldbody");
      if (!is_of_tree) continue;
      const std::string name = elements_[i].value("name");
      if (std::any_of(joints_.begin(), joints_.end(),
                      [&](const auto& each) { return each.first == name; })) {
        report(i, fmt::format("a second joint is called {}", name));
      }
      joints_.emplace_back(name, i);
    }
  }

  /// A pattern means the joints that turn: LF_KFE and not LF_thigh_fixed_LF_KFE. A fixed joint that
  /// is called by its name is meant.
  bool is_meant(const std::string& joint, const std::string& pattern) const {
    if (!io::fits_pattern(joint, pattern)) return false;
    const auto found = std::find_if(joints_.begin(), joints_.end(),
                                    [&](const auto& each) { return each.first == joint; });
    const bool is_fixed = is_urdf_ && elements_[found->second].value("type") == "fixed";
    return !is_fixed || pattern.find('*') == std::string::npos;
  }

  void require_fits() const {
    std::vector<std::string> names;
    for (const auto& [name, joint] : joints_) names.push_back(name);
    for (const PatchedDrive& each : drives_) {
      const auto fits = [&](const std::string& name) { return is_meant(name, each.pattern); };
      if (std::any_of(names.begin(), names.end(), fits)) continue;
      std::string why = "fits no joint of " + file_;
      if (const auto near = io::nearest(each.pattern, names)) {
        why += fmt::format("; did you mean \"{}\"?", *near);
      } else if (!names.empty()) {
        why += ", whose joints are " + io::listed(names);
      }
      io::refuse(each.pattern, why + included());
    }
  }

  /// Joints may stand in files that this one takes in.
  std::string included() const {
    std::vector<std::string> files;
    for (const SourceElement& each : elements_) {
      if (each.name == "include") files.push_back(each.value("file"));
    }
    return files.empty()
               ? ""
               : fmt::format("; it takes in {}, which is patched by itself", io::listed(files));
  }

  const PatchedDrive* drive_of(const std::string& joint) const {
    const PatchedDrive* found = nullptr;
    for (const PatchedDrive& each : drives_) {
      if (!is_meant(joint, each.pattern)) continue;
      if (found != nullptr) {
        io::refuse(each.pattern,
                   fmt::format("fits {} too, which \"{}\" fits: a joint has one drive", joint,
                               found->pattern));
      }
      found = &each;
    }
    return found;
  }

  void set(std::size_t element, const std::string& name, const std::string& value) {
    if (elements_[element].value(name) == value) return;
    edits_.push_back(set_attribute(elements_[element], name, value));
  }

  // URDF

  void patch_urdf(const std::string& name, std::size_t joint, const DriveNumbers& drive) {
    const std::string type = elements_[joint].value("type");
    if (type != "revolute" && type != "continuous") {
      return report(joint, fmt::format("{} is {}; a drive's numbers are of joints that turn", name,
                                       type.empty() ? "of no type" : type));
    }
    if (child_of(joint, "mimic")) {
      return report(joint,
                    fmt::format("{} follows another joint (<mimic>): it has no drive", name));
    }
    using Values = std::vector<std::pair<std::string, std::string>>;
    set_child(joint, "limit",
              Values{{"effort", digits(drive.torque_Nm)}, {"velocity", digits(drive.speed_rad_s)}});
    if (drive.friction) {
      set_child(joint, "dynamics",
                Values{{"damping", digits(drive.friction->viscous_Nm_s_rad)},
                       {"friction", digits(drive.friction->coulomb_Nm)}});
    }
    result_.joints.push_back(name);
    note("URDF has no field for the inertia of rotors: it is not written");
  }

  /// Attributes of a child, which gets a line of its own where the joint has none.
  void set_child(std::size_t joint, const std::string& child,
                 const std::vector<std::pair<std::string, std::string>>& values) {
    if (const auto there = child_of(joint, child)) {
      for (std::size_t i = *there + 1; i < elements_.size(); ++i) {
        if (elements_[i].parent != joint || elements_[i].name != child) continue;
        return report(i, fmt::format("a second <{}> of one joint: which of them holds?", child));
      }
      return set_all(*there, values);
    }
    if (elements_[joint].is_empty) {
      return report(joint, fmt::format("has no <{}>, and no place for one", child));
    }
    std::string tag = "<" + child;
    for (const auto& [name, value] : values) tag += " " + name + "=\"" + value + "\"";
    const std::size_t place = elements_[joint].tag_end;
    edits_.push_back({place, place, break_behind(place) + tag + "/>"});
  }

  void set_all(std::size_t element,
               const std::vector<std::pair<std::string, std::string>>& values) {
    std::string added;
    for (const auto& [name, value] : values) {
      if (elements_[element].find(name) != nullptr) {
        set(element, name, value);
      } else {
        added += " " + name + "=\"" + value + "\"";
      }
    }
    if (added.empty()) return;
    const std::size_t place = elements_[element].attributes_end();
    edits_.push_back({place, place, added});
  }

  /// The line break and indentation that stand there already, so that a further child has them too.
  std::string break_behind(std::size_t place) const {
    const std::size_t end = text_.find_first_not_of(" \t\r\n", place);
    return text_.substr(place, std::min(end, text_.size()) - place);
  }

  // MJCF

  void patch_mjcf(const std::string& name, std::size_t joint, const DriveNumbers& drive) {
    const std::string type = elements_[joint].value("type");
    if (!type.empty() && type != "hinge") {
      return report(joint,
                    fmt::format("{} is of type {}; a drive's numbers are of hinges", name, type));
    }
    if (is_below(joint, "replicate") || is_below(joint, "composite")) {
      return report(joint, fmt::format("{} stands for several joints", name));
    }
    std::vector<std::pair<std::string, std::string>> values;
    if (drive.armature_kg_m2 > 0.0) values.emplace_back("armature", digits(drive.armature_kg_m2));
    if (drive.friction) {
      values.emplace_back("damping", digits(drive.friction->viscous_Nm_s_rad));
      values.emplace_back("frictionloss", digits(drive.friction->coulomb_Nm));
    }
    set_all(joint, values);
    const bool has_actuator = limit_actuators(name, drive.torque_Nm);
    if (!has_actuator)
      note(fmt::format("{}: no <actuator> turns it, so that no forcerange is written", name));
    note("MJCF has no field for a joint's greatest speed: it is not written");
    result_.joints.push_back(name);
  }

  bool limit_actuators(const std::string& joint, double torque_Nm) {
    bool has_actuator = false;
    for (std::size_t i = 1; i < elements_.size(); ++i) {
      const bool turns =
          elements_[i].value("joint") == joint || elements_[i].value("jointinparent") == joint;
      if (!turns || !is_below(i, "actuator")) continue;
      has_actuator = true;
      if (const auto gear = gear_of(i)) set_forcerange(i, torque_Nm / std::abs(*gear));
    }
    return has_actuator;
  }

  void set_forcerange(std::size_t actuator, double force) {
    if (elements_[actuator].value("forcelimited") == "false") {
      return report(actuator,
                    "forcelimited is \"false\": a forcerange would change what the file "
                    "means to say");
    }
    const std::string range = digits(force);
    std::vector<std::pair<std::string, std::string>> values{
        {"forcerange", "-" + range + " " + range}};
    if (!has_autolimits()) values.emplace_back("forcelimited", "true");
    set_all(actuator, values);
  }

  /// Where limits hold without a word: unless the compiler says otherwise.
  bool has_autolimits() const {
    return std::none_of(elements_.begin(), elements_.end(), [](const SourceElement& each) {
      return each.name == "compiler" && each.value("autolimits") == "false";
    });
  }

  /// The first number of gear, which the force passes through. A fault where a default states it.
  std::optional<double> gear_of(std::size_t actuator) {
    const std::string stated = elements_[actuator].value("gear");
    if (stated.empty()) {
      for (std::size_t i = 1; i < elements_.size(); ++i) {
        const bool is_default = is_below(i, "default") && elements_[i].find("gear") != nullptr;
        if (!is_default) continue;
        report(actuator,
               fmt::format("its gear stands among the defaults, at line {}: state it here",
                           line_of(text_, elements_[i].begin)));
        return std::nullopt;
      }
      return 1.0;
    }
    double gear = 0.0;
    const std::size_t begin = std::min(stated.find_first_not_of(" \t\r\n"), stated.size());
    const auto [rest, error] =
        std::from_chars(stated.data() + begin, stated.data() + stated.size(), gear);
    if (error == std::errc() && std::isfinite(gear) && gear != 0.0) return gear;
    report(actuator, fmt::format("gear \"{}\" does not begin with a number other than 0", stated));
    return std::nullopt;
  }

  void note(const std::string& sentence) {
    const auto& notes = result_.notes;
    if (std::find(notes.begin(), notes.end(), sentence) != notes.end()) return;
    result_.notes.push_back(sentence);
  }

  const std::string& file_;
  const std::string& text_;
  const std::vector<PatchedDrive>& drives_;
  std::vector<SourceElement> elements_;
  bool is_urdf_ = false;
  std::vector<std::pair<std::string, std::size_t>> joints_;  ///< Names and elements.
  std::vector<TextEdit> edits_;
  std::vector<io::Fault> faults_;
  PatchedFile result_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  lines.push_back(text.substr(begin));
  return lines;
}

}  // namespace

DriveNumbers drive_numbers(const actuator::Actuator& document, const std::string& file) {
  using namespace actuator;
  if (Region(document, {}).at(0.0).is_empty) {
    io::refuse(file, "no torque is possible at rest: there is none to write");
  }
  DriveNumbers numbers;
  const bool is_in_joint = !document.effects.empty() && !locks_itself(document);
  const Actuator alone = is_in_joint ? without_friction(document) : document;
  const Region region(alone, {});
  const DrivingFigures figures = driving_figures(region);
  numbers.torque_Nm = figures.stall_torque_Nm;
  numbers.speed_rad_s = figures.no_load_speed_rad_s;
  const Transmission& gear = document.transmission;
  numbers.armature_kg_m2 =
      gear.ratio * gear.ratio * document.motor.rotor_inertia_kg_m2 + gear.inertia_kg_m2;
  if (!is_in_joint) return numbers;
  const JointFriction friction =
      joint_friction(document, winding_temperature_K(document, {}), region.greatest_speed_rad_s());
  if (friction != JointFriction{}) numbers.friction = friction;
  return numbers;
}

PatchedFile patched_file(const std::string& file, const std::string& text,
                         const std::vector<PatchedDrive>& drives) {
  return Patch(file, text, drives).run();
}

std::string line_difference(const std::string& before, const std::string& after) {
  const std::vector<std::string> old_lines = lines_of(before), new_lines = lines_of(after);
  std::string text;
  std::size_t i = 0;
  for (std::size_t j = 0; j < new_lines.size(); ++j) {
    if (i < old_lines.size() && old_lines[i] == new_lines[j]) {
      ++i;
      continue;
    }
    // A line that is put in leaves the next one where it was.
    const bool is_new =
        i >= old_lines.size() || (j + 1 < new_lines.size() && new_lines[j + 1] == old_lines[i]);
    if (!is_new) {
      text += fmt::format("{} - {}\n", i + 1, old_lines[i]);
      ++i;
    }
    text += fmt::format("{} + {}\n", j + 1, new_lines[j]);
  }
  return text;
}

}  // namespace torquewright::hopper
