// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_calibrate_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/given_once.hpp"
#include "robot/model/whole_body.hpp"
#include "src/commands/robot/hopper_calibrate_json.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

namespace calibration = hopper::calibration;

constexpr const char* kTargetForm = "must be cam=N, cav=N:N (takeoff and tuck) or cav@POSTURE=N";
constexpr const char* kPostureForm = "must be NAME=JOINT:POSITION,JOINT:POSITION,...";

std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts{""};
  for (const char letter : text) {
    if (letter == mark) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

double number_in(const std::string& text, const std::string& option, const std::string& whole,
                 const char* form) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || !std::isfinite(number)) {
    io::refuse(option, fmt::format("\"{}\" {}", whole, form));
  }
  return number;
}

/// A published magnitude; a zero or negative one is none.
double figure_in(const std::string& text, const std::string& whole) {
  const double figure = number_in(text, "--target", whole, kTargetForm);
  if (figure >= 1e-6 && figure <= 1e6) return figure;
  io::refuse("--target", fmt::format("{} in \"{}\" must be from 1e-06 to 1e+06", figure, whole));
}

std::size_t posture_named(const std::string& name, const hopper::Robot& robot) {
  std::string known;
  for (std::size_t i = 0; i < robot.postures.size(); ++i) {
    if (robot.postures[i].name == name) return i;
    known += (known.empty() ? "" : ", ") + robot.postures[i].name;
  }
  io::refuse("--target",
             fmt::format("the robot has no posture \"{}\"{}; --posture {}=JOINT:POSITION,"
                         "... gives it one",
                         name, known.empty() ? "" : " (it has: " + known + ")", name));
}

void add_speed(const std::string& posture, double speed_rad_s, const hopper::Robot& robot,
               calibration::Figures& figures) {
  const std::size_t index = posture_named(posture, robot);
  for (const calibration::SpeedTarget& known : figures.speeds) {
    if (known.posture != index) continue;
    io::refuse("--target", fmt::format("CAV at {} is given twice", posture));
  }
  figures.speeds.push_back({index, speed_rad_s});
}

void read_target(const std::string& text, const hopper::Robot& robot,
                 calibration::Figures& figures) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
  if (name == "cam") {
    if (figures.angular_momentum_Nm_s != 0.0) io::refuse("--target", "CAM is given twice");
    figures.angular_momentum_Nm_s = figure_in(value, text);
  } else if (name == "cav") {
    const std::vector<std::string> speeds = split(value, ':');
    if (speeds.size() != 2) io::refuse("--target", fmt::format("\"{}\" {}", text, kTargetForm));
    add_speed("takeoff", figure_in(speeds[0], text), robot, figures);
    add_speed("tuck", figure_in(speeds[1], text), robot, figures);
  } else if (name.starts_with("cav@")) {
    add_speed(name.substr(4), figure_in(value, text), robot, figures);
  } else {
    io::refuse("--target", fmt::format("\"{}\" {}", text, kTargetForm));
  }
}

void check_twice(const calibration::FreeValue& value,
                 const std::vector<calibration::FreeValue>& known) {
  for (const calibration::FreeValue& other : known) {
    for (const std::string& pointer : value.pointers) {
      if (std::find(other.pointers.begin(), other.pointers.end(), pointer) ==
          other.pointers.end()) {
        continue;
      }
      io::refuse("--free", fmt::format("{} stands twice", pointer));
    }
  }
}

StatedPosture posture_in(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    io::refuse("--posture", fmt::format("\"{}\" {}", text, kPostureForm));
  }
  StatedPosture posture{text.substr(0, equals), {}};
  const std::vector<std::string> parts = split(text.substr(equals + 1), ',');
  io::require_each_once("--posture", parts, ':');
  for (const std::string& part : parts) {
    const std::size_t colon = part.rfind(':');
    if (colon == std::string::npos || colon == 0) {
      io::refuse("--posture", fmt::format("\"{}\" {}", text, kPostureForm));
    }
    posture.positions[part.substr(0, colon)] =
        number_in(part.substr(colon + 1), "--posture", text, kPostureForm);
  }
  return posture;
}

/// A posture at which nothing was published changes nothing.
void require_used(const std::vector<std::string>& postures, const hopper::Robot& robot,
                  const calibration::Figures& figures) {
  for (const std::string& text : postures) {
    const std::string name = text.substr(0, text.find('='));
    const bool is_used = std::any_of(figures.speeds.begin(), figures.speeds.end(),
                                     [&](const calibration::SpeedTarget& target) {
                                       return robot.postures[target.posture].name == name;
                                     });
    if (is_used) continue;
    io::refuse("--posture", fmt::format("no --target is at \"{0}\"; cav@{0}=N states one", name));
  }
}

hopper::ReadRobot robot_with_postures(const CalibrationRequest& request) {
  io::require_each_once("--posture", request.postures);
  io::Document document = io::read_document(request.robot_file, "robot");
  for (const std::string& text : request.postures) add_posture(posture_in(text), document.root);
  const std::string sha256 = document.sha256;
  hopper::ReadRobot read =
      hopper::robot_of(io::check_document(document.root, "robot", document.file, document.path));
  read.documents.front().sha256 = sha256;  // of the file that was read
  return read;
}

void check_calibration_files(const CalibrationRequest& request, const hopper::ReadRobot& read) {
  std::vector<std::filesystem::path> outputs;
  for (const std::string& file : {request.output_file, request.refined_file, request.plot_file}) {
    if (!file.empty()) outputs.push_back(file);
  }
  std::vector<std::filesystem::path> inputs;
  for (const io::Document& document : read.documents) inputs.push_back(document.file);
  check_written(outputs, inputs);
  if (request.plot_file.empty()) return;
  (void)report::plot_format(request.plot_file);
  report::require_gnuplot("--plot");
}

calibration::Question question_of(const CalibrationRequest& request, const io::Document& document,
                                  const hopper::Robot& robot) {
  if (robot.tree.base == dynamics::BaseKind::kFixed) {
    throw io::SpecError({{document.file, "/base/motion",
                          "\"fixed\": angular momentum (CAM) is conserved in flight, and a fixed "
                          "base does not fly"}});
  }
  calibration::Question question;
  question.tree = robot.tree;
  question.postures = robot.postures;
  if (!hopper::WholeBody(robot).links().empty()) question.with_links = robot;
  question.figures.tolerance = request.tolerance;
  for (const std::string& target : request.targets) read_target(target, robot, question.figures);
  if (question.figures.angular_momentum_Nm_s == 0.0) {
    io::refuse("--target",
               "states no CAM (angular momentum about the centre of mass): cam=N in N m s");
  }
  if (question.figures.speeds.empty()) {
    io::refuse("--target",
               "states no CAV (mean angular velocity): cav=N:N or cav@POSTURE=N in rad/s");
  }
  require_used(request.postures, robot, question.figures);
  for (const std::string& text : request.free) {
    calibration::FreeValue value = calibration::free_value(text, document, robot);
    check_twice(value, question.free);
    question.free.push_back(std::move(value));
  }
  return question;
}

}  // namespace

CalibrationInputs read_inputs(const CalibrationRequest& request) {
  CalibrationInputs inputs;
  inputs.robot = robot_with_postures(request);
  check_calibration_files(request, inputs.robot);
  inputs.question = question_of(request, inputs.robot.documents.front(), inputs.robot.robot);
  return inputs;
}

}  // namespace torquewright::cli
