// SPDX-License-Identifier: Apache-2.0
#include "io/files/foreign_format.hpp"

#include <array>

namespace torquewright::io {
namespace {

struct Format {
  std::string_view begins_with;
  std::string_view holds;  ///< Stands in the first bytes too; may be empty.
  std::string_view sentence;
};

using namespace std::string_view_literals;

constexpr std::string_view kPickle =
    "a Python pickle, which may run any program when it is opened: where it is trusted, python3 -c "
    "\"import pickle, pandas; pandas.DataFrame(pickle.load(open('FILE', 'rb'))).to_csv('FILE.csv', "
    "index=False)\"";

constexpr std::string_view kUtf16 =
    "text in UTF-16, which spreadsheets call Unicode text: iconv -f utf-16 -t utf-8 FILE > "
    "FILE.csv";

constexpr std::string_view kJson =
    "JSON: python3 -c \"import pandas; pandas.read_json('FILE').to_csv('FILE.csv', "
    "index=False)\"";

constexpr std::string_view kWebPage =
    "a web page or XML: was the page about the file downloaded in its place?";

/// The first that fits counts: an archive by what is in it before any other.
constexpr std::array kFormats{
    Format{"PK\x03\x04"sv, ".npy"sv,
           "a NumPy archive (.npz), which is read from a plain file alone: write it into one, "
           "unpacked"},
    Format{"PK\x03\x04"sv, "[Content_Types].xml"sv,
           "a spreadsheet's own file: save the sheet as CSV"},
    Format{"PK\x03\x04"sv, ""sv, "a zip archive: unzip FILE"},
    Format{"\x93NUMPY"sv, ""sv,
           "a NumPy array (.npy), whose columns have no names: python3 -c \"import numpy as n; "
           "n.savetxt('FILE.csv', n.load('FILE'), delimiter=',')\", then a first line that names "
           "them"},
    Format{"\x80\x02"sv, ""sv, kPickle},
    Format{"\x80\x03"sv, ""sv, kPickle},
    Format{"\x80\x04"sv, ""sv, kPickle},
    Format{"\x80\x05"sv, ""sv, kPickle},
    Format{"PAR1\x15"sv, ""sv,
           "a Parquet table, as LeRobot's are: python3 -c \"import numpy, pandas; d = "
           "pandas.read_parquet('FILE'); numpy.savez('FILE.npz', **{k: numpy.stack(list(d[k])) for "
           "k in d})\", and FILE.npz is read"},
    Format{"\x89HDF\r\n\x1a\n"sv, ""sv,
           "an HDF5 file: python3 -c \"import pandas; pandas.read_hdf('FILE').to_csv('FILE.csv', "
           "index=False)\" where pandas wrote it; in MATLAB "
           "writetable(struct2table(load('FILE')), 'FILE.csv')"},
    Format{"MATLAB "sv, " MAT-file"sv,
           "a MATLAB file (.mat), which is read from a plain file alone: write it into one, "
           "unpacked"},
    Format{"\x28\xb5\x2f\xfd"sv, ""sv, "compressed by zstd: unzstd FILE"},
    Format{"\xfd"
           "7zXZ"sv,
           ""sv, "compressed by xz: unxz --keep FILE"},
    Format{"\xff\xfe"sv, ""sv, kUtf16},
    Format{"\xfe\xff"sv, ""sv, kUtf16},
    Format{"{"sv, "\n{"sv,
           "JSON, a line for each row: python3 -c \"import pandas; pandas.read_json('FILE', "
           "lines=True).to_csv('FILE.csv', index=False)\""},
    Format{"{"sv, ""sv, kJson},
    Format{"["sv, "{"sv, kJson},
    Format{"[["sv, ""sv, kJson},
    Format{"<!"sv, ">"sv, kWebPage},
    Format{"<html"sv, ""sv, kWebPage},
    Format{"<?xml"sv, ""sv, kWebPage},
    Format{"#ROSBAG"sv, ""sv,
           "a recording of ROS 1: rostopic echo -b FILE -p /joint_states > FILE.csv"},
    Format{"\x89MCAP"sv, ""sv,
           "a recording of ROS 2: torquewright identify import mcap FILE -o FOLDER"},
    Format{
        "SQLite format 3"sv, ""sv,
        "a database; where it is a recording of ROS 2: torquewright identify import ros2 FILE -o "
        "FOLDER"},
};

}  // namespace

std::string foreign_format(std::string_view first_bytes) {
  for (const Format& format : kFormats) {
    if (!first_bytes.starts_with(format.begins_with)) continue;
    if (first_bytes.find(format.holds) == std::string_view::npos) continue;
    return std::string(format.sentence);
  }
  return "";
}

}  // namespace torquewright::io
