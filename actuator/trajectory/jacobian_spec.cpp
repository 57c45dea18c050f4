// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/jacobian_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/documents/document.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

class JacobianReader {
 public:
  explicit JacobianReader(const io::Document& document) : document_(document) {}

  ParallelDrive read() {
    const json& root = document_.root;
    drive_.name = root.value("name", io::stem_in_text(document_.file));
    drive_.joints = names("joints");
    drive_.actuators = names("actuators");
    if (root.contains("matrix") == root.contains("table")) {
      report("", "needs either \"matrix\" (constant) or \"table\" (over both angles)");
    } else if (root.contains("matrix")) {
      add_matrix(root["matrix"], "/matrix");
    } else {
      read_table(root["table"]);
    }
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return std::move(drive_);
  }

 private:
  void report(const std::string& path, std::string message) {
    faults_.push_back({document_.file, document_.path + path, std::move(message)});
  }

  std::array<std::string, 2> names(const char* key) {
    const json& list = document_.root[key];
    if (list[0] == list[1]) {
      report(fmt::format("/{}/1", key), fmt::format("{} stands twice", list[1].dump()));
    }
    return {list[0].get<std::string>(), list[1].get<std::string>()};
  }

  void add_matrix(const json& rows, const std::string& path) {
    const Matrix2 matrix{rows[0][0], rows[0][1], rows[1][0], rows[1][1]};
    if (!actuator_torques(matrix, {0.0, 0.0})) {
      report(path, "is singular: some joint torque could be carried by no actuator torques");
    }
    drive_.matrices.push_back(matrix);
  }

  std::vector<double> grid(const json& table, const char* key) {
    const auto angles_rad = table[key].get<std::vector<double>>();
    if (std::adjacent_find(angles_rad.begin(), angles_rad.end(), std::greater_equal<>()) !=
        angles_rad.end()) {
      report(fmt::format("/table/{}", key), "must ascend");
    }
    return angles_rad;
  }

  void read_table(const json& table) {
    drive_.first_rad = grid(table, "first_angle_rad");
    drive_.second_rad = grid(table, "second_angle_rad");
    const json& list = table["matrices"];
    const std::size_t points = drive_.first_rad.size() * drive_.second_rad.size();
    if (list.size() != points) {
      report("/table/matrices",
             fmt::format("has {} entries, the grid has {} x {} points", list.size(),
                         drive_.first_rad.size(), drive_.second_rad.size()));
      return;
    }
    std::size_t index = 0;
    for (const json& rows : list) add_matrix(rows, fmt::format("/table/matrices/{}", index++));
  }

  const io::Document& document_;
  ParallelDrive drive_;
  std::vector<io::Fault> faults_;
};

}  // namespace

ParallelDrive read_parallel_drive(const io::Document& document) {
  return JacobianReader(document).read();
}

}  // namespace torquewright::actuator
