// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/log_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "identification/reading/read_log.hpp"
#include "io/files/sha256.hpp"
#include "tests/identification/log/written_log.hpp"

namespace torquewright::identification {
namespace {

using test::read;
using test::ReadLog;

const nlohmann::json kPlain = test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}});
const nlohmann::json kRuns =
    test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}, {"run", "run"}});

/// Rows "t,q" at 100 Hz from `begin` to before `end`, q = t^2.
std::string rows(int begin, int end, const std::string& prefix = "") {
  std::string text;
  for (int i = begin; i < end; ++i)
    text += fmt::format("{}{},{}\n", prefix, 0.01 * i, 1e-4 * i * i);
  return text;
}

std::vector<std::string> names(const Log& log) {
  std::vector<std::string> result;
  for (const Run& run : log.runs) result.push_back(run.name);
  return result;
}

TEST(ReadLog, ScalesAndSorts) {
  nlohmann::json rig = kPlain;
  rig["columns"]["t"] = {{"quantity", "time_s"}, {"scale", 0.001}};
  rig["columns"]["T"] = {{"quantity", "case_temperature_K"}, {"offset", 273.15}};
  rig["ignore"] = {"note", "absent"};
  rig["holdout_runs"] = {"b"};
  const ReadLog result = read(
      {{"a.csv", "T,note,q,t\n20,hot,1,0\n21,\"x,y\",2,10\n"}, {"b.csv", "t,q,T\n5,3,22\n"}}, rig);
  ASSERT_EQ(result.refusal, "");
  ASSERT_EQ(names(result.log), (std::vector<std::string>{"a", "b"}));
  const auto& run = result.log.runs[0];
  EXPECT_EQ(run.time_s, (std::vector<double>{0.0, 0.01}));
  ASSERT_EQ(run.joints.size(), 1u);
  EXPECT_EQ(run.joints[0][Quantity::kOutputPosition], (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(run.joints[0][Quantity::kCaseTemperature], (std::vector<double>{293.15, 294.15}));
  EXPECT_FALSE(run.joints[0].has(Quantity::kMotorCurrent));
  EXPECT_EQ(run.masked.size(), 2u);
  EXPECT_EQ(result.log.train_runs, std::vector<std::string>{"a"});
  EXPECT_EQ(result.log.holdout_runs, std::vector<std::string>{"b"});
}

// Oracle: the names. A scale of the rig's may stand for whatever the name says.
TEST(ReadLog, DoubtsUnitsThatContradictANameOrARow) {
  const auto doubt = [](const nlohmann::json& use, const std::string& name,
                        const std::string& row) {
    nlohmann::json rig = test::rig_json({{"t", "time_s"}});
    rig["columns"][name] = use;
    const std::string log = "t," + name + "\n" + row + "0,1\n0.01,2\n0.02,4\n";
    const std::string said = read({{"a.csv", log}}, rig).finding("is read in").sentence;
    return said.substr(std::min(said.find('"'), said.size()));  // behind the file
  };
  const char* velocity = "output_velocity_rad_s";
  EXPECT_EQ(doubt(velocity, "speed_rpm", ""),
            "\"speed_rpm\" is read in rad/s, since the rig states no unit, though its name "
            "ends in rpm");
  EXPECT_EQ(doubt({{"quantity", velocity}, {"unit", "deg/s"}}, "speed [rpm]", ""),
            "\"speed [rpm]\" is read in deg/s, as the rig says, though its name ends in rpm");
  EXPECT_EQ(doubt({{"quantity", velocity}, {"unit", "rpm"}}, "speed", "s,deg/s\n"),
            "\"speed\" is read in rpm, as the rig says, though the row under the header says "
            "deg/s");
  EXPECT_EQ(doubt({{"quantity", velocity}, {"unit", "rpm"}}, "speed_rpm", ""), "");
  EXPECT_EQ(doubt({{"quantity", velocity}, {"scale", 0.1}}, "speed_rpm", ""), "");
  EXPECT_EQ(doubt(velocity, "speed_rad_s", ""), "");
  EXPECT_EQ(doubt(velocity, "speed", "s,rpm\n"), "");
}

// Oracle: the numbers by hand. The rig's unit goes before the row's; a row that contradicts the
// quantity is refused.
TEST(ReadLog, TakesTheUnitsUnderTheHeader) {
  const auto log = [](const std::string& units) {
    return "t;q;T\n" + units + "\n0;90;20,5\n10;180;20,5\n20;180;20,5\n";
  };
  nlohmann::json rig = kPlain;
  rig["columns"]["T"] = "case_temperature_K";
  ReadLog result = read({{"a.csv", log("ms;deg;degC")}}, rig);
  ASSERT_EQ(result.refusal, "");
  EXPECT_EQ(result.log.runs[0].time_s.back(), 0.01);
  EXPECT_DOUBLE_EQ(result.log.runs[0].joints[0][Quantity::kOutputPosition][0], M_PI / 2.0);
  EXPECT_DOUBLE_EQ(result.log.runs[0].joints[0][Quantity::kCaseTemperature][0], 293.65);
  EXPECT_NE(result.finding("row under the header").sentence, "");
  EXPECT_NE(result.finding("separated by semicolons, decimals are commas").sentence, "");
  EXPECT_EQ(read({{"a.csv", log("ms;A;degC")}}, rig).refusal,
            "a.csv: column \"q\": the unit under the header, A, is not one of output_position_rad, "
            "which the rig says it is");
  rig["columns"]["q"] = {{"quantity", "output_position_rad"}, {"scale", 1.0}};
  result = read({{"a.csv", log("ms;deg;degC")}}, rig);
  EXPECT_EQ(result.log.runs[0].joints[0][Quantity::kOutputPosition][0], 90.0);
}

// Oracle: the straight line. A channel that is asked less often; a pause that is too long for a
// line; a temperature that holds; a channel that begins late.
TEST(ReadLog, FillsEmptyCellsAndMasksWhereNothingIsNear) {
  nlohmann::json rig = kPlain;
  rig["columns"]["i"] = "motor_current_A";
  rig["columns"]["T"] = "case_temperature_K";
  std::string text = "t,q,i,T\n";
  for (int k = 0; k < 60; ++k) {
    const bool has_current = k >= 2 && (k < 20 ? k % 2 == 0 : k >= 40);
    text += fmt::format("{},{},{},{}\n", 0.01 * k, 0.001 * k * k,
                        has_current ? fmt::format("{}", 0.1 * k) : "", k == 0 ? "300" : "");
  }
  const ReadLog result = read({{"a.csv", text}}, rig);
  ASSERT_EQ(result.refusal, "");
  std::vector<double> current;
  std::vector<int> masked;
  for (const auto& run : result.log.runs) {
    const auto& values = run.joints[0][Quantity::kMotorCurrent];
    current.insert(current.end(), values.begin(), values.end());
    masked.insert(masked.end(), run.masked.begin(), run.masked.end());
    for (const double T : run.joints[0][Quantity::kCaseTemperature]) EXPECT_EQ(T, 300.0);
  }
  ASSERT_EQ(current.size(), 60u);
  for (std::size_t k = 2; k < 19; ++k) {
    EXPECT_NEAR(current[k], 0.1 * static_cast<double>(k), 1e-12) << k;
    EXPECT_EQ(masked[k], 0) << k;
  }
  for (const std::size_t k : {0u, 1u, 20u, 39u}) EXPECT_EQ(masked[k], 1) << k;
  EXPECT_EQ(masked[40], 0);
  EXPECT_NE(result.finding("motor_current_A: 31 empty cells").sentence.find("are masked"),
            std::string::npos);
  EXPECT_NE(result.finding("case_temperature_K: 59 empty cells: the last number holds").sentence,
            "");
}

// A held-out run that is a copy of a fitted one says nothing of other data.
TEST(ReadLog, RefusesTheSameLogUnderTwoNames) {
  const std::string text = "t,q\n" + rows(0, 5), longer = "t,q\n" + rows(0, 6);
  EXPECT_EQ(read({{"a.csv", text}, {"b.csv", longer}, {"c.csv", text}}, kPlain).refusal,
            "c.csv: holds the same as a.csv, byte for byte; a run that is held out must not be one "
            "that was fitted: leave one of them out");
  EXPECT_EQ(read({{"a.csv", text}, {"b.csv", longer}}, kPlain).refusal, "");
}

// Just inside and just outside of half a second, the longest step in which a motion can be seen.
TEST(ReadLog, SaysThatLongStepsLookLikeMilliseconds) {
  const auto finding = [](const char* step) {
    std::string text = "t,q\n";
    for (int i = 0; i < 10; ++i) text += fmt::format("{},{}\n", i * std::stod(step), i);
    const ReadLog result = read({{"a.csv", text}}, kPlain);
    for (const DataFinding& each : result.log.findings) {
      if (each.sentence.find("look like ms") != std::string::npos) return each.sentence;
    }
    return std::string();
  };
  EXPECT_EQ(finding("0.49"), "");
  EXPECT_EQ(finding("5"),
            "the median step of run \"a\" is 5 s: the times look like ms; write {\"quantity\": "
            "\"time_s\", \"unit\": \"ms\"} for the column \"t\"");
}

// Oracle: the range of --winding-temperature, just inside and just outside; 25 K are 298 K if they
// are degrees Celsius, a million is no temperature of either.
TEST(ReadLog, RefusesTemperaturesThatNoMotorWorksAt) {
  nlohmann::json rig = kPlain;
  for (const std::string quantity : {"winding_temperature_K", "case_temperature_K"}) {
    rig["columns"]["T"] = quantity;
    const auto refusal = [&](const std::string& last) {
      return read({{"a.csv", "t,q,T\n0,1,300\n0.01,2," + last + "\n"}}, rig).refusal;
    };
    const std::string place = "a.csv: line 3, column 3 (T): " + quantity;
    const std::string hint = "; degrees Celsius? In the rig, write {\"quantity\": \"" + quantity +
                             "\", \"unit\": \"degC\"} for the column \"T\"";
    EXPECT_EQ(refusal("200"), "");
    EXPECT_EQ(refusal("600"), "");
    EXPECT_EQ(refusal("25.05"), place + " of 25.05 K is outside of 200 to 600 K" + hint);
    EXPECT_EQ(refusal("-40"), place + " of -40 K is outside of 200 to 600 K" + hint);
    EXPECT_EQ(refusal("199.9"), place + " of 199.9 K is outside of 200 to 600 K" + hint);
    EXPECT_EQ(refusal("600.1"), place + " of 600.1 K is outside of 200 to 600 K");
    EXPECT_EQ(refusal("1e6"), place + " of 1e+06 K is outside of 200 to 600 K");
    rig["columns"]["T"] = {{"quantity", quantity}, {"unit", "degC"}};
    EXPECT_EQ(refusal("21"), "");
  }
}

// Oracle: the rows' own steps; a double near 1.7e9 is a multiple of 2^-22 s.
TEST(ReadLog, CountsAClockSinceAnEpochFromTheFirstRow) {
  const std::string text = "t,q\n1700000000.25,0\n1700000000.26,1\n1700000000.27,4\n";
  const ReadLog result = read({{"bag.csv", text}}, kPlain);
  ASSERT_EQ(result.refusal, "");
  const auto& time_s = result.log.runs.front().time_s;
  ASSERT_GE(time_s.size(), 2u);
  EXPECT_EQ(time_s.front(), 0.0);
  EXPECT_NEAR(time_s[1], 0.01, 0x1p-22);
  EXPECT_NE(result.finding("bag.csv: times are counted from the first row, 1700000000.25 s of the")
                .sentence,
            "");
}

TEST(ReadLog, RefusesARunBackwardsByTheFilesOwnClock) {
  const ReadLog result = read({{"bag.csv", "t,q\n1700000000.5,0\n1700000000.25,1\n"}}, kPlain);
  EXPECT_NE(result.refusal.find("time runs backwards: 1700000000.25 s follows 1700000000.5 s"),
            std::string::npos)
      << result.refusal;
}

TEST(ReadLog, NamesFilesWithTheirHash) {
  const std::string text = "t,q\n0,1\n1,2\n2,4\n";
  const ReadLog result = read({{"a.csv", text}}, kPlain);
  ASSERT_EQ(result.log.files.size(), 1u);
  EXPECT_EQ(result.log.files[0].sha256, io::sha256(text));
}

TEST(ReadLog, NamesRunsByColumnAndByFileWhereNamesRepeat) {
  const ReadLog result =
      read({{"one.csv", "run,t,q\na,0,1\na,1,2\nb,0,1\n"}, {"two.csv", "run,t,q\nb,0,1\nc,0,1\n"}},
           kRuns);
  EXPECT_EQ(result.refusal, "");
  EXPECT_EQ(names(result.log), (std::vector<std::string>{"a", "one/b", "two/b", "c"}));
}

TEST(ReadLog, RefusesTwoRunsOfOneName) {
  const test::ScratchFolder folder;
  const auto file = folder.write("m.csv", "t,q\n0,1\n");
  EXPECT_NE(test::refusal([&] {
              read_log({file, file}, test::rig_of(kPlain));
            }).find("its run \"m\" has the name of one of"),
            std::string::npos);
}

TEST(ReadLog, PutsSharedColumnsIntoEveryJoint) {
  nlohmann::json rig = nlohmann::json::parse(R"({"kind": "rig", "version": 1, "columns":
    {"t": "time_s", "b": {"quantity": "output_position_rad", "joint": "hip"},
     "a": {"quantity": "output_position_rad", "joint": "knee"}, "V": "bus_voltage_V"},
    "load": {"type": "serial_arm", "links": [
     {"joint": "hip", "mass_kg": 1, "length_m": 1, "center_of_mass_m": 0.5, "inertia_kg_m2": 0.1},
     {"joint": "knee", "mass_kg": 2, "length_m": 1, "center_of_mass_m": 0.5, "inertia_kg_m2": 0.1}]}})");
  const ReadLog result = read({{"m.csv", "t,a,b,V\n0,1,2,48\n1,3,4,47\n2,5,6,46\n"}}, rig);
  ASSERT_EQ(result.refusal, "");
  const auto& run = result.log.runs[0];
  ASSERT_EQ(run.joints.size(), 2u);
  EXPECT_EQ(run.joints[0][Quantity::kOutputPosition], (std::vector<double>{2, 4}));
  EXPECT_EQ(run.joints[1][Quantity::kOutputPosition], (std::vector<double>{1, 3}));
  for (const Channels& joint : run.joints) {
    EXPECT_EQ(joint[Quantity::kBusVoltage], (std::vector<double>{48, 47}));
  }
}

TEST(ReadLog, RefusesWithThePlace) {
  const auto refusal = [](const std::string& text, const nlohmann::json& rig) {
    return read({{"m.csv", text}}, rig).refusal;
  };
  EXPECT_EQ(refusal("t,q\n0,1\nnan,2\n", kPlain),
            "m.csv: line 3, column 1 (t): \"nan\" is not a finite number");
  EXPECT_EQ(refusal("t,q\n0,1\n1,-inf\n", kPlain),
            "m.csv: line 3, column 2 (q): \"-inf\" is not a finite number");
  EXPECT_EQ(refusal("t,q\n1,1\n1,2\n1,3\n", kPlain),
            "m.csv: time stands still at 1 s in run \"m\"");
  EXPECT_EQ(refusal("run,t,q\na,0,1\na,1,2\na,0.5,3\n", kRuns),
            "m.csv: line 4, column 2 (t): time runs backwards: 0.5 s follows 1 s of line 3");
  EXPECT_NE(refusal("t,q\n0,1\n1,2\n0,3\n", kPlain).find("if another run begins here"),
            std::string::npos);
  EXPECT_EQ(refusal("t,qq\n0,1\n", kPlain),
            "m.csv: no column \"q\", which the rig names as output_position_rad; did you mean "
            "\"qq\"?\nm.csv: column \"qq\" is not in the rig; say under \"columns\" what it is, or "
            "list it under \"ignore\"");
  EXPECT_EQ(refusal("t,q\n", kPlain), "m.csv: holds no samples, only the names of columns");
  EXPECT_EQ(refusal("run,t,q\na,0,1\nb,0,1\na,1,1\n", kRuns),
            "m.csv: line 4, column 1 (run): run \"a\" stands in two places; the rows of a run must "
            "follow one another");
  EXPECT_EQ(refusal("run,t,q\n,0,1\n", kRuns),
            "m.csv: line 2, column 1 (run): empty, must name the run");
  EXPECT_EQ(refusal("t,q\n0,1\n1,1e400\n", kPlain),
            "m.csv: line 3, column 2 (q): \"1e400\" is not a finite number");
  EXPECT_EQ(refusal("t,q\n0,1\n1,-1e39\n", kPlain),
            "m.csv: line 3, column 2 (q): too large in SI units, in which 3.403e+38 is the most; "
            "is its unit the one that is stated?");
  EXPECT_EQ(refusal("t,q\n0,1\n1e39,1\n", kPlain),
            "m.csv: line 3, column 1 (t): too large in SI units, in which 3.403e+38 is the most; "
            "is its unit the one that is stated?");
}

// Oracle: the gaps put in. The first is noticed late, when the median is known; the second at once.
TEST(ReadLog, CutsAtGapsAndSaysSo) {
  const std::string text = "run,t,q\n" + rows(0, 300, "a,") + rows(400, 1400, "a,") +
                           rows(1406, 1700, "a,") + rows(1704, 1900, "a,") + rows(0, 50, "b,");
  const ReadLog result = read({{"m.csv", text}}, kRuns);
  ASSERT_EQ(result.refusal, "");
  ASSERT_EQ(names(result.log), (std::vector<std::string>{"a", "a", "a", "b"}));
  EXPECT_EQ(result.log.runs[0].time_s.size(), 300u);
  EXPECT_EQ(result.log.runs[1].time_s.size(), 1000u);
  EXPECT_EQ(result.log.runs[2].time_s.size(), 490u);  // 4 steps are no gap
  EXPECT_EQ(result.log.runs[2].joints[0][Quantity::kOutputPosition].front(), 1e-4 * 1406 * 1406);
  EXPECT_EQ(result.finding("2 gaps in time, the longest 1.01 s after t = 2.99 s").weight,
            Weight::kWarning);
}

/// A log of 100 Hz that skips a time before a row, and a second run.
ReadLog with_skip(int at, double skipped_s, const char* position = "1") {
  std::string text = "run,t,q\n";
  for (int i = 0; i < 1600; ++i) {
    text += fmt::format("a,{:.5f},{}\n", 0.01 * i + (i < at ? 0.0 : skipped_s),
                        i < at ? "1" : position);
  }
  return read({{"m.csv", text + "b,0,1\nb,1,1\n"}}, kRuns);
}

// Just inside and just outside of 5 medians, before and after the median is known.
TEST(ReadLog, SaysWhereAStepIsLongerThanFiveMedians) {
  for (const int at : {50, 1300}) {
    EXPECT_EQ(with_skip(at, 0.0399).finding("pauses").sentence, "") << at;
    const ReadLog paused = with_skip(at, 0.0401);
    EXPECT_EQ(paused.finding("run \"a\" pauses 1 time, at the longest for 0.0501 s").weight,
              Weight::kWarning)
        << at;
    EXPECT_EQ(paused.log.runs.size(), 2u) << at;
  }
}

// Just inside and just outside of a period of 8 Hz; and across an angle that may have turned either
// way.
TEST(ReadLog, CutsAtAPauseThatHidesAPeriodOfTheBand) {
  for (const int at : {50, 1300}) {
    EXPECT_EQ(with_skip(at, 0.1149).log.runs.size(), 2u) << at;
    EXPECT_EQ(with_skip(at, 0.1151).log.runs.size(), 3u) << at;
    EXPECT_EQ(with_skip(at, 0.05, "2.57").log.runs.size(), 2u) << at;  // 1.57 rad on
    EXPECT_EQ(with_skip(at, 0.05, "2.58").log.runs.size(), 3u) << at;
  }
}

TEST(ReadLog, LosesNoSampleWhereverAGapLies) {
  for (const int at : {1, 2, 500, 999, 1000, 1001, 1002, 1499}) {
    const std::string text = "t,q\n" + rows(0, at) + rows(at + 100, 1600);
    nlohmann::json rig = kPlain;
    const test::ScratchFolder folder;
    const Rig read_rig = test::rig_of(rig);
    LogReader reader({folder.write("m.csv", text)}, read_rig);
    std::vector<double> time_s;
    std::vector<std::size_t> lengths;
    for (Stretch stretch; reader.next_stretch(stretch);) {
      lengths.push_back(stretch.run.time_s.size());
      EXPECT_EQ(stretch.gap.has_value(), lengths.size() == 2);
      time_s.insert(time_s.end(), stretch.run.time_s.begin(), stretch.run.time_s.end());
    }
    EXPECT_EQ(lengths, (std::vector<std::size_t>{static_cast<std::size_t>(at),
                                                 static_cast<std::size_t>(1500 - at)}));
    EXPECT_TRUE(std::is_sorted(time_s.begin(), time_s.end()));
  }
}

/// The first run's times; with a second run, so that it is not cut for the hold-out.
std::vector<double> times(const ReadLog& result) { return result.log.runs[0].time_s; }

TEST(ReadLog, CountsRowsThatRepeatOnce) {
  const ReadLog result = read(
      {{"a.csv", "t,q\n0,1\n0.1,2\n0.1,2\n0.1,2\n0.2,2\n"}, {"b.csv", "t,q\n0,1\n1,2\n"}}, kPlain);
  ASSERT_EQ(result.refusal, "");
  EXPECT_EQ(times(result), (std::vector<double>{0.0, 0.1, 0.2}));
  EXPECT_EQ(result.finding("2 rows of equal time and values: counted once in run \"a\"").weight,
            Weight::kNote);
}

// Oracle: 2 kHz, written to the millisecond; the last stamp has no next one.
TEST(ReadLog, SpreadsRowsOfARoundedTime) {
  std::string text = "t,q\n";
  for (int i = 0; i < 3000; ++i) text += fmt::format("{:.3f},{}\n", 0.001 * (i / 2), i);
  const ReadLog result = read({{"a.csv", text}, {"b.csv", "t,q\n0,1\n1,2\n"}}, kPlain);
  ASSERT_EQ(result.refusal, "");
  ASSERT_EQ(result.log.runs.size(), 2u);
  ASSERT_EQ(times(result).size(), 3000u);
  for (int i = 0; i < 3000; ++i)
    EXPECT_NEAR(times(result)[static_cast<std::size_t>(i)], 0.0005 * i, 1e-9);
  EXPECT_EQ(result.finding("1500 rows of other values at the time of the row before").weight,
            Weight::kWarning);
}

// A gap is no time to spread over.
TEST(ReadLog, SpreadsNoRowIntoAGap) {
  const ReadLog result = read(
      {{"a.csv", "t,q\n0,0\n0.1,1\n0.2,2\n0.2,3\n9,4\n"}, {"b.csv", "t,q\n0,1\n1,2\n"}}, kPlain);
  ASSERT_EQ(result.refusal, "");
  ASSERT_EQ(times(result).size(), 4u);
  EXPECT_NEAR(times(result)[3], 0.25, 1e-12);
}

TEST(ReadLog, RefusesTimeThatStandsStill) {
  std::string text = "t,q\n0,0\n";
  for (int i = 0; i < 100; ++i) text += fmt::format("1,{}\n", i);
  EXPECT_EQ(read({{"m.csv", text + "2,0\n"}, {"b.csv", "t,q\n0,1\n1,2\n"}}, kPlain).refusal, "");
  EXPECT_EQ(read({{"m.csv", text + "1,-1\n2,0\n"}}, kPlain).refusal,
            "m.csv: line 103, column 1 (t): time stands still: more than 100 rows have 1 s");
}

TEST(ReadLog, LeavesOutALastLineThatIsCut) {
  const auto cut = [](const std::string& end) {
    return read(
        {{"a.csv", "t,q,i\n0,0,1\n1,1,2\n2,4,3\n" + end}, {"b.csv", "t,q,i\n0,1,1\n1,2,1\n"}},
        test::rig_json({{"t", "time_s"}, {"q", "output_position_rad"}, {"i", "duty"}}));
  };
  for (const char* end : {"3,9", "3", "3,9\n", "3,9\n\n"}) {
    const ReadLog result = cut(end);
    ASSERT_EQ(result.refusal, "") << end;
    EXPECT_EQ(times(result), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(result.finding("a.csv: the last line, 5, ends within the row").weight, Weight::kNote);
  }
  EXPECT_EQ(cut("3,9\n4,9,1\n").refusal, "a.csv: line 5: has 2 cells, the header has 3");
  EXPECT_EQ(cut("3,9,1,1\n").refusal.find("a.csv: line 5: has 4 cells"), 0u);
}

TEST(ReadLog, RefusesHoldoutRunsThatDoNotExist) {
  nlohmann::json rig = kPlain;
  rig["holdout_runs"] = {"steep_70", "x"};
  const test::NamedTexts files = {{"step_70.csv", "t,q\n0,1\n"}, {"step_20.csv", "t,q\n0,2\n"}};
  EXPECT_EQ(read(files, rig).refusal,
            "rig.json#/holdout_runs/0: no run \"steep_70\"; did you mean \"step_70\"?\n"
            "rig.json#/holdout_runs/1: no run \"x\"; there are step_70, step_20");
  rig["holdout_runs"] = {"step_70", "step_20"};
  EXPECT_EQ(read(files, rig).refusal,
            "rig.json#/holdout_runs: holds out every run; nothing is left to fit");
}

// Oracle: ceil(n/3) by hand.
TEST(ReadLog, HoldsOutTheLastThirdOfTheRuns) {
  for (const auto& [count, held] :
       std::vector<std::pair<int, std::size_t>>{{2, 1}, {3, 1}, {4, 2}, {7, 3}}) {
    test::NamedTexts files;
    for (int i = 0; i < count; ++i) {
      files.push_back({fmt::format("r{}.csv", i), fmt::format("t,q\n0,1\n1,{}\n", i)});
    }
    const Log log = read(files, kPlain).log;
    EXPECT_EQ(log.holdout_runs.size(), held);
    EXPECT_EQ(log.holdout_runs.back(), fmt::format("r{}", count - 1));
    EXPECT_EQ(log.train_runs.size() + held, static_cast<std::size_t>(count));
  }
}

TEST(ReadLog, HoldsOutTheLastThirdOfTheOnlyRun) {
  const ReadLog result = read({{"m.csv", "t,q\n" + rows(0, 300) + rows(400, 700)}}, kPlain);
  ASSERT_EQ(
      names(result.log),
      (std::vector<std::string>{"m (first two thirds)", "m (first two thirds)", "m (last third)"}));
  EXPECT_EQ(result.log.runs[1].time_s.size(), 100u);
  EXPECT_EQ(result.log.runs[2].time_s.size(), 200u);
  EXPECT_EQ(result.log.train_runs, std::vector<std::string>{"m (first two thirds)"});
  EXPECT_EQ(result.log.holdout_runs, std::vector<std::string>{"m (last third)"});
  EXPECT_EQ(result.finding("its last third is held out").weight, Weight::kNote);
}

TEST(ReadLog, ReadsAMapWithoutTime) {
  const ReadLog result =
      read({{"m.csv", "q,i\n0,1\n0.5,2\n1,1\n"}},
           test::rig_json({{"q", "motor_position_rad"}, {"i", "motor_current_A"}}));
  EXPECT_EQ(result.refusal, "");
  EXPECT_TRUE(result.log.runs[0].time_s.empty());
  EXPECT_EQ(result.log.runs[0].joints[0][Quantity::kMotorCurrent].size(), 2u);
  EXPECT_EQ(result.log.runs[1].joints[0][Quantity::kMotorCurrent].size(), 1u);
}

}  // namespace
}  // namespace torquewright::identification
