// SPDX-License-Identifier: Apache-2.0
// Tables that are no text: compressed by gzip, NumPy archives, MATLAB files. Oracle: the files are
// written by Python's gzip and by NumPy; MATLAB's of version 5 byte by byte as MathWorks' "MAT-File
// Format" says, those of 7.3 by matio. Beside each stands the same table as text.
#include <gtest/gtest.h>
#include <matio.h>

#include <fstream>
#include <iterator>

#include "io/files/csv.hpp"
#include "io/files/sha256.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/foreign_writers.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;

struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  std::string form;
  std::string sha256;
};

Table read(const fs::path& file) {
  CsvReader csv(file);
  Table table{csv.header(), {}, "", ""};
  while (csv.next()) {
    std::vector<double>& row = table.rows.emplace_back();
    for (std::size_t i = 0; i < csv.header().size(); ++i) row.push_back(csv.number(i));
  }
  table.form = csv.dialect();
  table.sha256 = csv.sha256();
  return table;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string refusal_of(const test::ScratchFolder& folder, const std::string& name) {
  return test::refusal([&] { read(folder.path() / name); }, folder.path());
}

/// The same names and numbers, to the last bit.
void expect_same(const Table& table, const Table& text) {
  EXPECT_EQ(table.names, text.names);
  EXPECT_GT(text.rows.size(), 0u);
  EXPECT_EQ(table.rows, text.rows);
}

constexpr const char* kText = R"py(
rows = "".join(f"{0.005 * i!r},{(i * 7919 % 1000) / 7!r}\n" for i in range(20000))
open("t.csv", "w").write("t,q\n" + rows)
)py";

TEST(Gzip, HoldsTheTableThatWasCompressed) {
  const test::ScratchFolder folder;
  test::run_python(folder, std::string(kText) + R"py(
import gzip
data = open("t.csv", "rb").read()
open("t.csv.gz", "wb").write(gzip.compress(data))
open("joined.csv.gz", "wb").write(gzip.compress(data[:100001]) + gzip.compress(data[100001:]))
)py");
  const Table text = read(folder.path() / "t.csv");
  const Table packed = read(folder.path() / "t.csv.gz");
  expect_same(packed, text);
  expect_same(read(folder.path() / "joined.csv.gz"), text);
  EXPECT_EQ(packed.form, "compressed by gzip");
  EXPECT_EQ(packed.sha256, sha256(bytes_of(folder.path() / "t.csv.gz")));
}

TEST(Gzip, IsRefusedWhereItEndsEarlyOrIsDamaged) {
  const test::ScratchFolder folder;
  test::run_python(folder, std::string(kText) + R"py(
import gzip, io, numpy
data = gzip.compress(open("t.csv", "rb").read())
open("cut.csv.gz", "wb").write(data[:-9])
open("spoilt.csv.gz", "wb").write(data[:5000] + bytes([data[5000] ^ 255]) + data[5001:])
archive = io.BytesIO()
numpy.savez(archive, t=numpy.arange(3.0))
open("t.npz.gz", "wb").write(gzip.compress(archive.getvalue()))
)py");
  EXPECT_EQ(refusal_of(folder, "cut.csv.gz"),
            "cut.csv.gz: ends in the middle of what gzip compressed; what there is of it: zcat "
            "FILE > FILE.csv");
  EXPECT_NE(refusal_of(folder, "spoilt.csv.gz").find("spoilt.csv.gz: "), std::string::npos);
  EXPECT_NE(refusal_of(folder, "t.npz.gz").find("is not CSV but a NumPy archive"),
            std::string::npos);
}

constexpr const char* kArrays = R"py(
import numpy as np
n = 5000
random = np.random.default_rng(3)
a = {"t": np.arange(n) * 0.002,
     "q": random.normal(size=(n, 3)).astype("f4"),
     "by column, \"F\"": np.asfortranarray(random.normal(size=(n, 2))),
     "across": random.normal(size=(2, n)),
     "swapped": random.normal(size=n).astype(">f8"),
     "count": random.integers(-30000, 30000, n).astype("i2"),
     "byte": random.integers(0, 255, n).astype("u1"),
     "far": random.integers(0, 2**63, n).astype("u8"),
     "column": random.normal(size=(n, 1)),
     "enabled": random.integers(0, 2, n).astype(bool)}
columns = []
for k, v in a.items():
    v = v.T if v.shape[0] != n else v
    v = v.reshape(n, -1)
    columns += [(k if v.shape[1] == 1 else f"{k}_{i}", v[:, i]) for i in range(v.shape[1])]
with open("a.csv", "w") as out:
    print(",".join('"' + k.replace('"', '""') + '"' for k, _ in columns), file=out)
    for i in range(n):
        print(",".join(str(v[i] if v.dtype != bool else int(v[i])) for _, v in columns), file=out)
)py";

TEST(NumpyArchive, IsTheTableOfItsArrays) {
  const test::ScratchFolder folder;
  test::run_python(folder, std::string(kArrays) + R"py(
np.savez("a.npz", **a)
np.savez_compressed("packed.npz", **a)
np.savez("more.npz", dt=0.002, names=np.array(["knee", "hip"]), short=np.zeros(7), **a)
)py");
  const Table text = read(folder.path() / "a.csv");
  const Table stored = read(folder.path() / "a.npz");
  expect_same(stored, text);
  expect_same(read(folder.path() / "packed.npz"), text);
  const Table more = read(folder.path() / "more.npz");
  expect_same(more, text);
  EXPECT_EQ(stored.form, "a NumPy archive");
  EXPECT_EQ(more.form,
            "a NumPy archive; left out: dt (one number), names (text), short (7 numbers)");
  EXPECT_EQ(stored.sha256, sha256(bytes_of(folder.path() / "a.npz")));
}

// Refused by row, since there are no lines; and what no table can be made of.
TEST(NumpyArchive, IsRefusedByName) {
  const test::ScratchFolder folder;
  test::run_python(folder, R"py(
import numpy as np
t = np.arange(2000.0)
np.savez("nan.npz", t=np.array([0, 1, np.nan]))
np.savez("words.npz", names=np.array(["a", "b"]))
np.savez("names.npz", **{"a\nb": t})
np.savez("wide.npz", q=np.zeros((2, 20000)))
np.savez("t.npz", t=t)
data = open("t.npz", "rb").read()
open("cut.npz", "wb").write(data[:9000])
open("spoilt.npz", "wb").write(data[:9000] + bytes([data[9000] ^ 1]) + data[9001:])
)py");
  EXPECT_EQ(refusal_of(folder, "nan.npz"),
            "nan.npz: row 3, column 1 (t): \"nan\" is not a finite number");
  EXPECT_EQ(refusal_of(folder, "words.npz"),
            "words.npz: is a NumPy archive without an array of numbers; it holds names (text)");
  EXPECT_NE(refusal_of(folder, "names.npz").find("the name of an array holds"), std::string::npos);
  EXPECT_EQ(refusal_of(folder, "wide.npz"), "wide.npz: has more than the allowed 10000 columns");
  EXPECT_NE(refusal_of(folder, "cut.npz").find("it was cut"), std::string::npos);
  EXPECT_EQ(refusal_of(folder, "spoilt.npz"),
            "spoilt.npz: is damaged: its array t has not the sum that stands beside it");
}

/// A file of version 5: a header of 128 bytes, then tagged elements, padded to 8 bytes.
constexpr const char* kMat5 = R"py(
import struct, zlib
def element(kind, data):
    return struct.pack("<II", kind, len(data)) + data + bytes(-len(data) % 8)
def matrix(name, kind, dims, parts, flags=0):
    return element(14, element(6, struct.pack("<II", kind | flags << 8, 0)) +
                   element(5, struct.pack("<2i", *dims)) + element(1, name.encode()) + parts)
def doubles(name, rows):  # rows of a matrix; stored column by column
    columns = [row[i] for i in range(len(rows[0])) for row in rows]
    return matrix(name, 6, (len(rows), len(rows[0])),
                  element(9, struct.pack(f"<{len(columns)}d", *columns)))
def struct_of(name, fields):
    names = b"".join(k.encode().ljust(32, b"\0") for k, _ in fields)
    return matrix(name, 2, (1, 1), struct.pack("<HHI", 5, 4, 32) + element(1, names) +
                  b"".join(v for _, v in fields))
def write(file, elements):
    head = b"MATLAB 5.0 MAT-file, written by hand".ljust(124) + struct.pack("<H", 0x0100) + b"IM"
    open(file, "wb").write(head + b"".join(elements))
n = 300
t = [[0.01 * i] for i in range(n)]
q = [[i / 7, -i / 3] for i in range(n)]
across = [[i * 0.1 for i in range(n)], [i * 0.2 for i in range(n)]]
small = matrix("small", 6, (n, 1), element(2, bytes(i % 200 for i in range(n))))  # doubles in bytes
single = matrix("log.s", 7, (n, 1), element(7, struct.pack(f"<{n}f", *[i / 9 for i in range(n)])))
char = matrix("note", 4, (1, 3), element(4, struct.pack("<3H", *b"abc")))
fields = [("t", doubles("", t)), ("q", doubles("", q))]
elements = [struct_of("log", fields), doubles("across", across), small, char, doubles("dt", [[0.01]])]
write("a.mat", elements)
write("packed.mat", [struct.pack("<II", 15, len(z)) + z for z in map(zlib.compress, elements)])
with open("a.csv", "w") as out:
    print("log.t,log.q_1,log.q_2,across_1,across_2,small", file=out)
    for i in range(n):
        print(t[i][0], *q[i], across[0][i], across[1][i], i % 200, sep=",", file=out)
write("cut.mat", [doubles("t", t)[:1000]])
write("text.mat", [char])
)py";

TEST(MatlabFile, IsTheTableOfItsArrays) {
  const test::ScratchFolder folder;
  test::run_python(folder, kMat5);
  const Table text = read(folder.path() / "a.csv");
  const Table plain = read(folder.path() / "a.mat");
  expect_same(plain, text);
  expect_same(read(folder.path() / "packed.mat"), text);
  EXPECT_EQ(plain.form, "a MATLAB file; left out: note (text), dt (one number)");
  EXPECT_EQ(plain.sha256, sha256(bytes_of(folder.path() / "a.mat")));
  EXPECT_EQ(refusal_of(folder, "cut.mat"),
            "cut.mat: ends within the variable that begins at byte 128");
  EXPECT_EQ(refusal_of(folder, "text.mat"),
            "text.mat: is a MATLAB file without an array of numbers; it holds note (text)");
}

// What MATLAB calls -v7.3 is an HDF5 file behind 512 bytes.
TEST(MatlabFile, OfVersion73IsRead) {
  const test::ScratchFolder folder;
  const fs::path file = folder.path() / "a.mat";
  std::vector<double> q;
  for (int i = 0; i < 40; ++i) q.push_back(i / 3.0);
  std::size_t dims[2] = {20, 2};
  mat_t* const mat = Mat_CreateVer(file.c_str(), nullptr, MAT_FT_MAT73);
  ASSERT_NE(mat, nullptr);
  matvar_t* const variable =
      Mat_VarCreate("q", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, q.data(), MAT_F_DONT_COPY_DATA);
  Mat_VarWrite(mat, variable, MAT_COMPRESSION_NONE);
  Mat_VarFree(variable);
  Mat_Close(mat);
  const Table table = read(file);
  EXPECT_EQ(table.names, (std::vector<std::string>{"q_1", "q_2"}));
  ASSERT_EQ(table.rows.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(table.rows[i], (std::vector<double>{q[i], q[20 + i]}));
  }
}

// Parquet is not read: the line that is said makes an archive that is. Oracle: the line itself, run
// with a stand-in of pandas that returns what pandas does of LeRobot's columns of vectors.
TEST(Parquet, IsRefusedWithTheLineThatConvertsIt) {
  const test::ScratchFolder folder;
  folder.write("episode.parquet", "PAR1\x15");
  const std::string said = refusal_of(folder, "episode.parquet");
  const std::size_t from = said.find("python3 -c \"") + 12;
  std::string line = said.substr(from, said.find('"', from) - from);
  while (line.find("FILE") != std::string::npos) line.replace(line.find("FILE"), 4, "episode");
  folder.write("pandas.py",
               "import numpy\ndef read_parquet(file):\n  return {'timestamp': [0.0, 0.5], "
               "'observation.state': [numpy.array([1.0, 2.0]), numpy.array([3.0, 4.0])]}\n");
  test::run_python(folder, line);
  const Table table = read(folder.path() / "episode.npz");
  EXPECT_EQ(table.names,
            (std::vector<std::string>{"timestamp", "observation.state_0", "observation.state_1"}));
  EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0.0, 1.0, 2.0}, {0.5, 3.0, 4.0}}));
}

}  // namespace
}  // namespace torquewright::io
