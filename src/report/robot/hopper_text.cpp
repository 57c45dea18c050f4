// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/hopper_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/text/number_text.hpp"
#include "io/text/one_line.hpp"
#include "io/text/time_text.hpp"
#include "src/report/actuator/check_text.hpp"
#include "src/report/robot/gear_words.hpp"

namespace torquewright::report {
namespace {

using namespace hopper;

/// Of what is computed in units of SI for a robot: what is below its twelfth digit is rounding.
constexpr double kOne = 1.0;

std::string motion_lines(const Robot& robot, const Motion& motion, const HopperReport& report) {
  std::string text = fmt::format("  robot    {}, {:.4g} s of motion in {} samples\n", robot.name,
                                 motion.duration_s(), motion.samples());
  if (!report.demand.has_dynamics) return text;
  const BaseResidual& residual = report.base_residual;
  if (residual.force.limit > 0.0 && robot.tree.base != dynamics::BaseKind::kFixed) {
    text += fmt::format(
        "  physics  {:.3g} N and {:.3g} Nm at most are left unexplained over {:g} ms (limits "
        "{:.3g} N, {:.3g} Nm)\n",
        io::known(residual.force.mean, residual.force.limit),
        io::known(residual.moment.mean, residual.moment.limit), 1e3 * residual.window_s,
        residual.force.limit, residual.moment.limit);
  }
  for (const Flight& flight : report.flights) {
    text += fmt::format(
        "  flight   {} to {} s, {:.3g} m up; angular momentum {:.4g} Nm s (drift {:.1g}); turns at "
        "{:.4g} rad/s at take-off, {:.4g} at most, {:.4g} at the end\n",
        io::time_text(flight.from_s, 4), io::time_text(flight.until_s, 4), flight.rise_m,
        io::known(flight.angular_momentum_Nm_s, kOne),
        io::known(flight.angular_momentum_drift_Nm_s, kOne), io::known(flight.take_off_rad_s, kOne),
        io::known(flight.peak_rad_s, kOne), io::known(flight.touch_down_rad_s, kOne));
  }
  for (const Jolt& jolt : report.demand.jolts) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i + 2 < jolt.impulses_N_s.size(); i += 3) {
      sum += jolt.impulses_N_s.segment<3>(i);
    }
    const auto known = [&sum](double part) { return io::known(part, sum.norm()); };
    text += fmt::format("  impact   t = {} s: impulse ({:.3g}, {:.3g}, {:.3g}) N s, {:.3g} J {}\n",
                        io::time_text(jolt.time_s, 4), known(sum.x()), known(sum.y()),
                        known(sum.z()), std::abs(io::known(jolt.lost_energy_J, kOne)),
                        jolt.lost_energy_J < 0.0 ? "gained" : "lost");
  }
  return text;
}

std::string load_lines(const HopperReport& report, std::size_t drive) {
  const TransmissionLoad& load = report.transmission_loads[drive];
  std::string text =
      fmt::format("  gears    {}\n", gear_words(load, io::time_text(load.judged().time_s)));
  if (load.rotor_Nm_s > 0.0) {
    text += fmt::format("           {:.3g} Nm s for the rotor in the impact at t = {} s\n",
                        load.rotor_Nm_s, io::time_text(load.impact_time_s));
  }
  if (drive >= report.contact_loads.size()) return text;
  const ContactLoad& contact = report.contact_loads[drive];
  return text + fmt::format(
                    "  contacts ask for {:.4g} Nm at the joint, {:.4g} Nm at the motor (from t = "
                    "{} s), most of it past the gears\n",
                    contact.joint_Nm, contact.motor_Nm, io::time_text(contact.time_s));
}

std::string or_unknown(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

std::string energy_text(const std::optional<double>& value_J) {
  return value_J ? fmt::format("{:.1f}", *value_J) : "-";
}

std::string passing_line(const CandidateResult& result) {
  return fmt::format("  {} {:<30} {:>8.1f} {:>8} {:>8} {:>9} {:>9} {:>8.3g}\n",
                     result.is_on_front ? "*" : " ", result.name, 100.0 * result.margin_share,
                     or_unknown(result.speed_margin_rad_s), or_unknown(result.mass_kg),
                     energy_text(result.energy_J), energy_text(result.copper_loss_J),
                     result.peak_torque_Nm);
}

}  // namespace

std::string candidates_text(const Robot& robot, const std::vector<CandidateResult>& results) {
  std::string text;
  const bool by_file = std::any_of(results.begin(), results.end(), [](const auto& result) {
    return result.torques == CandidateTorques::kExchangedFile;
  });
  if (by_file) {
    text +=
        "\ncandidates' torques are the file's, with what the old rotor (and mass) takes exchanged "
        "for what each candidate's does\n";
  }
  for (std::size_t drivetrain = 0; drivetrain < robot.drivetrains.size(); ++drivetrain) {
    const auto& names = robot.drivetrains[drivetrain].actuator_names;
    text += fmt::format(
        "\ncandidates for {}, by torque margin over torque at rest (* on the front of margin, "
        "mass, energy and heat)\n    {:<30} {:>8} {:>8} {:>8} {:>9} {:>9} {:>8}\n",
        fmt::join(names, ", "), "", "margin %", "rad/s", "kg", "energy J", "copper J", "peak Nm");
    std::string failing;
    for (const CandidateResult& result : results) {
      if (result.drivetrain != drivetrain) continue;
      if (result.verdict == actuator::Verdict::kPass) {
        text += passing_line(result);
      } else {
        failing +=
            fmt::format("  {} {:<30} {}\n", result.verdict == actuator::Verdict::kFail ? "x" : "?",
                        result.name, result.why);
      }
    }
    text += failing;
  }
  return text;
}

std::string motion_text(const Robot& robot, const Motion& motion, const HopperReport& report) {
  return fmt::format("{}: {}\n", io::name_in_text(motion.file),
                     actuator::name_of(report.check.verdict)) +
         motion_lines(robot, motion, report);
}

std::string hopper_text(const Robot& robot, const Motion& motion, const HopperReport& report,
                        actuator::Severity least) {
  std::string text = motion_text(robot, motion, report);
  for (std::size_t i = 0; i < report.check.drives.size(); ++i) {
    text += drive_text(report.check.drives[i]);
    if (i < report.transmission_loads.size()) text += load_lines(report, i);
  }
  return text + "\n" + findings_text(report.check, least);
}

}  // namespace torquewright::report
