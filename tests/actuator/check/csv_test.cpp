// SPDX-License-Identifier: Apache-2.0
// Tables that are read, and the exact sentence for every kind of mistake in one.
#include "io/files/csv.hpp"

#include <gtest/gtest.h>

#include <ostream>

#include "io/files/sha256.hpp"
#include "io/text/units.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::io {
namespace {

std::vector<std::vector<double>> numbers_in(const std::filesystem::path& file) {
  CsvReader csv(file);
  std::vector<std::vector<double>> rows;
  while (csv.next()) {
    std::vector<double>& row = rows.emplace_back();
    for (std::size_t i = 0; i < csv.header().size(); ++i) row.push_back(csv.number(i));
  }
  return rows;
}

using Rows = std::vector<std::vector<double>>;

struct Accepted {
  const char* what;
  std::string text;
};
void PrintTo(const Accepted& accepted, std::ostream* out) { *out << accepted.what; }

class AcceptedTable : public testing::TestWithParam<Accepted> {};

TEST_P(AcceptedTable, HoldsTheSameNumbers) {
  const test::ScratchFolder folder;
  const auto file = folder.write("t.csv", GetParam().text);
  EXPECT_EQ(CsvReader(file).header(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(numbers_in(file), (Rows{{1.0, -2.5}, {3.0, 4000.0}}));
}

INSTANTIATE_TEST_SUITE_P(
    Csv, AcceptedTable,
    testing::Values(Accepted{"plain", "a,b\n1,-2.5\n3,4e3\n"},
                    Accepted{"carriage returns", "a,b\r\n1,-2.5\r\n3,4e3\r\n"},
                    Accepted{"byte order mark",
                             "\xEF\xBB\xBF"
                             "a,b\n1,-2.5\n3,4e3\n"},
                    Accepted{"no final newline", "a,b\n1,-2.5\n3,4e3"},
                    Accepted{"quotes", "\"a\",\"b\"\n\"1\",-2.5\n3,\"4e3\"\n"},
                    Accepted{"blanks", " a , b\n 1 ,\t-2.5\n+3 , 4.0E+3 \n"},
                    Accepted{"comments between rows", "a,b\n# begins\n1,-2.5\n# x\n3,4e3\n# end\n"},
                    Accepted{"blanks alone", "a  b\n  1 \t -2.5\n3 4e3 \n"},
                    Accepted{"names in a comment", "# by hand\n# a,b\n1,-2.5\n3,4e3\n"},
                    Accepted{"as NumPy saves it",
                             "# a b\n1.000e+00 -2.500e+00\n3.000e+00 4.000e+03\n"},
                    Accepted{"exponents as Fortran writes them", "a,b\n1D0,-2.5d+00\n3,4D3\n"},
                    Accepted{"a separator at each end", "a,b,\n1,-2.5,\n3,4e3, \n"},
                    Accepted{"a separator at the end of rows", "a;b\n1;-2,5;\n3;4e3;\n"},
                    Accepted{"comments", "# side: joint\n# x\na,b\n1,-2.5\n3,4e3\n"},
                    Accepted{"empty lines at the end", "a,b\n1,-2.5\n3,4e3\n\n\r\n  \n"}));

TEST(Csv, ReadsQuotesWithinQuotesAndCommasInNames) {
  const test::ScratchFolder folder;
  const CsvReader csv(folder.write("t.csv", "\"a \"\"b\"\"\",\"c,d\"\n1,2\n"));
  EXPECT_EQ(csv.header(), (std::vector<std::string>{"a \"b\"", "c,d"}));
}

TEST(Csv, IsNotDisturbedByWordsInColumnsThatNobodyAsksFor) {
  const test::ScratchFolder folder;
  CsvReader csv(folder.write("t.csv", "a,limiter\n1,voltage\n"));
  ASSERT_TRUE(csv.next());
  EXPECT_EQ(csv.number(0), 1.0);
}

TEST(Csv, CountsNumbersTooSmallForADoubleAsZero) {
  const test::ScratchFolder folder;
  const std::string zeros(500, '0');
  const std::string small[] = {"1e-400", "-1E-99999999999999999999", "0." + zeros + "1",
                               "1" + zeros + "e-900", "0." + zeros + "1e+100"};
  for (const std::string& number : small) {
    EXPECT_EQ(numbers_in(folder.write("t.csv", "a\n" + number + "\n")), (Rows{{0.0}})) << number;
  }
  // What its exponent takes back is an ordinary number.
  EXPECT_EQ(numbers_in(folder.write("t.csv", "a\n15" + zeros + "e-501\n")), (Rows{{1.5}}));
  EXPECT_EQ(numbers_in(folder.write("t.csv", "a\n0." + zeros + "15e501\n")), (Rows{{1.5}}));
}

// Oracle: the numbers as powers of ten, 10^400.
TEST(Csv, RefusesNumbersTooLargeForADoubleWhateverTheirExponent) {
  const test::ScratchFolder folder;
  const std::string zeros(500, '0');
  const std::string large[] = {"1e400",         "1" + zeros + "e-100", "-0." + zeros + "1e+901",
                               zeros + "1e400", "2" + zeros,           "1e99999999999999999999"};
  for (const std::string& number : large) {
    EXPECT_EQ(test::refusal([&] { numbers_in(folder.write("t.csv", "a\n" + number + "\n")); },
                            folder.path()),
              "t.csv: line 2, column 1 (a): \"" + number.substr(0, 40) +
                  (number.size() > 40 ? "..." : "") + "\" is not a finite number");
  }
}

struct MistakenText {
  std::string text;
  std::string sentence;
};
void PrintTo(const MistakenText& mistake, std::ostream* out) { *out << mistake.sentence; }

class MistakenTable : public testing::TestWithParam<MistakenText> {};

TEST_P(MistakenTable, IsRefusedWithItsPlace) {
  const test::ScratchFolder folder;
  const auto file = folder.write("t.csv", GetParam().text);
  EXPECT_EQ(test::refusal([&] { numbers_in(file); }, folder.path()),
            "t.csv: " + GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    Csv, MistakenTable,
    testing::Values(
        MistakenText{"", "is empty; the first line must name the columns"},
        MistakenText{"# only words\n\n", "is empty; the first line must name the columns"},
        MistakenText{"a,b\n1,nan\n", "line 2, column 2 (b): \"nan\" is not a finite number"},
        MistakenText{"a,b\n1,2\n-inf,2\n", "line 3, column 1 (a): \"-inf\" is not a finite number"},
        MistakenText{"a,b\n1,1e999\n", "line 2, column 2 (b): \"1e999\" is not a finite number"},
        MistakenText{"a,b\n1,\n", "line 2, column 2 (b): empty, must be a number"},
        MistakenText{"a,b\n1,0x10\n", "line 2, column 2 (b): \"0x10\" is not a number"},
        MistakenText{"a,b\n1,2 3\n", "line 2, column 2 (b): \"2 3\" is not a number"},
        MistakenText{"a,b\n1,2\n3\n", "line 3: has 1 cell, the header has 2"},
        MistakenText{"a,b\n1.5,2,3\n", "line 2: has 3 cells, the header has 2"},
        MistakenText{"a,b\n1,2,3,4,5\n", "line 2: has 5 cells, the header has 2"},
        MistakenText{
            "a,b\n1,5,2\n",  // only one of the numbers has a fraction
            "line 2: has 3 cells, the header has 2; decimal commas? write 1.5, not 1,5, or "
            "separate by semicolons"},
        MistakenText{
            "a,b\n1,5,2,5\n",
            "line 2: has 4 cells, the header has 2; decimal commas? write 1.5, not 1,5, or "
            "separate by semicolons"},
        MistakenText{"a,b\n\"1,5\",2\n",
                     "line 2, column 1 (a): \"1,5\" has a decimal comma; write 1.5, not 1,5"},
        MistakenText{"a;b\n1,5;2.5\n",
                     "line 2, column 2 (b): \"2.5\" has a decimal point, and cells before it have "
                     "commas"},
        MistakenText{"a;b\n1;2\n1\t2\n",
                     "line 3: has 1 cell, the header has 2; separated otherwise than the header? "
                     "one table has one separator"},
        MistakenText{"a,b,c\n1,2,3\n1;2,3\n",
                     "line 3: has 2 cells, the header has 3; separated otherwise than the header? "
                     "one table has one separator"},
        MistakenText{"a;b;c\n1,5;2;3\n1.5,2,3\n",
                     "line 3: has 1 cell, the header has 3; separated otherwise than the header? "
                     "one table has one separator"},
        MistakenText{"a;b\n1.234,5;2\n", "line 2, column 1 (a): \"1.234,5\" is not a number"},
        MistakenText{"a,b\n1;2\n",
                     "line 1: the header has 2 names between commas, the line behind it has 2 "
                     "between semicolons; one table has one separator, commas, semicolons, tabs or "
                     "blanks"},
        MistakenText{"a b c\n1,2,3\n",
                     "line 1: the header has 3 names between blanks, the line behind it has 3 "
                     "between commas; one table has one separator, commas, semicolons, tabs or "
                     "blanks"},
        MistakenText{"a|b\n1|2\n",
                     "line 1: the header has one name, the line behind it has 2 between upright "
                     "lines; one table has one separator, commas, semicolons, tabs or blanks"},
        MistakenText{"a b\n1 2\n3\n", "line 3: has 1 cell, the header has 2"},
        MistakenText{"a,b\n[s],[m]\n1,2\n",
                     "line 2: is a row of units, and units are stated elsewhere here; delete the "
                     "line"},
        MistakenText{"a,b\n1,2\na,b\n1,2\n",
                     "line 3: the header stands here again; one file holds one table"},
        MistakenText{"a,b,a\n1,2,3\n",
                     "line 1, column 3 (a): the name \"a\" stands twice in the header"},
        MistakenText{"1,2\n3,4\n",
                     "line 1, column 1 (1): 1 is a number; the first line must name the columns"},
        MistakenText{"a,b\n1,2\n\n3,4\n", "line 3: empty, between rows"},
        MistakenText{"a,b\n1,\"2\n",
                     "line 2, column 2 (b): a quote opens here and does not close in this line; a "
                     "cell must be one line"},
        MistakenText{"a,b\n1,\"2\"3\n",
                     "line 2, column 2 (b): text stands behind the closing quote"},
        MistakenText{std::string("a,b\n1,\0\n", 8),
                     "line 2: holds bytes that are no text; save it as UTF-8"},
        MistakenText{
            std::string("\xFF\xFE"
                        "a\0,\0",
                        6),
            "is not CSV but text in UTF-16, which spreadsheets call Unicode text: iconv -f "
            "utf-16 -t utf-8 FILE > FILE.csv"}));

// Files that are no table say what they are and what reads them.
TEST(Csv, SaysWhatAFileIsThatIsNoTable) {
  const test::ScratchFolder folder;
  const std::pair<const char*, const char*> cases[] = {
      {"Bench 3\n1,2\na,b\n1,2\n3,4\n",
       "line 2: has 2 cells, the header has 1; the table seems to begin with line 3 (a,b), and the "
       "lines before are not part of it: tail -n +3 "},
      {"{\"a\": [1]}\n", "is not CSV but JSON: "},
      {"{\"a\": 1}\n{\"a\": 2}\n", "is not CSV but JSON, a line for each row: "},
      {"<!DOCTYPE html><html>\n", "is not CSV but a web page or XML"}};
  for (const auto& [text, said] : cases) {
    const auto file = folder.write("t.csv", text);
    const std::string refusal = test::refusal([&] { numbers_in(file); }, folder.path());
    EXPECT_TRUE(refusal.starts_with("t.csv: " + std::string(said))) << refusal;
  }
  const auto database = folder.write("t.db3", std::string("SQLite format 3\0", 16));
  EXPECT_NE(test::refusal([&] { numbers_in(database); }).find("torquewright identify import ros2"),
            std::string::npos);
}

// Oracle: the numbers as they stand in a table of commas and points.
TEST(Csv, ReadsTablesAsSpreadsheetsWriteThem) {
  const test::ScratchFolder folder;
  const auto numbers = [&](const std::string& text) {
    return numbers_in(folder.write("t.csv", text));
  };
  const auto plain = numbers("a,b\n1.5,-2e-3\n3,4\n");
  EXPECT_EQ(numbers("a;b\n1,5;-2e-3\n3;4\n"), plain);
  EXPECT_EQ(numbers("a;b\n1.5;-2e-3\n3;4\n"), plain);
  EXPECT_EQ(numbers("a\tb\n1.5\t-2e-3\n3\t4\n"), plain);
  EXPECT_EQ(numbers("sep=;\na;b\n\"1,5\";-0,002\n3;4\n"), plain);
  io::CsvReader semicolons(folder.write("u.csv", "a;b,c\n1,5;2\n"));
  ASSERT_TRUE(semicolons.next());
  EXPECT_EQ(semicolons.header(), (std::vector<std::string>{"a;b", "c"}));  // a tie: commas
}

TEST(Csv, SaysItsDialectAndItsUnits) {
  const test::ScratchFolder folder;
  io::CsvReader table(folder.write("t.csv", "t;q;n\ns;[deg];-\n0,5;2;3\n"),
                      io::CsvReader::CutEnd::kRefused, io::CsvReader::UnitsRow::kTaken);
  EXPECT_EQ(table.units(), (std::vector<std::string>{"s", "deg", ""}));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.line(), 3u);
  EXPECT_EQ(table.number(0), 0.5);
  EXPECT_EQ(table.dialect(), "columns are separated by semicolons, decimals are commas");
}

// Oracle: the table as it stands behind the recorder's lines. The second is laid out as National
// Instruments specify .lvm, where no cell stands under Comment.
TEST(Csv, SkipsWhatARecorderWroteBeforeTheNames) {
  const test::ScratchFolder folder;
  const std::string labview =
      "LabVIEW Measurement\nSeparator\tTab\n***End_of_Header***\n\nChannels\t2\t\t\n"
      "Samples\t2\t2\t\n***End_of_Header***\nX_Value\ta\tb\tComment\n0,5\t1\t2\n1,5\t3\t4\tjolt\n";
  io::CsvReader table(folder.write("t.lvm", labview));
  EXPECT_EQ(table.header(), (std::vector<std::string>{"X_Value", "a", "b", "Comment"}));
  EXPECT_EQ(table.skipped_lines(), 7u);
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.number(0), 0.5);
  EXPECT_EQ(table.text(3), "");
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.number(2), 4.0);
  EXPECT_EQ(table.text(3), "jolt");
  EXPECT_EQ(table.line(), 10u);
  EXPECT_FALSE(table.next());
  const std::string bench = "Bench 3\nDate,2026/05/04,\n# side: joint\n\na,b\nrad,Nm\n1,2\n3,4\n";
  io::CsvReader of_bench(folder.write("t.csv", bench), io::CsvReader::CutEnd::kRefused,
                         io::CsvReader::UnitsRow::kTaken);
  EXPECT_EQ(of_bench.comments(), std::vector<std::string>{"# side: joint"});
  EXPECT_EQ(of_bench.units(), (std::vector<std::string>{"rad", "Nm"}));
  ASSERT_TRUE(of_bench.next());
  EXPECT_EQ(of_bench.number(1), 2.0);
  // What has two numbers may be another table's row.
  const auto two = folder.write("two.csv", "t,q,mode\n0,1,idle\nt,q\n1,2\n3,4\n");
  EXPECT_EQ(CsvReader(two).skipped_lines(), 0u);
  EXPECT_EQ(CsvReader(folder.write("u.csv", "# x\n\na,b\n1,2\n3,4\n")).skipped_lines(), 0u);
}

// Oracle: ISO 8859-1 has the degree at 0xB0, UTF-8 at 0xC2 0xB0.
TEST(Csv, ReadsNamesInLatin1) {
  const test::ScratchFolder folder;
  io::CsvReader table(folder.write("t.csv", "t;q [\xB0]\ns;\xB0\n0;1\n"),
                      io::CsvReader::CutEnd::kRefused, io::CsvReader::UnitsRow::kTaken);
  EXPECT_EQ(table.header().back(), "q [\xC2\xB0]");
  EXPECT_EQ(table.units().back(), "\xC2\xB0");
  EXPECT_EQ(table.dialect(), "its names are read as Latin-1; columns are separated by semicolons");
}

// Oracle: the calendar. 2026-11-28 is day 20785 since 1970, by 56 years of 365 days, 14 leap days
// and 331 days of the year.
TEST(Csv, ReadsTimesWithADate) {
  const test::ScratchFolder folder;
  io::CsvReader table(folder.write(
      "t.csv",
      "t,q\n2026-11-28T18:00:00.25Z,1\n2026-11-28 19:30:00.5+01:30,1\n2026-11-28 18:01,1\n7.5,1\n"
      "2026-02-30 18:00:00,1\n"));
  const double day_s = (56.0 * 365.0 + 14.0 + 331.0) * 86400.0;
  for (const double since_s : {day_s + 64800.25, day_s + 64800.5, day_s + 64860.0, 7.5}) {
    ASSERT_TRUE(table.next());
    EXPECT_DOUBLE_EQ(table.time(0), since_s);
  }
  ASSERT_TRUE(table.next());
  EXPECT_EQ(test::refusal([&] { table.time(0); }, folder.path()),
            "t.csv: line 6, column 1 (t): \"2026-02-30 18:00:00\" is not a number");
}

TEST(Csv, RefusesFoldersAndMissingFiles) {
  const test::ScratchFolder folder;
  EXPECT_EQ(test::refusal([&] { CsvReader csv(folder.path()); }),
            folder.path().string() + ": is a folder, must be a file");
  EXPECT_EQ(test::refusal([&] { CsvReader csv(folder.path() / "no"); }, folder.path()),
            "no: no such file");
}

// Oracle: the lines as written, at every length around the reader's buffer of 2^18 bytes.
TEST(LineReader, FindsLinesThatStraddleItsBuffer) {
  const test::ScratchFolder folder;
  constexpr std::size_t kBuffer = std::size_t{1} << 18;
  for (const std::size_t length : {kBuffer - 2, kBuffer - 1, kBuffer, kBuffer + 1, 2 * kBuffer}) {
    const std::string first(length, 'x');
    LineReader lines(folder.write("t", first + "\r\nsecond\n\nlast"));
    std::string_view line;
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, first);
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, "second");
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, "");
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, "last");
    EXPECT_EQ(lines.line_number(), 4u);
    EXPECT_FALSE(lines.next(line));
  }
}

TEST(LineReader, RefusesALineWithoutEnd) {
  const test::ScratchFolder folder;
  LineReader lines(folder.write("t", std::string(3 * LineReader::kLongestLine, 'x')));
  std::string_view line;
  EXPECT_EQ(test::refusal([&] { lines.next(line); }, folder.path()),
            "t: line 1: longer than the allowed 1 MiB; this is no table of numbers");
}

// Oracle: io::sha256 of the same bytes in one piece, itself tested against published vectors.
TEST(LineReader, HashesWhatItReads) {
  const test::ScratchFolder folder;
  const std::string text =
      "\xEF\xBB\xBF"
      "a,b\r\n1,2";
  LineReader lines(folder.write("t", text));
  std::string_view line;
  while (lines.next(line)) {
  }
  EXPECT_EQ(lines.sha256(), sha256(text));
}

// Oracle: definitions. 1 lbf = 0.45359237 kg times 9.80665 m/s^2, 1 in = 0.0254 m (exact).
TEST(Units, ConvertToSI) {
  EXPECT_NEAR(find_unit("deg")->in_SI * 180.0, 3.14159265358979323846, 1e-15);
  EXPECT_NEAR(find_unit("deg_s")->in_SI, find_unit("deg/s")->in_SI, 0.0);
  EXPECT_NEAR(find_unit("rpm")->in_SI * 60.0, 2.0 * 3.14159265358979323846, 1e-15);
  EXPECT_NEAR(find_unit("N m")->in_SI, 1.0, 0.0);
  EXPECT_NEAR(find_unit("lbf_in")->in_SI, 0.1129848290276167, 1e-16);
  EXPECT_FALSE(find_unit("furlong").has_value());
  EXPECT_EQ(unit_names(Dimension::kTime).front(), "s");
}

}  // namespace
}  // namespace torquewright::io
