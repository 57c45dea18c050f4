// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/powered_drives.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "actuator/region/bracketed_search.hpp"
#include "hopper/replay/free_rotors.hpp"
#include "hopper/replay/working_drive.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/drive_supply.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kVoltageTolerance = 1e-7;  // of the open circuit: 0.2 mNm at the knee of seed 001
constexpr int kMostVoltages = 60;           // tried in a step: bisection alone needs 24 to that
constexpr double kShareTolerance = 1e-9;    // of the motors' torque
constexpr double kPowerTolerance = 1e-9;    // of a battery's limit,
constexpr double kLeastPower_W = 1e-6;      // and what a rounded zero may be

using FixedDrives = std::vector<FixedDrive>;

std::string file_of(const Drivetrain& drivetrain, std::size_t i) {
  const std::vector<std::string>& files = drivetrain.actuator_files;
  return i < files.size() ? files[i] : drivetrain.actuators[i].name;
}

FixedDrives fixed_drives(const Robot& robot) {
  FixedDrives drives;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      const bool is_free = is_rotor_free(robot, drivetrain, i);
      const double rotor_kg_m2 =
          is_free ? rotor_turned_kg_m2(robot, drivetrain, i) : rotor_at_output_kg_m2(drivetrain, i);
      drives.push_back(
          {drivetrain.actuators[i], file_of(drivetrain, i), rotor_kg_m2, !is_free, nullptr});
    }
  }
  return drives;
}

void require_possible(const FixedDrives& drives, const actuator::OperatingConditions& conditions) {
  std::vector<io::Fault> faults;
  for (const FixedDrive& drive : drives) {
    for (const std::string& sentence : actuator::objections(drive.actuator, conditions)) {
      faults.push_back({drive.file, "", sentence});
    }
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

/// By drive: whether its voltage_sag lies between it and a battery that it shares.
std::vector<bool> own_lines(const std::vector<DriveSupply>& supplies, std::size_t drives) {
  std::vector<bool> own(drives, false);
  for (const DriveSupply& supply : supplies) {
    for (const std::size_t drive : supply.drives) own[drive] = has_own_line(supply);
  }
  return own;
}

/// What a drive can do at the voltages and, where its heat is known, the temperatures of a run;
/// drives of one kind share it. Of a battery of its own, cables are the battery's.
void make_regions(const actuator::OperatingConditions& conditions,
                  const std::vector<bool>& has_line, FixedDrives& drives) {
  using actuator::GridTemperatures;
  for (auto drive = drives.begin(); drive != drives.end(); ++drive) {
    const actuator::Actuator actuator = has_line[static_cast<std::size_t>(drive - drives.begin())]
                                            ? drive->actuator
                                            : actuator::without_voltage_sag(drive->actuator);
    const bool warms = actuator.thermal.has_value();
    actuator::OperatingConditions own{conditions.rating, {}, {}, {}};
    if (!warms) own.winding_temperature_K = conditions.winding_temperature_K;
    const auto alike = std::find_if(drives.begin(), drive, [&](const FixedDrive& before) {
      return before.region->is_of(actuator, own);
    });
    drive->region = alike != drive ? alike->region
                                   : std::make_shared<const actuator::HeldRegion>(
                                         actuator, own,
                                         warms ? GridTemperatures::kFreezingToLimit
                                               : GridTemperatures::kAsAsked);
  }
}

/// Numbers by drive, `otherwise` for all where there are none.
VectorXd one_each(const VectorXd& numbers, Index drives, double otherwise) {
  if (numbers.size() == 0) return VectorXd::Constant(drives, otherwise);
  if (numbers.size() != drives || !numbers.allFinite()) {
    throw std::invalid_argument("what differs in the drives is one finite number for each");
  }
  return numbers;
}

std::vector<const actuator::Actuator*> actuators_of(const FixedDrives& drives) {
  std::vector<const actuator::Actuator*> actuators;
  for (const FixedDrive& drive : drives) actuators.push_back(&drive.actuator);
  return actuators;
}

/// Where a gap that falls with the voltage is zero: where the first one leads to and, once it is
/// between two, by secants (the Illinois rule). It is asked last where it is returned.
template <typename Gap>
double where_closed_V(const Gap& gap_V, double first_V, double tolerance_V) {
  double far_V = first_V;
  double far_gap_V = gap_V(far_V);
  if (std::abs(far_gap_V) <= tolerance_V) return far_V;
  double near_V = far_V + far_gap_V;
  double near_gap_V = gap_V(near_V);
  for (int tried = 2; std::abs(near_gap_V) > tolerance_V && tried < kMostVoltages; ++tried) {
    const bool is_between = (near_gap_V < 0.0) != (far_gap_V < 0.0);
    const double secant_V = near_gap_V * (near_V - far_V) / (near_gap_V - far_gap_V);
    const double next_V = is_between ? near_V - secant_V : near_V + near_gap_V;
    const double next_gap_V = gap_V(next_V);
    if (is_between && (next_gap_V < 0.0) == (near_gap_V < 0.0)) {
      far_gap_V *= 0.5;
    } else {
      far_V = near_V;
      far_gap_V = near_gap_V;
    }
    near_V = next_V;
    near_gap_V = next_gap_V;
  }
  return near_V;
}

}  // namespace

class PoweredDrives::Work {
 public:
  Work(FixedDrives drives, const PoweredDriveOptions& options) {
    require_possible(drives, options.conditions);
    const auto supplies = drive_supplies(actuators_of(drives), options.conditions);
    make_regions(options.conditions, own_lines(supplies, drives.size()), drives);
    made_for_ = options.conditions;
    fixed_ = std::make_shared<const FixedDrives>(std::move(drives));
    begin(options);
  }

  std::unique_ptr<Work> under(const PoweredDriveOptions& options) const {
    const bool is_alike =
        options.conditions.rating == made_for_.rating &&
        options.conditions.winding_temperature_K == made_for_.winding_temperature_K;
    if (!is_alike) return std::make_unique<Work>(*fixed_, options);
    require_possible(*fixed_, options.conditions);
    auto other = std::make_unique<Work>(*this);
    other->begin(options);
    return other;
  }

  void start() {
    for (WorkingDrive& drive : drives_) drive.start();
    for (Bus& bus : buses_) {
      bus.voltage_V = bus.feeds.supply.open_circuit_V;
      bus.drawn_C = 0.0;
    }
    step_.torque_Nm = step_.cut_off_Nm = step_.current_A = VectorXd::Zero(size());
    step_.winding_K = step_.bus_V = VectorXd::Zero(size());
  }

  const DriveStep& drive(const VectorXd& wanted_Nm, const VectorXd& position_rad,
                         const VectorXd& speed_rad_s, double step_s) {
    const auto is_one_each = [&](const VectorXd& values) {
      return values.size() == size() && values.allFinite();
    };
    if (!is_one_each(wanted_Nm) || !is_one_each(position_rad) || !is_one_each(speed_rad_s) ||
        !(step_s > 0.0) || !std::isfinite(step_s)) {
      throw std::invalid_argument(
          "a step of drives needs a finite torque, position and speed of each, and a length");
    }
    step_.is_starved = false;
    step_.power_W = 0.0;
    step_.least_bus_V.reset();
    for (Index i = 0; i < size(); ++i) at(i).want(wanted_Nm[i], speed_rad_s[i]);
    for (Bus& bus : buses_) {
      settle(bus);
      finish(bus, position_rad, step_s);
    }
    return step_;
  }

  void ranges(const VectorXd& speed_rad_s, const VectorXd& bus_V, const VectorXd& winding_K,
              VectorXd& least_Nm, VectorXd& greatest_Nm) const {
    least_Nm.resize(size());
    greatest_Nm.resize(size());
    for (const Bus& bus : buses_) {
      for (const std::size_t drive : bus.feeds.drives) {
        const auto i = static_cast<Index>(drive);
        const actuator::Interval range = drives_[drive].range(
            bus_V.size() > 0 ? bus_V[i] : bus.feeds.supply.open_circuit_V,
            winding_K.size() > 0 ? winding_K[i] : drives_[drive].winding_K(), speed_rad_s[i]);
        least_Nm[i] = range.least_Nm;
        greatest_Nm[i] = range.greatest_Nm;
      }
    }
  }

  std::vector<double> drawn_Ah() const {
    constexpr double kSecondsPerHour = 3600.0;
    std::vector<double> drawn;
    for (const Bus& bus : buses_) drawn.push_back(bus.drawn_C / kSecondsPerHour);
    return drawn;
  }

  Index size() const { return static_cast<Index>(drives_.size()); }
  bool has_heat(Index drive) const { return drives_[static_cast<std::size_t>(drive)].has_heat(); }

 private:
  struct Bus {
    DriveSupply feeds;
    double most_W;
    double voltage_V;  ///< That the step before left.
    double drawn_C = 0.0;
  };

  WorkingDrive& at(Index drive) { return drives_[static_cast<std::size_t>(drive)]; }

  void begin(const PoweredDriveOptions& options) {
    const auto count = static_cast<Index>(fixed_->size());
    const VectorXd friction_Nm = one_each(options.further_friction_Nm, count, 0.0);
    if ((friction_Nm.array() < 0.0).any()) {
      throw std::invalid_argument("further friction is one number a drive, not negative");
    }
    const VectorXd strength = one_each(options.motor_strength_factor, count, 1.0);
    if (!(strength.array() > 0.0).all()) {
      throw std::invalid_argument("a motor's strength is one number a drive, positive");
    }
    drives_.clear();
    for (Index i = 0; i < count; ++i) {
      drives_.emplace_back((*fixed_)[static_cast<std::size_t>(i)], options,
                           UnknownOfDrive{friction_Nm[i], strength[i]});
    }
    buses_.clear();
    for (DriveSupply& feeds : drive_supplies(actuators_of(*fixed_), options.conditions)) {
      const double most_W = greatest_power_W(feeds.supply);
      buses_.push_back({std::move(feeds), most_W, 0.0, 0.0});
    }
    start();
  }

  /// Of all drives on it and their lines, as they are held.
  double power_W(const Bus& bus, double voltage_V) const {
    double sum_W = 0.0;
    for (std::size_t i = 0; i < bus.feeds.drives.size(); ++i) {
      const double own_W = drives_[bus.feeds.drives[i]].power_W();
      sum_W += voltage_V > 0.0 ? drawn_power_W(voltage_V, bus.feeds.lines_ohm[i], own_W) : own_W;
    }
    return sum_W;
  }

  /// Holds the drives at the voltage that they leave, eq. (2), and within what it gives, eq. (4).
  void settle(Bus& bus) {
    const actuator::Supply& supply = bus.feeds.supply;
    const auto gap_V = [&](double voltage_V) {
      for (const std::size_t drive : bus.feeds.drives) drives_[drive].hold(voltage_V);
      return loaded_voltage_V(supply, power_W(bus, voltage_V)) - voltage_V;
    };
    bus.voltage_V = where_closed_V(gap_V, bus.voltage_V, kVoltageTolerance * supply.open_circuit_V);
    const double asked_W = power_W(bus, bus.voltage_V);
    const bool is_too_much = is_beyond(asked_W, bus.most_W);
    if (!is_too_much && !is_beyond(-asked_W, -supply.least_power_W)) return;
    step_.is_starved = true;
    if (drives_[bus.feeds.drives.front()].is_in_box()) return;
    cut(bus, [&] {
      const double left_W = power_W(bus, bus.voltage_V);
      return is_too_much ? bus.most_W - left_W : left_W - supply.least_power_W;
    });
  }

  static bool is_beyond(double power_W, double limit_W) {
    return power_W > limit_W + kPowerTolerance * std::abs(limit_W) + kLeastPower_W;
  }

  /// By the greatest common share of the motors' torques that leaves room; without any where even
  /// none of it does.
  template <typename Room>
  void cut(Bus& bus, const Room& room_W) {
    const auto left_W = [&](double share) {
      for (const std::size_t drive : bus.feeds.drives) {
        drives_[drive].make_only(share, bus.voltage_V);
      }
      return room_W();
    };
    if (left_W(0.0) >= 0.0) {
      left_W(actuator::last_nonnegative(left_W, 0.0, 1.0, kShareTolerance));
    } else {
      for (const std::size_t drive : bus.feeds.drives) drives_[drive].switch_off();
    }
  }

  void finish(Bus& bus, const VectorXd& position_rad, double step_s) {
    const double asked_W = power_W(bus, bus.voltage_V);
    const double voltage_V = loaded_voltage_V(bus.feeds.supply, asked_W);
    if (voltage_V > 0.0) bus.drawn_C += asked_W / voltage_V * step_s;
    const bool has_winding = drives_[bus.feeds.drives.front()].has_winding();
    if (has_winding) {
      step_.power_W += asked_W;
      step_.least_bus_V = std::min(step_.least_bus_V.value_or(voltage_V), voltage_V);
    }
    for (const std::size_t drive : bus.feeds.drives) {
      const auto i = static_cast<Index>(drive);
      step_.torque_Nm[i] = drives_[drive].acting_Nm(position_rad[i], step_s);
      drives_[drive].end(step_s);
      step_.cut_off_Nm[i] = drives_[drive].cut_off_Nm();
      step_.current_A[i] = drives_[drive].current_A();
      step_.winding_K[i] = drives_[drive].winding_K();
      step_.bus_V[i] = voltage_V;
    }
  }

  actuator::OperatingConditions made_for_;  ///< Its rating and temperature, the regions.
  std::shared_ptr<const FixedDrives> fixed_;
  std::vector<WorkingDrive> drives_;
  std::vector<Bus> buses_;
  DriveStep step_;
};

PoweredDrives::PoweredDrives(const Robot& robot, const PoweredDriveOptions& options)
    : work_(std::make_unique<Work>(fixed_drives(robot), options)) {}
PoweredDrives::PoweredDrives(const PoweredDrives& other)
    : work_(std::make_unique<Work>(*other.work_)) {}
PoweredDrives::PoweredDrives(std::unique_ptr<Work> work) : work_(std::move(work)) {}
PoweredDrives::PoweredDrives(PoweredDrives&&) noexcept = default;
PoweredDrives& PoweredDrives::operator=(PoweredDrives&&) noexcept = default;
PoweredDrives::~PoweredDrives() = default;

PoweredDrives PoweredDrives::under(const PoweredDriveOptions& options) const {
  return PoweredDrives(work_->under(options));
}

void PoweredDrives::start() { work_->start(); }

const DriveStep& PoweredDrives::drive(const VectorXd& wanted_Nm, const VectorXd& position_rad,
                                      const VectorXd& speed_rad_s, double step_s) {
  return work_->drive(wanted_Nm, position_rad, speed_rad_s, step_s);
}

void PoweredDrives::ranges(const VectorXd& speed_rad_s, const VectorXd& bus_V,
                           const VectorXd& winding_K, VectorXd& least_Nm,
                           VectorXd& greatest_Nm) const {
  work_->ranges(speed_rad_s, bus_V, winding_K, least_Nm, greatest_Nm);
}

std::vector<double> PoweredDrives::drawn_Ah() const { return work_->drawn_Ah(); }
Index PoweredDrives::size() const { return work_->size(); }
bool PoweredDrives::has_heat(Index drive) const { return work_->has_heat(drive); }

namespace {

class RangesOfDrives final : public DriveRanges {
 public:
  explicit RangesOfDrives(PoweredDrives drives) : drives_(std::move(drives)) {}
  void at(const VectorXd& speed_rad_s, const VectorXd& bus_V, const VectorXd& winding_K,
          VectorXd& least_Nm, VectorXd& greatest_Nm) const override {
    drives_.ranges(speed_rad_s, bus_V, winding_K, least_Nm, greatest_Nm);
  }

 private:
  PoweredDrives drives_;
};

}  // namespace

std::shared_ptr<const DriveRanges> drive_ranges(const Robot& robot,
                                                const PoweredDriveOptions& options) {
  return std::make_shared<const RangesOfDrives>(PoweredDrives(robot, options));
}

}  // namespace torquewright::hopper
