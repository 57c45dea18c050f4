// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "identification/log/log.hpp"
#include "identification/reading/channel.hpp"

namespace torquewright::identification {

/// Cells without a number, as recorders leave them for channels that they ask less often. Between
/// two numbers no more than kLongestBridge_s apart a measured channel is a straight line; what was
/// set, temperatures and a supply's voltage hold their last number, however long. Other rows are
/// masked. It follows a run while its rows are read.
class EmptyCells {
 public:
  /// The channel of a column: its quantity, at the joints from `first` to before `end`.
  struct Channel {
    Quantity quantity;
    std::size_t first, end;
  };

  void begin_run(std::size_t columns);

  /// Takes note of the last row's cell of a column, in the run's last row, where a number stands
  /// already: the one before it if the cell was empty.
  void add(std::size_t column, const Channel& channel, bool has_number, Run& run);

  /// Rows were taken off the run: what was empty in those that are left stays as it is.
  void forget_rows();

  std::vector<DataFinding> findings(const Rig& rig) const;

 private:
  struct State {
    std::optional<std::size_t> last;  ///< Row of the last number in the run.
    std::size_t waiting = 0;          ///< Empty cells since.
  };
  struct Count {
    std::size_t cells = 0, masked = 0;
  };
  std::vector<State> columns_;
  std::map<ChannelKey, Count> counts_;
};

}  // namespace torquewright::identification
