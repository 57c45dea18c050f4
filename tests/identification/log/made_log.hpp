// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace torquewright::test {

/// A log that is written from closed forms, and spoilt by hand.
class MadeLog {
 public:
  MadeLog(double duration_s, double rate_hz) {
    const int count = static_cast<int>(duration_s * rate_hz);
    for (int i = 0; i < count; ++i) time_s_.push_back(i / rate_hz);
  }

  MadeLog& add(const std::string& column, const std::function<double(double)>& of_time) {
    std::vector<double> values;
    for (const double time_s : time_s_) values.push_back(of_time(time_s));
    columns_.emplace_back(column, std::move(values));
    return *this;
  }

  std::vector<double>& operator[](const std::string& column) {
    for (auto& [name, values] : columns_) {
      if (name == column) return values;
    }
    throw std::logic_error("no column " + column);
  }

  std::string text(const std::string& time_name = "t") const {
    std::string text = time_name;
    for (const auto& [name, values] : columns_) text += "," + name;
    text += '\n';
    for (std::size_t i = 0; i < time_s_.size(); ++i) {
      text += fmt::format("{:.6f}", time_s_[i]);
      for (const auto& [name, values] : columns_) text += fmt::format(",{:.9g}", values[i]);
      text += '\n';
    }
    return text;
  }

 private:
  std::vector<double> time_s_;
  std::vector<std::pair<std::string, std::vector<double>>> columns_;
};

}  // namespace torquewright::test
