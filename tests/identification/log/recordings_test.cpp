// SPDX-License-Identifier: Apache-2.0
// Joint states of recordings of ROS 2, as `identify import` reads them. Oracle: files of other
// writers. legs.mcap was written by npm's @mcap/core 2.2 and @foxglove/rosmsg2-serialization, of
// closed forms; the others are written here by Python: MCAP and CDR byte by byte as
// https://mcap.dev/spec and OMG's XTypes say, packed by the programs lz4 and zstd, bags by Python's
// sqlite3 with rosbag2's tables.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "identification/imports/files_json.hpp"
#include "identification/imports/importer.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/foreign_writers.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kLegs = TORQUEWRIGHT_SOURCE_DIR "/tests/fuzz/corpus/imports/legs.mcap";

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (line.ends_with(',')) row.emplace_back();
  }
  return rows;
}

/// Writers that share nothing with the reader, put before each program.
constexpr const char* kWriters = R"py(
import json, os, sqlite3, struct, subprocess, zlib
START = 1767225600 * 10**9
def text(s):
    b = s.encode() + b"\0"
    return struct.pack("<I", len(b)) + b
def cdr(ns, names, lists, form=b"\0\1\0\0", wide=8):
    out = struct.pack("<iI", ns // 10**9, ns % 10**9) + text("")
    def pad(n):
        nonlocal out
        out += bytes(-len(out) % n)
    pad(4); out += struct.pack("<I", len(names))
    for n in names:
        pad(4); out += text(n)
    for values in lists:
        pad(4); out += struct.pack("<I", len(values))
        if values: pad(wide)
        out += struct.pack(f"<{len(values)}d", *values)
    return form + out
def as_json(ns, names, lists):
    return json.dumps({"header": {"stamp": {"sec": ns // 10**9, "nanosec": ns % 10**9}, "frame_id": ""},
                       "name": names, "position": lists[0], "velocity": lists[1], "effort": lists[2]}).encode()
def record(op, content): return struct.pack("<BQ", op, len(content)) + content
def s(v): return struct.pack("<I", len(v)) + (v.encode() if isinstance(v, str) else v)
def message(channel, ns, data):
    return record(5, struct.pack("<HIQQ", channel, 0, ns, ns) + data)
def packed(data, by):
    if by in ("lz4", "zstd"):
        return subprocess.run([by, "-q", "-c"], input=data, capture_output=True, check=True).stdout
    return data
def chunk(data, by, crc=None):
    z = packed(data, by)
    return record(6, struct.pack("<QQQI", 0, 0, len(data), zlib.crc32(data) if crc is None else crc) + s(by) +
                  struct.pack("<Q", len(z)) + z)
MAGIC = b"\x89MCAP0\r\n"
HEAD = MAGIC + record(1, s("ros2") + s(""))
END = record(15, bytes(4)) + record(2, bytes(20)) + MAGIC
def channel(id, topic, encoding, type="sensor_msgs/msg/JointState"):
    return record(3, struct.pack("<H", id) + s(type) + s("ros2msg") + s("")) + \
           record(4, struct.pack("<HH", id, id) + s(topic) + s(encoding) + struct.pack("<I", 0))
def mcap(name, rows, by="", encoding="cdr", end=END, write=None, crc=None):
    write = write or (cdr if encoding == "cdr" else as_json)
    body = HEAD
    for begin in range(0, len(rows), 7):
        part = channel(1, "/joint_states", encoding)
        for ns, names, lists in rows[begin:begin + 7]:
            part += message(1, ns + 10**5, write(ns, names, lists))
        body += chunk(part, by, crc) if by is not None else part
    open(name, "wb").write(body + end)
def bag(name, rows, pack=lambda b: b, type="sensor_msgs/msg/JointState"):
    db = sqlite3.connect(name)
    db.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
               "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)")
    db.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
               "timestamp INTEGER NOT NULL, data BLOB NOT NULL)")
    db.execute("CREATE INDEX timestamp_idx ON messages (timestamp ASC)")
    db.execute("INSERT INTO topics VALUES (3, '/joint_states', ?, 'cdr', '')", (type,))
    db.executemany("INSERT INTO messages(topic_id, timestamp, data) VALUES (3, ?, ?)",
                   [(ns + 10**5, pack(cdr(ns, names, lists))) for ns, names, lists in rows])
    db.commit(); db.close()
NAMES = ["hip", "knee"]
ROWS = [(START + 2_000_000 * i, NAMES, [[i / 8, -i / 3], [i * 0.5, 0.1], []]) for i in range(30)]
)py";

/// A log and its rig as they would be written.
struct Imported {
  std::string csv;
  json rig;
  std::string notes;
};

class Recordings : public testing::Test {
 protected:
  void written_by(const std::string& program) {
    test::run_python(folder_, std::string(kWriters) + program);
  }
  /// A file or folder of the test's own; absolute paths stay.
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  Imported import(const std::string& name, ImportRequest request = {}) const {
    request.files = {path(name)};
    const ImportedLog log = importer_of("mcap").read(request);
    Imported imported;
    imported_csv(log, [&](std::string_view piece) { imported.csv += piece; });
    imported.rig = json::parse(imported_rig(log, "made"));
    for (const std::string& note : log.notes) imported.notes += note + "\n";
    return imported;
  }
  std::string refused(const std::string& name, ImportRequest request = {}) const {
    return test::refusal([&] { import(name, std::move(request)); }, folder_.path());
  }
  /// The log without the name of its run.
  std::string log_of(const std::string& name, ImportRequest request = {}) const {
    std::string text;
    for (const std::vector<std::string>& row : rows_of(import(name, std::move(request)).csv)) {
      for (std::size_t i = 1; i < row.size(); ++i) text += row[i] + ",";
      text += '\n';
    }
    return text;
  }

  test::ScratchFolder folder_;
};

ImportRequest topics(const std::string& topic, const std::string& commands,
                     const std::string& joint) {
  ImportRequest request;
  request.topic = topic;
  request.commands = commands;
  request.joint = joint;
  return request;
}

ImportRequest by_recorders_clock() {
  ImportRequest request;
  request.by_recorders_clock = true;
  return request;
}

void expect_said(const std::string& all, const std::string& said) {
  EXPECT_NE(all.find(said), std::string::npos) << all;
}

// Of row i: hip i/8, knee -i/16, speeds 0.125 + i and i, efforts none and 0.1 i; commands of 0.5 j
// for the knee and -0.25 j for the hip came before rows j = 2, 6, 10, ...; the gripper stands
// still.
TEST_F(Recordings, OfAnotherWriterAreReadToTheLastBit) {
  const Imported imported = import(kLegs, topics("/joint_states", "/joint_commands", "knee*,hip*"));
  const auto rows = rows_of(imported.csv);
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"run", "time_s", "knee_joint_rad", "knee_joint_rad_s",
                                      "knee_joint_Nm", "knee_joint_commanded_rad", "hip_joint_rad",
                                      "hip_joint_rad_s", "hip_joint_commanded_rad"}));
  ASSERT_EQ(rows.size(), 41u);
  for (int i = 0; i < 40; ++i) {
    const int j = i < 2 ? -1 : i - (i - 2) % 4;
    const auto command = [&](double each) { return j < 0 ? "" : fmt::format("{}", each * j); };
    EXPECT_EQ(rows[static_cast<std::size_t>(i) + 1],
              (std::vector<std::string>{
                  "legs", fmt::format("{:.9f}", 0.005 * i), fmt::format("{}", i * (-1 / 16.0)),
                  fmt::format("{}", i), fmt::format("{}", 0.1 * i), command(0.5),
                  fmt::format("{}", i / 8.0), fmt::format("{}", 0.125 + i), command(-0.25)}))
        << i;
  }
  const json& columns = imported.rig["columns"];
  EXPECT_EQ(columns["knee_joint_commanded_rad"],
            (json{{"quantity", "commanded_position_rad"}, {"joint", "knee_joint"}}));
  EXPECT_EQ(columns["knee_joint_Nm"]["quantity"], "reported_torque_Nm");
}

// One joint needs no name: any load may stand in the rig.
TEST_F(Recordings, OfOneJointNameNone) {
  const Imported imported = import(kLegs, topics("/joint_states", "", "knee_joint"));
  EXPECT_EQ(imported.rig["columns"]["knee_joint_rad"], "output_position_rad");
}

TEST_F(Recordings, HoldTheSameHoweverTheyAreWritten) {
  written_by(R"py(
mcap("plain.mcap", ROWS, None)
mcap("chunks.mcap", ROWS)
mcap("lz4.mcap", ROWS, "lz4")
mcap("zstd.mcap", ROWS, "zstd")
mcap("json.mcap", ROWS, "zstd", "json")
mcap("second.mcap", ROWS, write=lambda *row: cdr(*row, form=b"\0\7\0\0", wide=4))
bag("bag.db3", ROWS)
bag("packed.db3", ROWS, lambda b: subprocess.run(["zstd", "-q", "-c", "--stream-size", str(len(b))],
                                                 input=b, capture_output=True, check=True).stdout)
os.mkdir("walk")
for part in range(11):
    (bag if part % 2 else mcap)(f"walk/walk_{part}." + ("db3" if part % 2 else "mcap"), ROWS[3 * part:3 * part + 3])
)py");
  std::string expected = "time_s,hip_rad,hip_rad_s,knee_rad,knee_rad_s,\n";
  for (int i = 0; i < 30; ++i) {
    expected += fmt::format("{:.9f},{},{},{},0.1,\n", 0.002 * i, i / 8.0, i * 0.5, -i / 3.0);
  }
  for (const char* file : {"plain", "chunks", "lz4", "zstd", "json", "second"}) {
    EXPECT_EQ(log_of(std::string(file) + ".mcap"), expected) << file;
  }
  EXPECT_EQ(log_of("bag.db3"), expected);
  EXPECT_EQ(log_of("packed.db3"), expected);
  EXPECT_EQ(log_of("walk"), expected);  // in the order of its parts' numbers
}

// A recorder that lost its power: whole messages are read, and it is said.
TEST_F(Recordings, ThatEndEarlyAreReadAsFarAsTheyGo) {
  written_by(R"py(
mcap("whole.mcap", ROWS[:21])
mcap("cut.mcap", ROWS, end=b"")
data = open("cut.mcap", "rb").read()
open("cut.mcap", "wb").write(data[:-20])
mcap("stopped.mcap", ROWS[:21], end=b"")
)py");
  const std::string whole = log_of("whole.mcap");
  EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 22);
  // The last chunk has two messages, and is not there in whole; the one before ends with row 28.
  const std::string cut = log_of("cut.mcap");
  EXPECT_EQ(std::count(cut.begin(), cut.end(), '\n'), 29);
  EXPECT_EQ(cut.substr(0, whole.size()), whole);
  expect_said(import("cut.mcap").notes, "in the middle of a record that begins at byte");
  EXPECT_EQ(log_of("stopped.mcap"), whole);
  expect_said(import("stopped.mcap").notes, "its recorder was stopped");
}

TEST_F(Recordings, AreRefusedByName) {
  written_by(R"py(
mcap("brotli.mcap", ROWS, "brotli")
mcap("spoilt.mcap", ROWS, crc=1)
mcap("ros1.mcap", ROWS, write=lambda *row: cdr(*row, form=b"\0\2\0\0"))
mcap("short.mcap", ROWS, write=lambda *row: cdr(*row)[:-9])
mcap("uneven.mcap", [(START, NAMES, [[1.0], [], []])])
mcap("words.mcap", [(START, NAMES, [["a", "b"], [], []])], encoding="json")
mcap("ours.mcap", ROWS, encoding="protobuf", write=cdr)
open("tf.mcap", "wb").write(HEAD + channel(1, "/tf", "cdr", "tf2_msgs/msg/TFMessage") + message(1, 5, b"x") + END)
bag("tf.db3", ROWS, type="tf2_msgs/msg/TFMessage")
bag("no.db3", [])
data = open("no.db3", "rb").read()
open("cut.db3", "wb").write(data[:5000])
sqlite3.connect("other.db3").execute("CREATE TABLE t(a)")
mcap("uneven_joints.mcap", [(ns, n if i % 3 else ["hip"], l if i % 3 else [[1.0], [], []]) for i, (ns, n, l) in enumerate(ROWS)])
os.mkdir("empty")
)py");
  const auto said = [&](const char* file, const std::string& what) {
    expect_said(refused(file), what);
  };
  said("brotli.mcap", "is a chunk that is compressed by \"brotli\", which is not read; plain, lz4");
  said("spoilt.mcap", "is a chunk that is damaged: it has not the sum that stands beside it");
  said("ros1.mcap", "is written as CDR's form 2, and 0, 1, 6 and 7 are read");
  said("short.mcap", "a message of /joint_states, recorded at 1767225600000100000 ns, ends before");
  said("uneven.mcap", "has 2 names and 1 positions");
  said("words.mcap", "has a \"position\" that is no list of numbers");
  said("ours.mcap", "is encoded as \"protobuf\", which is not read; cdr and json are");
  said("tf.mcap",
       "holds no messages of joint states (sensor_msgs/msg/JointState); its topics are "
       "/tf (tf2_msgs/msg/TFMessage)");
  said("tf.db3", "its topics are /joint_states (tf2_msgs/msg/TFMessage)");
  said("no.db3", "holds no messages of joint states (sensor_msgs/msg/JointState)");
  said("cut.db3", "cannot be read as a bag of ROS 2: ");
  said("other.db3", "cannot be read as a bag of ROS 2: no such table: topics");
  said("program.py", "is no recording: neither MCAP nor a database of ROS 2");
  said("empty", "is a folder without recordings (.mcap, .db3)");
  said("uneven_joints.mcap", "hip is in 30 of 30, knee in 20; choose those that come together");
  expect_said(refused(kLegs),
              "holds several topics of joint states: /joint_commands, /joint_states; say --topic");
  expect_said(refused(kLegs, topics("/tf", "", "")),
              "--topic: /tf holds tf2_msgs/msg/TFMessage, no joint states");
  expect_said(refused(kLegs, topics("/joint_states", "", "knee_jiont")),
              "fits no joint of /joint_states; did you mean \"knee_joint\"?");
}

// Stamps of a clock that began at the robot's start, then of the world's; stamps in some messages;
// none at all; a second recording behind the first.
TEST_F(Recordings, OfTwoClocksAreRefused) {
  written_by(R"py(
def stamped(name, stamp):
    rows = [(START + 2_000_000 * i, NAMES, [[i / 8, -i / 3], [i * 0.5, 0.1], []]) for i in range(30)]
    mcap(name, rows, write=lambda ns, n, l: cdr(stamp((ns - START) // 2_000_000, ns), n, l))
stamped("jump.mcap", lambda i, ns: ns if i > 20 else ns - START + 10**9)
stamped("back.mcap", lambda i, ns: ns if i < 20 else ns - 10**7)
stamped("some.mcap", lambda i, ns: ns if i % 2 else 0)
stamped("none.mcap", lambda i, ns: 0)
stamped("good.mcap", lambda i, ns: ns - START + 10**9)
)py");
  const std::string good = log_of("good.mcap");
  expect_said(refused("jump.mcap"), "times of /joint_states jump by ");
  expect_said(refused("back.mcap"), "go back by 0.008 s between messages that came 0.002");
  expect_said(refused("some.mcap"), "15 of 30 messages of /joint_states have no stamp");
  for (const char* file : {"jump.mcap", "back.mcap", "some.mcap"}) {
    EXPECT_EQ(log_of(file, by_recorders_clock()), good) << file;
  }
  EXPECT_EQ(log_of("none.mcap"), good);
  expect_said(import("none.mcap").notes, "times are when they came to the recorder");
}

/// The most memory that this process had so far.
std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) << 10;
}

// Oracle: the system's own account. Nothing of the rows is held: what a log of twenty chunks takes
// beyond one of a single chunk is less than half of its text.
TEST_F(Recordings, OfAnyLengthPassThroughFlatMemory) {
  written_by(R"py(
names = [f"joint_{i}" for i in range(30)]
def rows(begin):
    return b"".join(message(1, START + 10**6 * i, cdr(START + 10**6 * i, names, [[i / 7] * 30, [i / 9] * 30, []]))
                    for i in range(begin, begin + 250))
chunks = [chunk(channel(1, "/joint_states", "cdr") + rows(250 * i), "zstd") for i in range(20)]
open("short.mcap", "wb").write(HEAD + chunks[0] + END)
open("long.mcap", "wb").write(HEAD + b"".join(chunks) + END)
)py");
  const auto bytes_of = [&](const char* name) {
    ImportRequest request;
    request.files = {path(name)};
    std::size_t bytes = 0;
    imported_csv(importer_of("mcap").read(request),
                 [&](std::string_view piece) { bytes += piece.size(); });
    return bytes;
  };
  const std::size_t short_bytes = bytes_of("short.mcap");
  const std::size_t before = peak_bytes();
  const std::size_t long_bytes = bytes_of("long.mcap");
  EXPECT_GT(long_bytes, 19 * short_bytes);
  EXPECT_LT(peak_bytes() - before, long_bytes / 2);
}

}  // namespace
}  // namespace torquewright::identification
