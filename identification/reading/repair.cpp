// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "identification/log/piece.hpp"
#include "identification/log/stretch.hpp"
#include "identification/reading/isolated.hpp"
#include "identification/reading/saturation.hpp"
#include "identification/reading/stretch_turns.hpp"
#include "identification/reading/wrap.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::identification {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

constexpr std::array kWrappedAngles = {Quantity::kOutputPosition, Quantity::kMotorPosition};

/// What sensors measure of things that have inertia. Commands and duties may jump at will, and a
/// bus dips within a sample.
constexpr std::array kInert = {
    Quantity::kOutputPosition, Quantity::kOutputVelocity,     Quantity::kMotorPosition,
    Quantity::kMotorVelocity,  Quantity::kMotorCurrent,       Quantity::kOutputTorque,
    Quantity::kReportedTorque, Quantity::kLinearPosition,     Quantity::kLinearVelocity,
    Quantity::kLinearForce,    Quantity::kWindingTemperature, Quantity::kCaseTemperature};

/// What has an end of its scale within the working range. A position stands still at a stop, a bus
/// at its supply's voltage, a duty truly at one: that is no fault.
constexpr std::array kWithEnds = {Quantity::kOutputVelocity, Quantity::kMotorVelocity,
                                  Quantity::kMotorCurrent,   Quantity::kOutputTorque,
                                  Quantity::kReportedTorque, Quantity::kLinearVelocity,
                                  Quantity::kLinearForce};

/// Samples on either side of a piece that are looked at with it: more than the rule for isolated
/// samples asks for.
constexpr std::size_t kInView = 120;

template <typename List>
bool holds(const List& list, Quantity quantity) {
  return std::find(list.begin(), list.end(), quantity) != list.end();
}

/// Repairs one run, or a piece with samples around it.
class Repair {
 public:
  Repair(Run& run, const Rig& rig, Repairs& repairs)
      : run_(run), rig_(rig), repairs_(repairs), core_end_(run.masked.size()) {}

  /// Counts faults from `begin` to before `end` only, and goes on with the turns of the piece
  /// before it.
  Repair(Run& run, const Rig& rig, Repairs& repairs, std::size_t begin, std::size_t end,
         StretchTurns& turns)
      : run_(run),
        rig_(rig),
        repairs_(repairs),
        core_begin_(begin),
        core_end_(end),
        turns_(&turns) {}

  void channel(const ChannelKey& key) {
    std::vector<double>& values = run_.joints[key.first][key.second];
    const bool wraps = starts_anew(key, values);
    if (key.second == Quantity::kOutputPosition) output_wraps_ = wraps;
    if (values.empty()) return;
    if (holds(kInert, key.second)) isolated(key, Circle{wraps ? kTurn_rad : 0.0}, values);
    if (wraps) join_turns(key, values);
    if (wraps && turns_ != nullptr) turns_->go_on(key, values, core_begin_, core_end_);
    if (holds(kWithEnds, key.second)) saturated(key, values);
  }

 private:
  /// A command may step by most of a turn at will: it is taken for wrapped only where the output
  /// is.
  bool starts_anew(const ChannelKey& key, const std::vector<double>& values) const {
    const bool may = key.second == Quantity::kCommandedPosition ? output_wraps_
                                                                : holds(kWrappedAngles, key.second);
    if (turns_ != nullptr) return may && turns_->is_wrapped(key);
    return may && is_wrapped(values, kTurn_rad);
  }

  bool is_in_core(std::size_t sample) const { return sample >= core_begin_ && sample < core_end_; }

  void isolated(const ChannelKey& key, const Circle& circle, std::vector<double>& values) {
    const IsolatedSamples found = find_isolated(values, circle);
    std::size_t count = 0;
    for (const auto& [begin, length] : found.places) {
      for (std::size_t i = begin; i < begin + length; ++i) count += is_in_core(i);
    }
    (found.is_crowd ? repairs_.crowds : repairs_.isolated).add(key, run_.name, count);
    if (found.is_crowd) return;
    replace_isolated(found, circle, values);
    for (const auto& [begin, length] : found.places) {
      for (std::size_t i = begin; i < begin + length; ++i) run_.masked[i] = 1;
    }
  }

  void join_turns(const ChannelKey& key, std::vector<double>& values) {
    const bool is_measured = key.second != Quantity::kCommandedPosition;
    if (const auto at = find_ambiguous_step(values, kTurn_rad); is_measured && at) {
      const std::string where = run_.time_s.empty() ? fmt::format("sample {}", *at)
                                                    : fmt::format("t = {} s", run_.time_s[*at]);
      throw io::SpecError(
          {{rig_.file, "/columns",
            fmt::format("{} starts anew after each turn and turns by more than a quarter of one "
                        "between two samples (run \"{}\", {}): it cannot be told which way; log "
                        "faster, or list the column under \"ignore\"",
                        describe(key, rig_), run_.name, where)}});
    }
    std::size_t jumps = 0;
    for (const std::size_t at : unwrap(values, kTurn_rad)) jumps += is_in_core(at);
    repairs_.wraps.add(key, run_.name, jumps);
  }

  void saturated(const ChannelKey& key, const std::vector<double>& values) {
    std::size_t count = 0;
    for (const double level : find_saturated_values(values)) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != level) continue;
        run_.masked[i] = 1;
        count += is_in_core(i);
      }
    }
    repairs_.saturated.add(key, run_.name, count);
  }

  Run& run_;
  const Rig& rig_;
  Repairs& repairs_;
  std::size_t core_begin_ = 0, core_end_;
  StretchTurns* turns_ = nullptr;  ///< Of a piece.
  bool output_wraps_ = false;  ///< Of the joint at hand; its quantity comes before the command's.
};

void all_channels(Repair repair, const Run& run) {
  for (std::size_t joint = 0; joint < run.joints.size(); ++joint) {
    for (std::size_t i = 0; i < kQuantityCount; ++i) {
      repair.channel({joint, static_cast<Quantity>(i)});
    }
  }
}

void report_each(const Tally& tally, const Rig& rig, Weight weight, const char* what,
                 std::vector<DataFinding>& findings) {
  for (const auto& [key, entry] : tally.entries()) {
    findings.push_back(
        {weight, fmt::format("{}: {} {} in {}", describe(key, rig), entry.count,
                             fmt::format(fmt::runtime(what), entry.count == 1 ? "" : "s"),
                             describe_runs(entry.runs))});
  }
}

}  // namespace

void repair(Runs& runs, const Rig& rig, Repairs& repairs) {
  if (runs.is_in_memory()) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs.change(i, [&](Run& run) { all_channels(Repair(run, rig, repairs), run); });
    }
    return;
  }
  StretchTurns turns(kTurn_rad);
  Run before;  // The samples before this piece, as they were read.
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs.head(i).continues) {
      before = {};
      turns.begin(runs, i);
    }
    const std::size_t samples = runs.head(i).samples;
    const std::size_t from = samples - std::min(samples, kInView);
    Run own_end = runs.part(i, from, samples);
    Piece piece = with_neighbours(runs, i, kInView, before);
    all_channels(Repair(piece.run, rig, repairs, piece.begin, piece.end, turns), piece.run);
    runs.change(i, [&](Run& run) {
      const bool continues = run.continues;
      run = part_of(piece.run, piece.begin, piece.end);
      run.continues = continues;
    });
    before = std::move(own_end);
  }
}

void report(const Repairs& repairs, const Rig& rig, std::vector<DataFinding>& findings) {
  report_each(repairs.wraps, rig, Weight::kNote,
              "jump{} of a whole turn, a wrapped angle: unwrapped", findings);
  report_each(repairs.isolated, rig, Weight::kWarning,
              "impossible sample{} that leave and return at once: interpolated and masked",
              findings);
  report_each(repairs.saturated, rig, Weight::kWarning,
              "sample{} at the end of the channel's scale, saturated: masked", findings);
  report_each(repairs.crowds, rig, Weight::kWarning,
              "sample{} that leave and return at once, too many to be single faults: left as they "
              "are",
              findings);
}

}  // namespace torquewright::identification
