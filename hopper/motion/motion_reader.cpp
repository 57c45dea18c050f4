// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/motion_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/trajectory/angle_unwrap.hpp"
#include "actuator/trajectory/columns.hpp"
#include "actuator/trajectory/one_time.hpp"
#include "hopper/motion/ground_line.hpp"
#include "hopper/motion/slopes.hpp"
#include "hopper/motion/stated_columns.hpp"
#include "io/columns/units_row.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Kind = ChannelKind;

constexpr std::size_t kRowsBetweenProgress = 20000;
constexpr double kSamePosition = 1e-6;  // rad or m between the two rows of one impact
constexpr double kLeastQuaternion = 1e-3;
/// By how much a quaternion's length may be off 1: more than what two decimals leave.
constexpr double kQuaternionRounding = 1e-2;

/// A column of the file and the channel it fills.
struct Source {
  std::size_t column;
  std::size_t channel;
  double factor;
  bool has_unit;  ///< Its unit or factor was stated.
};

class MotionReader {
 public:
  MotionReader(const Robot& robot, const MotionFile& source)
      : robot_(robot), source_(source), channels_(channels_of(robot)), csv_(opened()) {
    take_stated_columns();
    take_canonical_columns();
    refuse_foreign_units();
    size_tables();
    require_complete();
    unwraps_.resize(sources_.size());
  }

  Motion read() {
    for (std::size_t count = 0; csv_.next(); ++count) {
      read_row();
      if (source_.on_progress && count % kRowsBetweenProgress == 0) {
        source_.on_progress(csv_.share_read());
      }
    }
    if (motion_.times_s.empty()) {
      io::refuse(csv_.file(),
                 first_s_ ? actuator::no_rows_within(source_.window, *first_s_, *previous_s_)
                          : "holds a header and no rows");
    }
    store_tables();
    motion_.ground = read_ground(csv_.comments(), csv_.file());
    motion_.file = csv_.file();
    motion_.sha256 = csv_.sha256();
    return std::move(motion_);
  }

 private:
  const dynamics::Tree& tree() const { return robot_.tree; }

  io::CsvReader opened() const {
    if (source_.bare.order.empty()) {
      return io::CsvReader(source_.file, io::CsvReader::CutEnd::kRefused,
                           io::CsvReader::UnitsRow::kTaken);
    }
    return {source_.file, headers_of(source_.bare, channels_)};
  }

  void take(const ChannelMapping& mapping) {
    const auto column = csv_.find(mapping.column);
    if (!column) {
      const auto near = io::nearest(mapping.column, csv_.header());
      io::refuse(csv_.file(),
                 fmt::format("no column \"{}\"{}", mapping.column,
                             near ? fmt::format("; did you mean \"{}\"?", *near) : ""));
    }
    for (const Source& other : sources_) {
      if (other.channel != mapping.channel) continue;
      io::refuse(csv_.file(),
                 fmt::format("\"{}\" and \"{}\" are both mapped to {}", csv_.header()[other.column],
                             mapping.column, channels_[mapping.channel].header));
    }
    const double factor = io::with_units_row(csv_, *column, channels_[mapping.channel].dimension,
                                             mapping.factor, mapping.has_unit);
    sources_.push_back({*column, mapping.channel, factor, mapping.has_unit});
  }

  void take_stated_columns() {
    const auto stated = stated_columns(source_.mappings, source_.documents);
    for (const StatedColumn& each :
         without_patterns(stated, channels_, csv_.header(), csv_.file())) {
      take(find_channel(each.mapping, each.text, channels_));
    }
  }

  void take_canonical_columns() {
    if (!source_of(0)) actuator::require_one_time(csv_);
    for (std::size_t column = 0; column < csv_.header().size(); ++column) {
      std::string header = csv_.header()[column];
      if (header == "t" || header == "time") header = "time_s";
      for (std::size_t i = 0; i < channels_.size(); ++i) {
        if (channels_[i].header != header || source_of(i) || is_taken(column)) continue;
        const double factor = io::with_units_row(csv_, column, channels_[i].dimension, 1.0, false);
        sources_.push_back({column, i, factor, false});
      }
    }
  }

  /// A column that is named like one of ours in another unit would be missing, and nobody would
  /// know; one that is mapped without its unit would count in the wrong one.
  void refuse_foreign_units() const {
    for (const Source& source : sources_) {
      if (!source.has_unit) refuse_if_foreign(source.column, channels_[source.channel]);
    }
    for (std::size_t column = 0; column < csv_.header().size(); ++column) {
      for (std::size_t i = 0; i < channels_.size(); ++i) {
        const Channel& channel = channels_[i];
        const std::string before_unit = target_of(channel, "_") + "_";
        const std::string& header = csv_.header()[column];
        const bool is_its_own =
            header.starts_with(before_unit) && io::find_unit(header.substr(before_unit.size()));
        if (is_its_own && !is_taken(column) && source_of(i) == nullptr) {
          refuse_if_foreign(column, channel);
        }
      }
    }
  }

  static std::string target_of(const Channel& channel, std::string_view between) {
    return channel.owner.empty() ? channel.quantity
                                 : fmt::format("{}{}{}", channel.owner, between, channel.quantity);
  }

  void refuse_if_foreign(std::size_t column, const Channel& channel) const {
    const std::string& header = csv_.header()[column];
    const auto unit = actuator::foreign_unit(header, channel.dimension);
    if (!unit) return;
    io::refuse(csv_.file(),
               fmt::format("the column \"{0}\" says {1}; state its unit, --column {0}={2}:{1}",
                           header, unit->name, target_of(channel, ".")));
  }

  bool is_taken(std::size_t column) const {
    return std::any_of(sources_.begin(), sources_.end(),
                       [column](const Source& source) { return source.column == column; });
  }

  const Source* source_of(std::size_t channel) const {
    const auto found = std::find_if(sources_.begin(), sources_.end(),
                                    [channel](const Source& it) { return it.channel == channel; });
    return found == sources_.end() ? nullptr : &*found;
  }

  /// Channels of a kind that the file has, or lacks.
  std::vector<std::string> headers(Kind kind, bool are_there) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (channels_[i].kind == kind && (source_of(i) != nullptr) == are_there) {
        names.push_back(channels_[i].header);
      }
    }
    return names;
  }

  std::string hint(const std::string& missing) const {
    const auto near = io::nearest(missing, csv_.header());
    if (near) return fmt::format("; did you mean \"{}\"?", *near);
    std::vector<std::string> there = csv_.header();
    constexpr std::size_t kMostNames = 20;
    const bool is_long = there.size() > kMostNames;
    if (is_long) there.resize(kMostNames);
    return fmt::format("; the file has {}{}", io::listed(there), is_long ? ", ..." : "");
  }

  void size_tables() {
    const Index joints = static_cast<Index>(tree().bodies.size()) - 1;
    const auto contacts = static_cast<Index>(robot_.contacts.size());
    rows_ = {1,
             tree().position_size(),
             tree().velocity_size(),
             tree().velocity_size(),
             joints,
             3 * contacts,
             contacts};
  }

  static bool is_of_base(const std::string& header) { return header.starts_with("base_"); }

  void require_complete() {
    if (!source_of(0) && source_.bare.rows_per_s == 0.0) {
      io::refuse(csv_.file(), "no column time_s; name the time with --column NAME=time[:unit]");
    }
    const std::vector<std::string> missing = headers(Kind::kPosition, false);
    const auto base_missing =
        static_cast<std::size_t>(std::count_if(missing.begin(), missing.end(), is_of_base));
    for (const std::string& header : missing) {
      if (is_of_base(header)) continue;
      io::refuse(csv_.file(),
                 fmt::format("no column {} for robot \"{}\"{}", header, robot_.name, hint(header)));
    }
    require_base(missing, base_missing);
    require_torques();
    motion_.velocity_origin = complete(Kind::kVelocity);
    motion_.acceleration_origin = complete(Kind::kAcceleration);
    motion_.has_forces = !headers(Kind::kForce, true).empty();
    motion_.has_touching = !headers(Kind::kContact, true).empty();
  }

  void require_base(const std::vector<std::string>& missing, std::size_t base_missing) {
    const auto base_coordinates = static_cast<std::size_t>(
        tree().position_size() - static_cast<Index>(tree().bodies.size()) + 1);
    motion_.has_base = base_missing == 0;
    if (base_missing == 0 || base_missing == base_coordinates) return;
    io::refuse(csv_.file(), fmt::format("no column {}, though others of the base are there{}",
                                        missing.front(), hint(missing.front())));
  }

  /// Where nothing is said of the base, torques cannot be computed and must be given.
  void require_torques() {
    motion_.has_effort.assign(tree().bodies.size() - 1, false);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (channels_[i].kind != Kind::kEffort || !source_of(i)) continue;
      motion_.has_effort[static_cast<std::size_t>(channels_[i].row)] = true;
    }
    if (motion_.has_base) return;
    for (const Drivetrain& drivetrain : robot_.drivetrains) {
      for (const std::size_t body : drivetrain.joints) {
        if (motion_.has_effort[body - 1]) continue;
        io::refuse(csv_.file(),
                   fmt::format("says neither how the base moves (no base_x_position_m, ...) nor "
                               "the torque of joint \"{}\": one of them is needed",
                               tree().bodies[body].joint.name));
      }
    }
  }

  /// Rates are given for all coordinates, or they are derived for all: half would not fit.
  Origin complete(Kind kind) const {
    std::vector<std::string> missing = headers(kind, false);
    if (!motion_.has_base) std::erase_if(missing, is_of_base);
    if (missing.empty()) return Origin::kGiven;
    if (headers(kind, true).empty()) return Origin::kAbsent;
    io::refuse(
        csv_.file(),
        fmt::format("no column {}, though other {} are there{}; give all or none", missing.front(),
                    kind == Kind::kVelocity ? "velocities" : "accelerations",
                    hint(missing.front())));
  }

  void read_row() {
    const double stamp_s = source_of(0) ? number(*source_of(0)) : next_stamp_s();
    if (source_of(0)) require_order(stamp_s);
    previous_s_ = stamp_s;
    if (!first_s_) first_s_ = stamp_s;
    const double time_s = clock_.since_origin_s(stamp_s);
    motion_.clock = clock_;
    if (stamp_s < source_.window.from_s || stamp_s > source_.window.until_s) return;
    motion_.times_s.push_back(time_s);
    for (std::size_t kind = 1; kind < rows_.size(); ++kind) {
      tables_[kind].resize(tables_[kind].size() + static_cast<std::size_t>(rows_[kind]), 0.0);
    }
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const Channel& channel = channels_[sources_[i].channel];
      const auto kind = static_cast<std::size_t>(channel.kind);
      if (channel.kind == Kind::kTime) continue;
      double value = number(sources_[i]);
      if (is_angle(channel)) value = unwraps_[i].next(time_s, value);
      if (channel.kind == Kind::kContact && value != 0.0 && value != 1.0) {
        csv_.refuse(sources_[i].column,
                    fmt::format("{:g} must be 1 where the point touches, else 0", value));
      }
      *(tables_[kind].end() - rows_[kind] + channel.row) = value;
    }
    if (!motion_.has_base && tree().base == dynamics::BaseKind::kSpatial) {
      *(positions().end() - rows_[1] + 3) = 1.0;
    }
    check_row();
  }

  double next_stamp_s() { return static_cast<double>(counted_++) / source_.bare.rows_per_s; }

  double number(const Source& source) const {
    const bool is_time = &source == source_of(0);
    const double value =
        (is_time ? csv_.time(source.column) : csv_.number(source.column)) * source.factor;
    csv_.require_within(source.column, value,
                        is_time ? actuator::Clock::kLatest_s : actuator::kGreatestValue);
    return value;
  }

  std::vector<double>& positions() { return tables_[static_cast<std::size_t>(Kind::kPosition)]; }

  void require_order(double time_s) {
    is_repeated_ = previous_s_ && time_s == *previous_s_;
    if (previous_s_ && time_s < *previous_s_) {
      csv_.refuse(source_of(0)->column,
                  fmt::format("time runs backwards: {} s follows {} s", time_s, *previous_s_));
    }
    if (previous_s_ && !is_repeated_ && time_s - *previous_s_ < actuator::Clock::kShortestStep_s) {
      csv_.refuse(source_of(0)->column,
                  fmt::format("{} s follow {} s: closer than the {} s that a log's rows can be "
                              "apart; state the unit, --column {}=time:ms",
                              time_s, *previous_s_, actuator::Clock::kShortestStep_s,
                              csv_.header()[source_of(0)->column]));
    }
  }

  void check_row() {
    const Index size = rows_[1];
    const auto all = static_cast<Index>(positions().size());
    const Eigen::Map<const Eigen::VectorXd> now(positions().data() + all - size, size);
    if (tree().base == dynamics::BaseKind::kSpatial) require_unit(now.segment<4>(3).norm());
    if (all == size) return;
    const Eigen::Map<const Eigen::VectorXd> before(positions().data() + all - 2 * size, size);
    if (is_repeated_) return take_impact(before, now);
    require_no_jump(before, now);
  }

  void require_unit(double length) {
    if (length < kLeastQuaternion) csv_.refuse_row("the base's quaternion has no length");
    if (std::abs(length - 1.0) <= kQuaternionRounding) return;
    csv_.refuse_row(
        fmt::format("the base's quaternion has the length {:.6g}; that of a rotation is "
                    "1, within {:g}",
                    length, kQuaternionRounding));
  }

  void take_impact(const Eigen::VectorXd& before, const Eigen::VectorXd& now) {
    const bool stands = (now - before).cwiseAbs().maxCoeff() <= kSamePosition;
    if (!stands || motion_.velocity_origin != Origin::kGiven || was_repeated_) {
      csv_.refuse(source_of(0)->column,
                  fmt::format("time repeats: {} s; only an impact may have two rows, of one "
                              "position and with velocities before and after",
                              motion_.times_s.back()));
    }
    motion_.breaks.push_back(static_cast<Index>(motion_.times_s.size()) - 1);
    was_repeated_ = true;
  }

  static bool is_angle(const Channel& channel) {
    return channel.kind == Kind::kPosition && channel.dimension == io::Dimension::kAngle;
  }

  /// More than half a turn between two rows; whole turns are taken out already. No robot turns so
  /// fast.
  void require_no_jump(const Eigen::VectorXd& before, const Eigen::VectorXd& now) {
    was_repeated_ = false;
    for (const Source& source : sources_) {
      const Channel& channel = channels_[source.channel];
      if (!is_angle(channel)) continue;
      const double jump_rad = now[channel.row] - before[channel.row];
      if (std::abs(jump_rad) <= std::numbers::pi) continue;
      csv_.refuse(source.column,
                  fmt::format("jumps by {:.6g} rad since the row before: a wrapped angle? Unwrap "
                              "it (add or take whole turns) so that it runs on",
                              jump_rad));
    }
  }

  void store_tables() {
    const auto table = [this](Kind kind) -> Eigen::MatrixXd {
      const auto index = static_cast<std::size_t>(kind);
      return Eigen::Map<const Eigen::MatrixXd>(tables_[index].data(), rows_[index],
                                               motion_.samples());
    };
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (unwraps_[i].count() == 0) continue;
      motion_.unwrapped.push_back(
          {channels_[sources_[i].channel].header, unwraps_[i].count(), unwraps_[i].first_s()});
    }
    motion_.positions = table(Kind::kPosition);
    motion_.velocities = table(Kind::kVelocity);
    motion_.accelerations = table(Kind::kAcceleration);
    motion_.efforts = table(Kind::kEffort);
    motion_.forces_N = table(Kind::kForce);
    motion_.touching = table(Kind::kContact);
  }

  const Robot& robot_;
  const MotionFile& source_;
  std::vector<Channel> channels_;
  io::CsvReader csv_;
  std::vector<Source> sources_;
  std::vector<actuator::AngleUnwrap> unwraps_;  ///< By source.
  std::array<Index, 7> rows_{};                 ///< By kind of channel.
  std::array<std::vector<double>, 7> tables_;
  Motion motion_;
  actuator::Clock clock_;
  std::optional<double> first_s_;
  std::optional<double> previous_s_;
  std::size_t counted_ = 0;  ///< Rows of a file without times.
  bool is_repeated_ = false;
  bool was_repeated_ = false;
};

}  // namespace

Motion read_motion(const Robot& robot, const MotionFile& source) {
  return MotionReader(robot, source).read();
}

}  // namespace torquewright::hopper
