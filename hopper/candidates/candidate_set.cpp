// SPDX-License-Identifier: Apache-2.0
#include "hopper/candidates/candidate_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/catalogue/drive_set.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "actuator/motor/gear_transmission.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/one_line.hpp"
#include "io/text/stepped_range.hpp"

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRatios = 1000;
/// Beyond what is built on either side.
constexpr double kLeastRatio = 0.01, kGreatestRatio = 1e4;

std::vector<fs::path> documents_in(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) io::refuse(folder.string(), "is no folder");
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (error) io::refuse_unreadable(folder.string(), error.value());
  std::sort(files.begin(), files.end());
  return files;
}

bool is_gearbox(const io::Document& document) {
  const std::string kind = document.root["kind"];
  return kind == "gearbox" || kind == "gearbox_result";
}

/// A constant that was measured behind one gearbox says nothing of the motor behind another: the
/// gears' losses are in it.
void refuse_constants_of_joint(const io::Document& document, const fs::path& gearbox) {
  if (!document.root.contains("motor")) {
    io::refuse(gearbox.string(), fmt::format("not put behind {}, which is known by a curve: no "
                                             "motor is known that gears could be put on",
                                             document.file));
  }
  for (const auto& [key, value] : document.root["motor"].items()) {
    if (!value.is_object() || value.value("side", "") != "joint") continue;
    io::refuse(gearbox.string(),
               fmt::format("not put behind the motor of {}, whose /motor/{} is stated at the joint "
                           "of its own gearbox; state it at the motor",
                           document.file, key));
  }
}

/// Nor does a torque at the joint say which current gave it, once another gearbox stands between.
void refuse_torques_for_currents(const io::Document& document, const fs::path& gearbox) {
  for (const char* key : {"peak_torque_Nm", "continuous_torque_Nm"}) {
    if (!document.root.contains("drive") || !document.root["drive"].contains(key)) continue;
    io::refuse(gearbox.string(),
               fmt::format("not put behind the motor of {}, whose /drive/{} is stated at the joint "
                           "of its own gearbox; state the current",
                           document.file, key));
  }
}

/// The drivetrain's own actuator behind another gearbox.
actuator::ReadActuator behind(const ReadRobot& robot, const Drivetrain& drivetrain,
                              const fs::path& gearbox) {
  const std::string wanted = fs::path(drivetrain.actuator_files.front()).filename().string();
  for (const io::Document& document : robot.documents) {
    if (document.root.value("kind", "") != "actuator") continue;
    if (fs::path(document.file).filename().string() != wanted) continue;
    refuse_constants_of_joint(document, gearbox);
    refuse_torques_for_currents(document, gearbox);
    io::Document changed = document;
    changed.root["gearbox"] = {{"file", fs::absolute(gearbox).string()}};
    actuator::ReadActuator read = actuator::read_actuator(std::move(changed));
    actuator::carry_joint_rating(drivetrain.actuators.front().transmission, read.actuator);
    return read;
  }
  io::refuse(gearbox.string(), "found no motor to put it behind");
}

void add(const Candidate& candidate, const std::optional<RatioSweep>& sweep,
         std::vector<Candidate>& candidates) {
  if (!sweep) {
    candidates.push_back(candidate);
    return;
  }
  for (const double ratio : sweep->ratios()) {
    Candidate& changed = candidates.emplace_back(candidate);
    changed.name = fmt::format("{} {:g}:1", candidate.name, ratio);
    actuator::Transmission& gear = changed.actuator.transmission;
    gear.ratio = std::copysign(ratio, gear.ratio);
    actuator::carry_joint_rating(candidate.actuator.transmission, changed.actuator);
  }
}

CandidateSet none_yet(const ReadRobot& robot) {
  if (robot.robot.drivetrains.empty()) {
    io::refuse("--candidates", "the robot states no mechanisms whose actuators could be replaced");
  }
  CandidateSet candidates;
  candidates.by_drivetrain.resize(robot.robot.drivetrains.size());
  return candidates;
}

}  // namespace

std::vector<double> RatioSweep::ratios() const {
  std::vector<double> all;
  for (const io::Rational& ratio :
       io::values_of({io::exact(from), io::exact(to), io::exact(step)})) {
    all.push_back(io::nearest(ratio));
  }
  return all;
}

RatioSweep read_ratio_sweep(const std::string& text) {
  const io::RangeRule rule{
      .refuse =
          [&text](const std::string& why) {
            io::refuse("--ratios",
                       fmt::format("\"{}\": {}; the form is FROM:TO or FROM:TO:STEP", text, why));
          },
      .most = kMostRatios,
      .what = "ratios",
      .least = kLeastRatio,
      .greatest = kGreatestRatio};
  const io::SteppedRange range = io::read_stepped_range(text, rule);
  return {io::nearest(range.from), io::nearest(range.to), io::nearest(range.step)};
}

CandidateSet read_candidate_set(const fs::path& folder, const ReadRobot& robot,
                                const std::optional<RatioSweep>& sweep) {
  CandidateSet candidates = none_yet(robot);
  for (const fs::path& file : documents_in(folder)) {
    const std::string name = io::stem_in_text(file);
    try {
      io::Document document = io::read_document(file, {"actuator", "gearbox", "gearbox_result"});
      candidates.documents.push_back(document);
      const bool gears = is_gearbox(document);
      std::optional<actuator::ReadActuator> whole;
      if (!gears) whole = actuator::read_actuator(std::move(document));
      for (std::size_t i = 0; i < candidates.by_drivetrain.size(); ++i) {
        const actuator::ReadActuator read =
            gears ? behind(robot, robot.robot.drivetrains[i], file) : *whole;
        add({name, read.actuator}, sweep, candidates.by_drivetrain[i]);
      }
    } catch (const io::SpecError& error) {
      candidates.left_out.push_back(fmt::format("{}: {}", name, error.faults().front().message));
    }
  }
  const bool is_bare = std::all_of(candidates.by_drivetrain.begin(), candidates.by_drivetrain.end(),
                                   [](const auto& some) { return some.empty(); });
  if (is_bare) io::refuse(folder.string(), "holds no actuator and no gearbox");
  return candidates;
}

CandidateSet catalogue_candidates(const ReadRobot& robot, const std::optional<RatioSweep>& sweep) {
  CandidateSet candidates = none_yet(robot);
  actuator::DriveSet shelf = actuator::catalogue();
  for (std::vector<Candidate>& some : candidates.by_drivetrain) {
    for (const actuator::NamedActuator& drive : shelf.drives) {
      add({drive.stem, drive.actuator}, sweep, some);
    }
  }
  candidates.documents = std::move(shelf.documents);
  candidates.left_out = std::move(shelf.left_out);
  return candidates;
}

}  // namespace torquewright::hopper
