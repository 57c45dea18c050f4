// SPDX-License-Identifier: Apache-2.0
#include "identification/draft/log_sample.hpp"

#include <limits>
#include <string>

#include "io/files/csv.hpp"

namespace torquewright::identification {

LogSample read_sample(const std::filesystem::path& file, std::size_t most_rows) {
  io::CsvReader reader(file, io::CsvReader::CutEnd::kDropped, io::CsvReader::UnitsRow::kTaken);
  LogSample sample;
  sample.names = reader.header();
  sample.units = reader.units();
  sample.units.resize(sample.names.size());
  sample.numbers.resize(sample.names.size());
  sample.changes.resize(sample.names.size());
  std::vector<std::string> before(sample.names.size());
  for (std::size_t row = 0; row < most_rows && reader.next(); ++row) {
    for (std::size_t c = 0; c < sample.names.size(); ++c) {
      sample.numbers[c].push_back(reader.is_number(c) ? reader.number(c)
                                                      : std::numeric_limits<double>::quiet_NaN());
      if (row > 0 && reader.text(c) != before[c]) sample.changes[c].push_back(row);
      before[c] = reader.text(c);
    }
  }
  return sample;
}

}  // namespace torquewright::identification
