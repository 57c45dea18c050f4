// SPDX-License-Identifier: Apache-2.0
#include "src/options/hopper_flip_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "hopper/planning/objectives/library.hpp"
#include "hopper/planning/tasks/library.hpp"
#include "hopper/planning/tasks/reserve.hpp"
#include "src/options/named_sentences.hpp"

namespace torquewright::cli {
namespace {

using command_line::Command;
using command_line::Option;
using Says = std::function<void(Option option)>;

constexpr std::int64_t kGreatestSeed = 4294967295;
constexpr std::int64_t kMostRepeats = 12;  // one programme holds all: a minute or two

template <typename Value>
std::optional<StatedValue> unless_usual(const Value& value, const Value& usual) {
  if (value == usual) return std::nullopt;
  return StatedValue(value);
}
std::optional<StatedValue> unless_usual(const std::optional<double>& value,
                                        const std::optional<double>& usual) {
  if (value == usual) return std::nullopt;
  return StatedValue(*value);
}

/// `at` yields the value within a request, to be filled or read.
template <typename At>
HopperFlipOption option(FlipGroup group, const std::string& names, const std::string& key, At at,
                        const std::string& help, const Says& says = {}) {
  HopperFlipOption out{group, names, key, false, {}, {}};
  out.declare = [=](Command& command, HopperFlipRequest& request) {
    auto& value = at(request);
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, bool>) {
      command.add_flag(names, value, help);
    } else {
      const Option declared = command.add_option(names, value, help);
      if (says) says(declared);
    }
  };
  out.stated = [=](const HopperFlipRequest& request) {
    static const HopperFlipRequest usual;
    return unless_usual(at(request), at(usual));
  };
  return out;
}

HopperFlipOption of_one_plan(HopperFlipOption one) {
  one.is_of_one_plan = true;
  return one;
}

Says between(double least, double greatest) {
  return [=](Option number) { number.between(least, greatest); };
}
Says integer_between(std::int64_t least, std::int64_t greatest) {
  return [=](Option number) { number.integer_between(least, greatest); };
}
void file(Option named) { named.names_a_file(); }

using Options = std::vector<HopperFlipOption>;

Options task_options() {
  const FlipGroup group = FlipGroup::kTask;
  const hopper::PlanOptions usual;
  return {
      option(
          group, "--task", "", [](auto& of) -> auto& { return of.task; },
          named_sentences(hopper::every_task(), "{}: {}", "; "),
          [](Option task) { task.one_of(hopper::task_names()); }),
      option(
          group, "--rise", "rise_m", [](auto& of) -> auto& { return of.rise_m; },
          "How far the centre of mass rises in the flight of a jump or a hop, at least, in m",
          [=](Option rise) {
            rise.otherwise(fmt::format("{:g}", usual.rise_m)).between(0.0, 2.0);
          }),
      option(
          group, "--stride", "stride_m", [](auto& of) -> auto& { return of.stride_m; },
          "How far a hop goes, in m; less than 0 is backwards",
          [](Option stride) { stride.otherwise("0.1, or what --speed makes").between(-2.0, 2.0); }),
      option(
          group, "--speed", "speed_m_s", [](auto& of) -> auto& { return of.speed_m_s; },
          "Mean speed of hops in m/s, from the first take-off to the last touch-down; without "
          "--stride it makes the stride; less than 0 is backwards",
          [](Option speed) { speed.otherwise("free").between(-5.0, 5.0); }),
      option(
          group, "--repeat", "repeat", [](auto& of) -> auto& { return of.plan.repeat; },
          "How many jumps or hops follow each other without a rest",
          integer_between(1, kMostRepeats)),
      option(
          group, "--land-at", "land_at_m", [](auto& of) -> auto& { return of.plan.landings_m; },
          "How much higher the ground is where a hop lands, in m, over that where the motion "
          "begins; of several hops in order, the last for all that follow: 0,0.085 steps up at "
          "the second",
          [](Option heights) {
            heights.otherwise("flat ground").separated_by_commas().between(-1.0, 1.0);
          }),
      option(
          group, "--limits", "", [](auto& of) -> auto& { return of.limits; },
          "What limits each drive: mor, its region at the voltage of the instant; box, its "
          "peak torque at any speed up to no load, which a real motor cannot do",
          [](Option limits) {
            limits.one_of({"mor", "box"});
          }),
      option(
          group, "--contacts", "contacts", [](auto& of) -> auto& { return of.plan.stances; },
          "What stands on the ground, in order: flat, heel, toe, flight",
          [](Option contacts) {
            contacts.otherwise("the task's, of a flip flat,heel,flight,heel,flat")
                .separated_by_commas();
          }),
      option(
          group, "--objective", "objective", [](auto& of) -> auto& { return of.objectives; },
          fmt::format("NAME[=WEIGHT]: what the plan makes small or great (docs/flip.md), of {}; "
                      "weights from 1e-6 to 1e6, 1 where none is stated",
                      fmt::join(hopper::objective_names(), ", ")),
          [](Option objective) { objective.otherwise("the task's").one_value_each(); }),
  };
}

/// "--position-margin" in rad is "position_margin_rad".
std::string margin_key(const hopper::MarginPart& part) {
  std::string key(part.option.substr(2));
  std::replace(key.begin(), key.end(), '-', '_');
  return part.unit.empty() ? key : key + "_" + std::string(part.unit);
}

/// What the reserve makes of each margin, in words.
std::string reserve_words() {
  std::vector<std::string> words;
  for (const hopper::MarginPart& part : hopper::margin_parts()) {
    if (!(part.per_reserve > 0.0)) continue;
    words.push_back(fmt::format("{} {:g}{}{}", part.option.substr(2), part.per_reserve,
                                part.unit.empty() ? "" : " ", part.unit));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Planning margins: what a replay has left to steer with.
Options margin_options() {
  const FlipGroup group = FlipGroup::kMargins;
  Options all{option(
      group, "--reserve", "reserve", [](auto& of) -> auto& { return of.plan.reserve; },
      fmt::format("One word for the margins below: each is at least so many times this share: {}; "
                  "what is stated by itself holds",
                  reserve_words()),
      between(0.0, 1.0))};
  const hopper::PlanMargins usual;
  for (std::size_t i = 0; i < hopper::margin_parts().size(); ++i) {
    const hopper::MarginPart& part = hopper::margin_parts()[i];
    const double otherwise = usual.*part.margin;
    all.push_back(option(
        group, std::string(part.option),
        margin_key(part), [i](auto& of) -> auto& { return of.margins[i]; },
        std::string(part.sentence),
        [otherwise, most = part.most](Option margin) {
          margin.otherwise(fmt::format("{:g}, or what --reserve makes of it", otherwise))
              .between(0.0, most);
        }));
  }
  return all;
}

Options duration_options() {
  const FlipGroup group = FlipGroup::kDurations;
  using Longest = hopper::LongestPhases;
  const auto longest = [group](const std::string& name, const std::string& key,
                               double Longest::*phase_s, double least_s, const std::string& of) {
    return option(
        group, "--longest-" + name, "longest_" + key + "_s",
        [phase_s](auto& request) -> auto& { return request.plan.longest.*phase_s; },
        "How long " + of + " takes at most, in s", between(least_s, 10.0));
  };
  return {
      longest("first", "first", &Longest::first_s, 0.2, "the first phase"),
      longest("push-off", "push_off", &Longest::push_off_s, 0.02,
              "a phase between the first and the flight"),
      longest("flight", "flight", &Longest::flight_s, 0.05, "a flight"),
      longest("landing", "landing", &Longest::landing_s, 0.02,
              "a phase between the flight and the last"),
      longest("between", "between", &Longest::between_s, 0.05, "a stance between two flights"),
      longest("last", "last", &Longest::last_s, 0.4, "the last phase"),
  };
}

Options search_options() {
  const FlipGroup group = FlipGroup::kSearch;
  return {
      option(
          group, "--intervals", "intervals", [](auto& of) -> auto& { return of.plan.intervals; },
          "How many intervals the first mesh has, all phases of one flight together",
          integer_between(10, 2000)),
      option(
          group, "--integration-error", "integration_error_rad",
          [](auto& of) -> auto& { return of.plan.most_error_rad; },
          "How far a phase may end from where an independent integrator ends, in rad; the "
          "mesh is refined until it is less",
          between(1e-6, 0.1)),
      option(
          group, "--rounds", "rounds", [](auto& of) -> auto& { return of.plan.most_rounds; },
          "How often the mesh is refined, at most", integer_between(0, 50)),
      option(
          group, "--iterations", "iterations",
          [](auto& of) -> auto& { return of.plan.most_iterations; },
          "How many iterations the solver takes on one mesh, at most", integer_between(1, 1000000)),
      option(
          group, "--time-limit", "time_limit_s",
          [](auto& of) -> auto& { return of.plan.most_seconds; },
          "End the search after so many seconds, with the best so far and exit code 3",
          between(0.01, 1e7)),
      option(
          group, "--guess-noise", "guess_noise_rad",
          [](auto& of) -> auto& { return of.plan.guess_noise_rad; },
          "Standard deviation of what is added to the first guess's joint angles, in rad",
          between(0.0, 1.0)),
      option(
          group, "--seed", "seed", [](auto& of) -> auto& { return of.guess_seed; },
          "Seed of that noise",
          [](Option seed) { seed.integer_between(0, kGreatestSeed).needs("--guess-noise"); }),
  };
}

Options file_options() {
  const FlipGroup group = FlipGroup::kFiles;
  return {
      option(
          group, "-o,--output", "", [](auto& of) -> auto& { return of.motion_file; },
          "Write the plan to this CSV, a motion that `hopper check` and `hopper replay` "
          "read; only a plan is written. With --sweep: write its result to this file",
          file),
      of_one_plan(option(
          group, "--write-best", "", [](auto& of) -> auto& { return of.best_file; },
          "Where no plan is found, write the motion that comes closest to this CSV: it is "
          "no plan",
          file)),
      option(
          group, "--sample-step", "sample_step_s",
          [](auto& of) -> auto& { return of.plan.sample_s; },
          "Time between rows of the motion, in s", between(1e-5, 0.05)),
      of_one_plan(option(
          group, "--plot-momentum", "", [](auto& of) -> auto& { return of.momentum_file; },
          "Draw CAM (centroidal angular momentum), CAV (the mean angular velocity that goes with "
          "it) and the composite inertia about the lateral axis over time to this SVG or PNG",
          file)),
      of_one_plan(option(
          group, "--figures", "", [](auto& of) -> auto& { return of.figures_file; },
          "Draw the robot at moments of the motion to this SVG", file)),
      of_one_plan(option(
          group, "--report", "", [](auto& of) -> auto& { return of.report_file; },
          "Write a page with the plan and all that `hopper check` says of it to this HTML", file)),
      option(
          group, "--json", "", [](auto& of) -> auto& { return of.json; },
          "Print the answer as JSON"),
  };
}

/// How a motion is read that a search begins from, and how loads are counted.
Options motion_options() {
  const std::string contacts = "the motion's contact columns, else searched for";
  return {
      option(
          FlipGroup::kLoads, "--load-window", "load_window_s",
          [](auto& of) -> auto& { return of.warm.check.load_window_s; },
          "Time over which a transmission's load is averaged, in s", between(1e-6, 10.0)),
      option(
          FlipGroup::kWarm, "--warm", "warm",
          [](auto& of) -> auto& { return of.warm.trajectory_file; },
          "Begin from this motion of the robot, a CSV as `hopper check` reads it",
          [](Option warm) { warm.otherwise("a guess of its own"); }),
      option(
          FlipGroup::kContacts, "--contact-height", "contact_height_m",
          [](auto& of) -> auto& { return of.warm.check.contact.height_m; },
          "Height up to which points touch the ground in that motion, in m",
          [=](Option height) { height.otherwise(contacts).between(0.0, 10.0).needs("--warm"); }),
      option(
          FlipGroup::kContacts, "--contact-speed", "contact_speed_m_s",
          [](auto& of) -> auto& { return of.warm.check.contact.speed_m_s; },
          "Speed upwards or downwards up to which points touch the ground in that motion, in m/s",
          [=](Option speed) { speed.otherwise(contacts).between(0.0, 100.0).needs("--warm"); }),
  };
}

Options last_options() {
  return {
      of_one_plan(option(
          FlipGroup::kExplanation, "--explain", "explain",
          [](auto& of) -> auto& { return of.plan.explain; },
          "Where no plan is found, look for the smallest change of one thing (voltage, "
          "current, mass, a ratio) that makes one")),
      of_one_plan(option(
          FlipGroup::kFiles, "--timing", "", [](auto& of) -> auto& { return of.timing; },
          "State the seconds (runs then differ in bytes)")),
  };
}

Options all_options() {
  Options all;
  for (const auto& make : {task_options, duration_options, margin_options, search_options,
                           file_options, motion_options, last_options}) {
    for (HopperFlipOption& one : make()) all.push_back(std::move(one));
  }
  return all;
}

void add_group(FlipGroup group, command_line::Command& command, HopperFlipRequest& request) {
  for (const HopperFlipOption& option : hopper_flip_options()) {
    if (option.group == group) option.declare(command, request);
  }
}

}  // namespace

const std::vector<HopperFlipOption>& hopper_flip_options() {
  static const Options all = all_options();
  return all;
}

void add_hopper_flip_options(command_line::Command& command, HopperFlipRequest& request) {
  command.add_option("robot", request.warm.robot_file, "Document of kind robot").required();
  add_group(FlipGroup::kTask, command, request);
  add_group(FlipGroup::kDurations, command, request);
  add_group(FlipGroup::kMargins, command, request);
  add_operating_options(command, request.warm.operating);
  add_group(FlipGroup::kSearch, command, request);
  add_group(FlipGroup::kExplanation, command, request);
  add_group(FlipGroup::kLoads, command, request);
  add_group(FlipGroup::kWarm, command, request);
  add_column_options(command, request.warm, "--warm");
  add_group(FlipGroup::kContacts, command, request);
  add_sweep_options(command, request.sweep);
  add_group(FlipGroup::kFiles, command, request);
}

}  // namespace torquewright::cli
