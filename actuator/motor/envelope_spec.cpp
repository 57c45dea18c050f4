// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/envelope_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "actuator/motor/statement_spec.hpp"
#include "io/columns/quantity_column.hpp"
#include "io/files/csv.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;
using Points = std::vector<EnvelopePoint>;

/// A bound ends here at once, not over a stretch: a share of the speed.
constexpr double kAtOnce = 1e-9;

/// What a drive does at one sign of torque: with the motion and against it, over speeds from 0 on.
struct Quadrants {
  Points driving;
  Points braking;  ///< Torques in size.
};

Points mirrored(Points points) {
  for (EnvelopePoint& point : points) point = {-point.speed_rad_s, point.torque_Nm};
  std::reverse(points.begin(), points.end());
  return points;
}

Points negated(Points points) {
  for (EnvelopePoint& point : points) point.torque_Nm = -point.torque_Nm;
  return points;
}

/// The greatest torque over all speeds.
Points bound_of(const Quadrants& quadrants) {
  Points bound = mirrored(quadrants.braking);
  for (const EnvelopePoint& point : quadrants.driving) {
    const bool stands_already = !bound.empty() && bound.back() == point;
    if (!stands_already) bound.push_back(point);
  }
  return bound;
}

/// By what it does at torques above 0 and, turned round, below.
EnvelopeCurve curve_of(const Quadrants& forward, const Quadrants& backward) {
  return {bound_of(forward), negated(mirrored(bound_of(backward)))};
}

/// The bound's quadrants, as far as its points say them: with rest, and one point more.
Quadrants quadrants_of(Points bound) {
  const auto beyond = std::find_if(bound.begin(), bound.end(), [](const EnvelopePoint& point) {
    return point.speed_rad_s >= 0.0;
  });
  if (beyond != bound.begin() && beyond != bound.end() && beyond->speed_rad_s > 0.0) {
    const EnvelopePoint before = *(beyond - 1);
    const double share = before.speed_rad_s / (before.speed_rad_s - beyond->speed_rad_s);
    bound.insert(beyond, {0.0, std::lerp(before.torque_Nm, beyond->torque_Nm, share)});
  }
  Quadrants quadrants;
  for (const EnvelopePoint& point : bound) {
    if (point.speed_rad_s >= 0.0) quadrants.driving.push_back(point);
    if (point.speed_rad_s <= 0.0) quadrants.braking.push_back(point);
  }
  quadrants.braking = mirrored(quadrants.braking);
  if (quadrants.driving.size() < 2) quadrants.driving.clear();
  if (quadrants.braking.size() < 2) quadrants.braking.clear();
  return quadrants;
}

/// No torque is above it.
Points cut_at(const Points& points, double torque_Nm) {
  Points result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && (points[i - 1].torque_Nm > torque_Nm) != (points[i].torque_Nm > torque_Nm)) {
      const EnvelopePoint& before = points[i - 1];
      const double share =
          (torque_Nm - before.torque_Nm) / (points[i].torque_Nm - before.torque_Nm);
      result.push_back({std::lerp(before.speed_rad_s, points[i].speed_rad_s, share), torque_Nm});
    }
    result.push_back({points[i].speed_rad_s, std::min(points[i].torque_Nm, torque_Nm)});
  }
  const auto same = [](const EnvelopePoint& one, const EnvelopePoint& other) {
    return one == other;
  };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

/// What points without their mirror images say, which points of the other quadrants may follow.
struct Rows {
  Points points;
  std::vector<std::string> places;  ///< For messages.
};

class EnvelopeReader {
 public:
  EnvelopeReader(const io::Document& document, Actuator& actuator,
                 std::vector<io::Document>& documents, std::vector<io::Fault>& faults)
      : document_(document),
        keys_(document.root["envelope"]),
        actuator_(actuator),
        documents_(documents),
        faults_(faults) {}

  void read() {
    Envelope envelope;
    const bool at_joint = keys_.value("side", "joint") == "joint";
    envelope.ratio = at_joint ? actuator_.transmission.ratio : 1.0;
    envelope.includes_losses = at_joint && keys_.value("losses", "included") == "included";
    if (!at_joint && keys_.value("losses", "") == "included") {
      report("/losses", "a curve of the motor's shaft holds no losses of the gear");
    }
    if (keys_.contains("voltage_V")) envelope.voltage_V = keys_["voltage_V"].get<double>();
    refuse_what_needs_a_winding();
    if (keys_.contains("points")) {
      read_points(envelope);
    } else {
      read_numbers(envelope);
    }
    if (faults_.empty()) limit_continuous(envelope);
    if (!faults_.empty()) return;
    const double inertia = find("reflected_inertia_kg_m2").value_or(0.0);
    const double ratio = actuator_.transmission.ratio;
    actuator_.motor.rotor_inertia_kg_m2 = inertia / (ratio * ratio);
    be_without_winding(envelope);
    actuator_.envelope = std::move(envelope);
  }

 private:
  void report(const std::string& path, std::string message) {
    faults_.push_back({document_.file, document_.path + "/envelope" + path, std::move(message)});
  }

  std::optional<double> find(const char* key) {
    if (!keys_.contains(key)) return std::nullopt;
    return read_stated(keys_[key], std::string("/envelope/") + key, actuator_.statements);
  }

  /// Currents of such a drive are torques of its rotor.
  void be_without_winding(const Envelope& envelope) {
    Motor& motor = actuator_.motor;
    motor.torque_constant_Nm_A = 1.0;
    motor.torque_constant_convention = CurrentConvention::kPeakPhase;
    motor.back_emf_constant_V_s_rad = 0.0;
    motor.resistance_ohm = 0.0;
    actuator_.drive.bus_voltage_V = envelope.voltage_V.value_or(1.0);
    actuator_.drive.peak_current_A =
        greatest_torque_Nm(envelope.peak) / std::abs(actuator_.transmission.ratio);
  }

  void refuse_what_needs_a_winding() {
    for (const char* block : {"motor", "drive", "battery", "thermal"}) {
      if (!document_.root.contains(block)) continue;
      faults_.push_back({document_.file, fmt::format("{}/{}", document_.path, block),
                         fmt::format("stands beside an envelope, which takes the place of motor "
                                     "and drive: state either the curve or the winding{}",
                                     std::string_view(block) == "motor" ? "" : " (/motor)")});
    }
    for (std::size_t i = 0; i < actuator_.effects.size(); ++i) {
      const EffectKind& kind = *actuator_.effects[i].kind;
      switch (kind.acts) {
        case Acts::kTorqueFactor:
        case Acts::kFluxFactor:
        case Acts::kResistanceFactor:
        case Acts::kWindingVoltage:
        case Acts::kBusVoltage:
          faults_.push_back({document_.file, fmt::format("{}/effects/{}", document_.path, i),
                             fmt::format("{} acts on a winding, of which an envelope says nothing: "
                                         "state /motor and /drive in its place",
                                         kind.name)});
          break;
        default:
          break;
      }
    }
  }

  void read_numbers(Envelope& envelope) {
    const std::optional<double> peak_Nm = find("peak_torque_Nm");
    const std::optional<double> no_load = find("no_load_speed_rad_s");
    const std::optional<double> fastest = find("maximum_speed_rad_s");
    const std::optional<double> corner = find("corner_speed_rad_s");
    if (!peak_Nm) {
      report("/peak_torque_Nm", "missing; or state the curve as \"points\"");
      return;
    }
    if (!no_load && !fastest) {
      report("/no_load_speed_rad_s",
             "missing; torque ends there. Or state maximum_speed_rad_s, up to which there is full "
             "torque, or the curve as \"points\"");
      return;
    }
    const double corner_Nm = find("corner_torque_Nm").value_or(*peak_Nm);
    if (!check_numbers(*peak_Nm, corner_Nm, no_load, fastest, corner)) return;
    Quadrants quadrants;
    quadrants.driving = driving_curve(*peak_Nm, corner_Nm, no_load, fastest, corner);
    quadrants.braking = quadrants.driving;
    envelope.braking = Braking::kAsDriving;
    if (const std::optional<double> braking_Nm = find("braking_torque_Nm")) {
      envelope.braking = Braking::kStated;
      quadrants.braking = braking_curve(*braking_Nm, quadrants.driving.back().speed_rad_s, corner);
    }
    envelope.peak = curve_of(quadrants, quadrants);
  }

  bool check_numbers(double peak_Nm, double corner_Nm, std::optional<double> no_load,
                     std::optional<double> fastest, std::optional<double> corner) {
    if (keys_.contains("corner_torque_Nm") && !corner) {
      report("/corner_speed_rad_s", "missing; the corner's torque needs it");
    }
    if (corner && !no_load) {
      report("/no_load_speed_rad_s", "missing; from the corner on torque falls to nothing there");
    }
    if (corner && no_load && *corner >= *no_load) {
      report("/corner_speed_rad_s", fmt::format("{} rad/s is not below /envelope/"
                                                "no_load_speed_rad_s, {} rad/s",
                                                *corner, *no_load));
    }
    if (corner_Nm > peak_Nm) {
      report("/corner_torque_Nm",
             fmt::format("{} Nm is above /envelope/peak_torque_Nm, {} Nm", corner_Nm, peak_Nm));
    }
    if (fastest && no_load && *fastest > *no_load) {
      report("/maximum_speed_rad_s",
             fmt::format("{} rad/s is above /envelope/no_load_speed_rad_s, {} rad/s, where torque "
                         "ends",
                         *fastest, *no_load));
    }
    return faults_.empty();
  }

  static Points driving_curve(double peak_Nm, double corner_Nm, std::optional<double> no_load,
                              std::optional<double> fastest, std::optional<double> corner) {
    Points points{{0.0, peak_Nm}};
    if (corner) points.push_back({*corner, corner_Nm});
    if (no_load) points.push_back({*no_load, 0.0});
    if (!fastest) return points;
    if (!no_load) points.push_back({*fastest, peak_Nm});
    // Full torque up to there and none beyond.
    while (points.size() > 1 && points[points.size() - 2].speed_rad_s >= *fastest) {
      points.pop_back();
    }
    const EnvelopePoint last = points.back();
    const EnvelopePoint before = points[points.size() - 2];
    const double share = (*fastest - before.speed_rad_s) / (last.speed_rad_s - before.speed_rad_s);
    points.back() = {*fastest, std::lerp(before.torque_Nm, last.torque_Nm, share)};
    points.push_back({*fastest * (1.0 + kAtOnce), 0.0});
    return points;
  }

  /// A corner is one of the voltage, which ends what brakes as well (the law of Unitree's sheets).
  static Points braking_curve(double braking_Nm, double end_rad_s, std::optional<double> corner) {
    if (!corner) return {{0.0, braking_Nm}, {end_rad_s, braking_Nm}};
    return {{0.0, braking_Nm}, {*corner, braking_Nm}, {end_rad_s, 0.0}};
  }

  void read_points(Envelope& envelope) {
    for (const char* key : {"peak_torque_Nm", "no_load_speed_rad_s", "maximum_speed_rad_s",
                            "corner_speed_rad_s", "corner_torque_Nm", "braking_torque_Nm"}) {
      if (keys_.contains(key)) {
        report(std::string("/") + key, "stands beside \"points\", which say it already");
      }
    }
    const std::optional<Rows> peak = rows_of("points");
    if (peak) {
      if (const auto curve = curve_of_rows(*peak)) envelope.peak = *curve;
      const auto brakes = [](const EnvelopePoint& point) {
        return point.torque_Nm * point.speed_rad_s < 0.0;
      };
      const bool is_stated = std::any_of(peak->points.begin(), peak->points.end(), brakes);
      envelope.braking = is_stated ? Braking::kStated : Braking::kAsDriving;
    }
    if (!keys_.contains("continuous_points")) return;
    const std::optional<Rows> continuous = rows_of("continuous_points");
    if (continuous) envelope.continuous = curve_of_rows(*continuous);
  }

  std::optional<Rows> rows_of(const char* key) {
    if (keys_[key].is_string()) return rows_of_file(key, keys_[key].get<std::string>());
    Rows rows;
    for (std::size_t i = 0; i < keys_[key].size(); ++i) {
      const json& point = keys_[key][i];
      rows.points.push_back({point["speed_rad_s"], point["torque_Nm"]});
      rows.places.push_back(fmt::format("/{}/{}", key, i));
    }
    return rows;
  }

  std::optional<Rows> rows_of_file(const char* key, const std::string& name) {
    const std::filesystem::path file = std::filesystem::path(document_.file).parent_path() / name;
    try {
      io::CsvReader csv(file, io::CsvReader::CutEnd::kRefused, io::CsvReader::UnitsRow::kTaken);
      const auto speed = io::quantity_column(csv, "speed", io::Dimension::kAngularVelocity);
      const auto torque = io::quantity_column(csv, "torque", io::Dimension::kTorque);
      Rows rows;
      while (csv.next()) {
        rows.points.push_back(
            {csv.number(speed.column) * speed.in_SI, csv.number(torque.column) * torque.in_SI});
        rows.places.push_back(fmt::format("/{} (line {} of {})", key, csv.line(), name));
      }
      documents_.push_back({csv.file(), "", {}, csv.sha256()});
      return rows;
    } catch (const io::SpecError& error) {
      faults_.insert(faults_.end(), error.faults().begin(), error.faults().end());
      return std::nullopt;
    }
  }

  /// Points of one sign of torque over one stretch of speeds; other quadrants by their mirrors.
  std::optional<EnvelopeCurve> curve_of_rows(const Rows& rows) {
    const auto is_end = [](const EnvelopePoint& point) { return point.torque_Nm == 0.0; };
    Points greatest, least;
    for (std::size_t i = 0; i < rows.points.size(); ++i) {
      const EnvelopePoint& point = rows.points[i];
      const bool is_greatest =
          point.torque_Nm > 0.0 || (point.torque_Nm == 0.0 && point.speed_rad_s >= 0.0);
      Points& bound = is_greatest ? greatest : least;
      if (!bound.empty() && point.speed_rad_s <= bound.back().speed_rad_s) {
        report(rows.places[i],
               fmt::format("{} rad/s after {} rad/s: torque must be a function of the speed, and "
                           "speeds of one sign of torque ascend",
                           point.speed_rad_s, bound.back().speed_rad_s));
        return std::nullopt;
      }
      bound.push_back(point);
    }
    const bool ends_greatest = !least.empty() && !greatest.empty() &&
                               std::all_of(least.begin(), least.end(), is_end) &&
                               least.back().speed_rad_s < greatest.front().speed_rad_s;
    if (ends_greatest) {
      greatest.insert(greatest.begin(), least.begin(), least.end());
      least.clear();
    }
    if (greatest.size() < 2 || least.size() == 1) {
      report("/points", fmt::format("{} of them have torque {} 0; a bound needs two or more",
                                    greatest.size() < 2 ? greatest.size() : least.size(),
                                    greatest.size() < 2 ? "above" : "below"));
      return std::nullopt;
    }
    for (const Points* bound : {&greatest, &least}) {
      if (bound->empty() || bound->front().speed_rad_s <= 0.0) continue;
      report("/points",
             fmt::format("they say nothing of rest: the first speed is {} rad/s; it must "
                         "be 0 or below",
                         bound->front().speed_rad_s));
      return std::nullopt;
    }
    const EnvelopeCurve curve = completed(std::move(greatest), least);
    return is_region(curve) ? std::optional(curve) : std::nullopt;
  }

  /// With the quadrants that no point names: a drive is the same both ways round, and brakes as it
  /// drives.
  static EnvelopeCurve completed(Points greatest, const Points& least) {
    Quadrants forward = quadrants_of(std::move(greatest));
    Quadrants backward = quadrants_of(negated(mirrored(least)));
    if (forward.driving.empty()) forward.driving = backward.driving;
    if (backward.driving.empty()) backward.driving = forward.driving;
    if (forward.braking.empty() && backward.braking.empty()) {
      forward.braking = forward.driving;
      backward.braking = backward.driving;
    }
    if (forward.braking.empty()) forward.braking = backward.braking;
    if (backward.braking.empty()) backward.braking = forward.braking;
    return curve_of(forward, backward);
  }

  bool is_region(const EnvelopeCurve& curve) {
    const std::optional<EnvelopeBounds> rest = bounds_at(curve, 0.0);
    if (!rest || rest->greatest_Nm <= 0.0 || rest->least_Nm >= 0.0) {
      report("/points",
             rest ? fmt::format("at rest torque goes from {:.6g} to {:.6g} Nm; a drive has some "
                                "either way there",
                                rest->least_Nm, rest->greatest_Nm)
                  : std::string("they say nothing of rest: one of the bounds ends before"));
      return false;
    }
    for (const Points* bound : {&curve.greatest, &curve.least}) {
      for (const EnvelopePoint& point : *bound) {
        const std::optional<EnvelopeBounds> here = bounds_at(curve, point.speed_rad_s);
        if (!here || here->greatest_Nm >= here->least_Nm) continue;
        report("/points", fmt::format("the bounds cross: at {} rad/s the greatest torque, {:.6g} "
                                      "Nm, is below the least, {:.6g} Nm",
                                      point.speed_rad_s, here->greatest_Nm, here->least_Nm));
        return false;
      }
    }
    return true;
  }

  void limit_continuous(Envelope& envelope) {
    const std::optional<double> torque_Nm = find("continuous_torque_Nm");
    if (!torque_Nm) return;
    if (envelope.continuous) {
      report("/continuous_torque_Nm", "stands beside \"continuous_points\", which say it already");
      return;
    }
    const double peak_Nm = greatest_torque_Nm(envelope.peak);
    if (*torque_Nm > peak_Nm) {
      report("/continuous_torque_Nm",
             fmt::format("{} Nm is above the peak torque, {} Nm", *torque_Nm, peak_Nm));
      return;
    }
    envelope.continuous = EnvelopeCurve{cut_at(envelope.peak.greatest, *torque_Nm),
                                        negated(cut_at(negated(envelope.peak.least), *torque_Nm))};
  }

  const io::Document& document_;
  const json& keys_;
  Actuator& actuator_;
  std::vector<io::Document>& documents_;
  std::vector<io::Fault>& faults_;
};

}  // namespace

void read_envelope(const io::Document& document, Actuator& actuator,
                   std::vector<io::Document>& documents, std::vector<io::Fault>& faults) {
  EnvelopeReader(document, actuator, documents, faults).read();
}

}  // namespace torquewright::actuator
