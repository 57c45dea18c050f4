// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "identification/log/run.hpp"
#include "identification/log/spill_file.hpp"

namespace torquewright::identification {

/// A log of more rows than these does not stay in memory; its stretches are cut in pieces
/// (docs/decisions/0010-long-logs-in-pieces.md).
constexpr std::size_t kLongestWholeLog = 300000;

/// What is known of a run without reading its samples.
struct RunHead {
  std::string name;
  std::size_t samples = 0;
  bool is_map = false;  ///< The run is a map without time.
  double begin_s = 0.0, end_s = 0.0;
  bool continues = false;
};

/// The runs of a log in their order. They stay in memory up to `kLongestWholeLog` rows together,
/// else in a temporary file from which one run at a time is read. Copies share the file, and what
/// is changed in one is not changed in the other.
class Runs {
 public:
  explicit Runs(std::size_t most_rows_in_memory = kLongestWholeLog)
      : most_rows_in_memory_(most_rows_in_memory) {}

  void push_back(Run run) { insert(size(), std::move(run)); }
  void insert(std::size_t at, Run run);

  std::size_t size() const { return heads_.size(); }
  bool empty() const { return heads_.empty(); }
  bool is_in_memory() const { return file_ == nullptr; }
  std::size_t rows() const { return rows_; }
  std::size_t most_rows_in_memory() const { return most_rows_in_memory_; }

  const RunHead& head(std::size_t index) const { return heads_[index]; }
  void rename(std::size_t index, const std::string& name);
  /// Cuts the run off the one before it, if it continues that.
  void cut_before(std::size_t index);
  /// Whether any run has the channel.
  bool has(std::size_t joint, Quantity quantity) const;

  /// Reads a run. Valid until another one is asked for.
  const Run& operator[](std::size_t index) const;
  const Run& front() const { return (*this)[0]; }
  /// Returns the samples from `begin` to before `end` of one run.
  Run part(std::size_t index, std::size_t begin, std::size_t end) const;

  /// Changes a run: the only way to do so.
  void change(std::size_t index, const std::function<void(Run&)>& edit);

  /// Joins the pieces of each stretch to one run. Requires runs in memory.
  void join_pieces();

  /// Goes over the runs; each is valid until the next.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Run;
    using difference_type = std::ptrdiff_t;
    using pointer = const Run*;
    using reference = const Run&;
    Iterator(const Runs& runs, std::size_t index) : runs_(&runs), index_(index) {}
    const Run& operator*() const;
    Iterator& operator++();
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    const Runs* runs_;
    std::size_t index_;
    mutable std::shared_ptr<const Run> read_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  /// Where the numbers of a run stand in the file: time, channels of each joint, mask.
  struct Place {
    std::size_t first = 0;
    std::vector<std::array<bool, kQuantityCount>> has;  ///< Logged quantities by joint.
  };
  Place written(const Run& run, std::optional<std::size_t> over);
  void spill();

  std::size_t most_rows_in_memory_;
  std::size_t rows_ = 0;
  std::vector<RunHead> heads_;
  std::vector<Run> memory_;
  std::shared_ptr<SpillFile> file_;
  std::vector<Place> places_;
  mutable std::shared_ptr<const Run> asked_;
};

}  // namespace torquewright::identification
