// SPDX-License-Identifier: Apache-2.0
// The fuzzer sees what it is to see. Oracle: runs made by hand, each of which breaks one rule.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/cli/no_number.hpp"
#include "tests/fuzz/program/case_json.hpp"
#include "tests/fuzz/program/command_files.hpp"
#include "tests/fuzz/program/document_mutation.hpp"
#include "tests/fuzz/program/draw.hpp"
#include "tests/fuzz/program/experiment.hpp"
#include "tests/fuzz/program/minimise.hpp"
#include "tests/fuzz/program/rules.hpp"
#include "tests/fuzz/program/table_mutation.hpp"
#include "tests/fuzz/program/vocabulary.hpp"

namespace torquewright::fuzz {
namespace {

using Ran = Run;  // within a test, Run is one of GoogleTest's own

const std::string kKnee = "specs/actuator/d151_knee.json";

Ran good_run() {
  Ran run;
  run.one.arguments = {"actuator", "mor", kKnee, "-o", "x.json", "--json"};
  run.inputs = {kKnee};
  run.outputs = {"x.json"};
  run.outcome.exit_code = 0;
  run.outcome.out = "{\"torque_Nm\": 1}";
  run.changed = {"work/x.json"};
  run.written = {{"work/x.json", "{}"}};
  return run;
}

TEST(ProgramRules, LetAGoodRunPass) { EXPECT_EQ(breach_in(good_run(), {}).rule, ""); }

TEST(ProgramRules, SeeEveryKindOfBreach) {
  struct Bad {
    const char* rule;
    std::function<void(Ran&)> spoil;
  };
  const auto on_stderr = [](const char* text) {
    return [text](Ran& run) { run.outcome.err = text; };
  };
  const auto changes = [](const char* path) {
    return [path](Ran& run) { run.changed.emplace_back(path); };
  };
  for (const Bad& bad :
       std::vector<Bad>{{"sound", on_stderr("x.cpp:1: runtime error: signed integer overflow")},
                        {"sound", on_stderr("==1==ERROR: AddressSanitizer: heap-use-after-free")},
                        {"end", [](Ran& run) { run.outcome.has_ended = false; }},
                        {"exit_code", [](Ran& run) { run.outcome.exit_code = 70; }},
                        {"exit_code", [](Ran& run) { run.outcome.signal = 11; }},
                        {"sentence", [](Ran& run) { run.outcome.exit_code = 2; }},
                        {"sentence", [](Ran& run) { run.outcome.err.assign(6'000'000, 'x'); }},
                        {"numbers", [](Ran& run) { run.outcome.out = "from -nan to 1"; }},
                        {"numbers", [](Ran& run) { run.written[0].second = "[inf]"; }},
                        {"json", [](Ran& run) { run.outcome.out = "{\"a\": "; }},
                        {"json", [](Ran& run) { run.written[0].second = "{\"a\": "; }},
                        {"schema",
                         [](Ran& run) {
                           run.outcome.out = R"({"kind": "mor_need", "version": 1,
                             "torque_Nm": null})";
                         }},
                        {"files", changes("work/.torquewright-0.tmp")},
                        {"files", changes("tmp/left")},
                        {"files", changes("work/specs/actuator/d151_knee.json")},
                        {"files",
                         [](Ran& run) {
                           run.outcome.exit_code = 2;
                           run.outcome.err = "no";
                         }},
                        {"small", [](Ran& run) { run.outcome.processor_s = 11.0; }},
                        {"small", [](Ran& run) { run.outcome.resident_MB = 3000.0; }}}) {
    Ran run = good_run();
    bad.spoil(run);
    EXPECT_EQ(breach_in(run, {}).rule, bad.rule);
  }
}

// Who lets a search go on for a minute is no witness of a hang.
TEST(ProgramRules, LetASearchTakeWhatItWasGiven) {
  Ran run = good_run();
  run.outcome.processor_s = 65.0;
  run.one.arguments = {"hopper", "flip", "--time-limit", "60"};
  EXPECT_EQ(breach_in(run, {}).rule, "");
  run.one.arguments.back() = "50";
  EXPECT_EQ(breach_in(run, {}).rule, "small");
  run.one.arguments.back() = "no number";
  EXPECT_EQ(breach_in(run, {}).rule, "small");
}

// A folder around all files, and a file called nan, were taken for breaches.
TEST(ProgramRules, LetOutputsHaveAnyName) {
  Ran run = good_run();
  run.outputs = {".."};
  run.changed = {"log.csv"};
  EXPECT_EQ(breach_in(run, {}).rule, "");
  run = good_run();
  run.outputs.insert("nan");
  run.outcome.out = "written to nan";
  EXPECT_EQ(breach_in(run, {}).rule, "");
  run = good_run();
  run.outputs.insert("imported/");
  run.changed.emplace_back("work/imported/log.csv");
  EXPECT_EQ(breach_in(run, {}).rule, "");
}

// A journal is written before something else may be refused; no other output is.
TEST(ProgramRules, LetAJournalBeWrittenFirst) {
  Ran run = good_run();
  run.one.arguments = {"hopper", "check", "--sweep", "mass=12", "-o", "x.json"};
  run.outputs = outputs_of(run.one.arguments);
  run.changed = {"work/x.json.journal"};
  run.outcome.exit_code = 2;
  run.outcome.err = "no";
  EXPECT_EQ(breach_in(run, {}).rule, "");
  run.changed.emplace_back("work/x.json");
  EXPECT_EQ(breach_in(run, {}).rule, "files");
  run.changed = {"work/y.journal"};
  EXPECT_EQ(breach_in(run, {}).rule, "files");
}

TEST(ProgramRules, TakeForAJournalOnlyWhatIsNamedSo) {
  const Words line{"hopper", "replay", "--sweep-journal", "j", "-o", "out.json", "--report", "r"};
  EXPECT_TRUE(is_journal(line, "j"));
  EXPECT_TRUE(is_journal(line, "out.json.journal"));
  EXPECT_FALSE(is_journal(line, "out.json"));
  EXPECT_FALSE(is_journal(line, "r"));
}

TEST(ProgramRules, KnowWhatIsNoNumber) {
  for (const char* text : {"torque -nan Nm", "inf", "[inf,1]", "to inf.", "nan,nan",
                           "<script>/* SPDX-License-Identifier: MIT\n*/</script>is NaN"}) {
    EXPECT_TRUE(test::says_no_number(text)) << text;
  }
  for (const char* text : {"information, inf_x, financial", "inf.json is not here",
                           "<script>/* SPDX-License-Identifier: MIT\n*/ is NaN</script>"}) {
    EXPECT_FALSE(test::says_no_number(text)) << text;
  }
}

TEST(CommandFiles, AreFoundByWayOfOthers) {
  const Scene scene;
  const Words check{"hopper",
                    "check",
                    "specs/robot/hopper.json",
                    "specs/trajectory/hopper_flip.csv",
                    "--report",
                    "a.html",
                    "-o",
                    "b.json"};
  const auto inputs = inputs_of(check, scene);
  EXPECT_TRUE(inputs.contains(kKnee));  // which the robot names
  EXPECT_TRUE(inputs.contains("specs/trajectory/hopper_flip.csv"));
  EXPECT_EQ(outputs_of(check), (std::set<std::string>{"a.html", "b.json"}));
}

TEST(CommandFiles, KnowAFolderThatPagesAreWrittenInto) {
  EXPECT_EQ(outputs_of({"man", "--all", "pages"}), (std::set<std::string>{"pages"}));
}

// Every command is asked for its example, those of one word too.
TEST(Vocabulary, HoldsCommandsOfOneWordAndOfTwo) {
  const std::vector<DeclaredCommand> all = read_vocabulary(TORQUEWRIGHT_PROGRAM);
  for (const Words& name :
       {Words{"init"}, Words{"schema"}, Words{"man"}, Words{"completion"}, Words{"help"},
        Words{"identify"}, Words{"identify", "import"}, Words{"gearbox", "optimize"}}) {
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const DeclaredCommand& each) {
      return each.name == name;
    })) << name[0];
  }
}

TEST(Scene, IsMendedWhateverACaseDidToIt) {
  Scene scene;
  Case one;
  one.things[kKnee] = {Thing::Kind::kFile, "{"};
  one.things["specs/robot/hopper.json"] = {Thing::Kind::kPipe, ""};
  one.things["loop"] = {Thing::Kind::kLink, "loop"};
  one.things["../outside"] = {Thing::Kind::kFile, ""};
  scene.lay_out(one);
  EXPECT_EQ(fs::file_size(scene.path(kKnee)), 1u);
  EXPECT_TRUE(fs::is_fifo(scene.path("specs/robot/hopper.json")));
  EXPECT_FALSE(fs::exists(scene.path("../outside")));
  scene.mend();
  EXPECT_EQ(scene.look().size(), scene.examples().size());
  EXPECT_GT(fs::file_size(scene.path(kKnee)), 100u);
  EXPECT_TRUE(fs::is_regular_file(scene.path("specs/robot/hopper.json")));
}

TEST(Case, KeepsEveryByte) {
  std::string bytes;
  for (int i = 1; i < 256; ++i) bytes += static_cast<char>(i);
  Case one{{"actuator", bytes}, {}};
  one.things["na\xFFme"] = {Thing::Kind::kLink, bytes};
  const Case again = case_of(text_of(one));
  EXPECT_EQ(again.arguments, one.arguments);
  EXPECT_EQ(again.things.at("na\xFFme").content, bytes);
  EXPECT_EQ(again.things.at("na\xFFme").kind, Thing::Kind::kLink);
}

TEST(Case, OfANumberIsAlwaysTheSame) {
  const Scene scene;
  const std::vector<DeclaredCommand> vocabulary{{{"actuator", "mor"}, {{"--json", false, {}}}}};
  std::set<std::string> texts;
  for (std::uint64_t number = 0; number < 50; ++number) {
    const std::string text = text_of(draw_case(7, number, vocabulary, scene));
    EXPECT_EQ(text_of(draw_case(7, number, vocabulary, scene)), text);
    texts.insert(text);
  }
  EXPECT_GT(texts.size(), 45u);
}

TEST(Documents, StayDocumentsWithOtherNumbers) {
  const std::string text = R"({"kind": "rig", "version": 1, "a": [1.5, {"b~/": 2}], "c": 3})";
  Random random(1);
  std::set<std::string> texts;
  for (int i = 0; i < 200; ++i) {
    const auto changed = nlohmann::json::parse(with_other_numbers(text, random));
    EXPECT_EQ(changed["version"], 1);
    EXPECT_EQ(changed.size(), 4u);
    texts.insert(changed.dump());
  }
  EXPECT_GT(texts.size(), 150u);
}

// The breach needs one word and one character of one file.
// A run that is a copy of a process is one that was started: same words, same files, same end.
TEST(Copies, DoWhatTheProgramDoes) {
  Experiment anew(TORQUEWRIGHT_PROGRAM, {});
  Experiment copied(TORQUEWRIGHT_PROGRAM, {}, TORQUEWRIGHT_FORK_SERVER);
  const Words table{"actuator", "mor", kKnee, "-o", "table.csv", "--plot", "region.svg"};
  for (const Words& words : {table, Words{"actuator", "mor", "none.json"}, Words{"schema", "robot"},
                             Words{"actuator", "mor", kKnee, "-o", kKnee}}) {
    const Ran expected = anew.perform({words, {}}), run = copied.perform({words, {}});
    EXPECT_EQ(run.outcome.exit_code, expected.outcome.exit_code);
    EXPECT_EQ(run.outcome.out, expected.outcome.out);
    EXPECT_EQ(run.outcome.err, expected.outcome.err);
    EXPECT_EQ(run.written, expected.written);
  }
}

TEST(Minimiser, LeavesWhatTheBreachNeeds) {
  Case one{{"a", "b", "--bad", "c"}, {}};
  one.things["x.csv"] = {Thing::Kind::kFile, std::string(500, 'x') + "!" + std::string(300, 'y')};
  one.things["y.csv"] = {Thing::Kind::kFile, "z"};
  const auto breaks = [](const Case& smaller) {
    const auto file = smaller.things.find("x.csv");
    const Words& words = smaller.arguments;
    return file != smaller.things.end() && file->second.content.find('!') != std::string::npos &&
           std::find(words.begin(), words.end(), "--bad") != words.end();
  };
  const Case small = minimised(one, breaks, 300);
  EXPECT_EQ(small.arguments, Words{"--bad"});
  EXPECT_EQ(small.things.size(), 1u);
  EXPECT_EQ(small.things.at("x.csv").content, "!");
}

}  // namespace
}  // namespace torquewright::fuzz
