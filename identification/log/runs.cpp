// SPDX-License-Identifier: Apache-2.0
#include "identification/log/runs.hpp"

#include <algorithm>
#include <stdexcept>

#include "identification/log/stretch.hpp"

namespace torquewright::identification {
namespace {

RunHead head_of(const Run& run) {
  RunHead head{run.name, sample_count(run), run.time_s.empty(), 0.0, 0.0, run.continues};
  if (!run.time_s.empty()) {
    head.begin_s = run.time_s.front();
    head.end_s = run.time_s.back();
  }
  return head;
}

template <typename Value>
auto at(std::vector<Value>& values, std::size_t index) {
  return values.begin() + static_cast<std::ptrdiff_t>(index);
}

template <typename Value>
void append(std::vector<Value>& values, const std::vector<Value>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

void Runs::insert(std::size_t index, Run run) {
  heads_.insert(at(heads_, index), head_of(run));
  rows_ += heads_[index].samples;
  if (is_in_memory()) {
    memory_.insert(at(memory_, index), std::move(run));
    if (rows_ > most_rows_in_memory_) spill();
  } else {
    places_.insert(at(places_, index), written(run, std::nullopt));
  }
}

void Runs::rename(std::size_t index, const std::string& name) {
  heads_[index].name = name;
  if (is_in_memory()) memory_[index].name = name;
  asked_.reset();
}

void Runs::cut_before(std::size_t index) {
  if (index >= size()) return;
  heads_[index].continues = false;
  if (is_in_memory()) memory_[index].continues = false;
  asked_.reset();
}

bool Runs::has(std::size_t joint, Quantity quantity) const {
  const auto channel = static_cast<std::size_t>(quantity);
  const auto in_run = [&](const Run& run) { return run.joints[joint].has(quantity); };
  const auto in_file = [&](const Place& place) { return place.has[joint][channel]; };
  return std::any_of(memory_.begin(), memory_.end(), in_run) ||
         std::any_of(places_.begin(), places_.end(), in_file);
}

const Run& Runs::operator[](std::size_t index) const {
  if (is_in_memory()) return memory_[index];
  asked_ = std::make_shared<const Run>(part(index, 0, heads_[index].samples));
  return *asked_;
}

Run Runs::part(std::size_t index, std::size_t begin, std::size_t end) const {
  const RunHead& head = heads_[index];
  if (is_in_memory()) {
    Run part = part_of(memory_[index], begin, end);
    part.continues = head.continues && begin == 0;
    return part;
  }
  std::size_t place = places_[index].first + begin;
  const auto next = [&] {
    std::vector<double> values(end - begin);
    file_->read(place, values);
    place += head.samples;
    return values;
  };
  Run run;
  run.name = head.name;
  if (!head.is_map) run.time_s = next();
  for (const auto& has : places_[index].has) {
    Channels& channels = run.joints.emplace_back();
    for (std::size_t i = 0; i < kQuantityCount; ++i) {
      if (has[i]) channels.of[i] = next();
    }
  }
  for (const double value : next()) run.masked.push_back(value != 0.0);
  run.continues = head.continues && begin == 0;
  return run;
}

void Runs::change(std::size_t index, const std::function<void(Run&)>& edit) {
  rows_ -= heads_[index].samples;
  if (is_in_memory()) {
    edit(memory_[index]);
    heads_[index] = head_of(memory_[index]);
  } else {
    Run run = part(index, 0, heads_[index].samples);
    edit(run);
    places_[index] = written(run, index);
    heads_[index] = head_of(run);
  }
  rows_ += heads_[index].samples;
  asked_.reset();
}

void Runs::join_pieces() {
  if (!is_in_memory()) throw std::logic_error("runs that are not in memory are not joined");
  std::vector<Run> joined;
  for (Run& run : memory_) {
    if (run.continues) {
      append(joined.back(), run);
    } else {
      joined.push_back(std::move(run));
    }
  }
  memory_ = std::move(joined);
  heads_.clear();
  for (const Run& run : memory_) heads_.push_back(head_of(run));
}

/// In place of what run `over` was, if that is as long and nobody else reads it; else at the end.
Runs::Place Runs::written(const Run& run, std::optional<std::size_t> over) {
  Place place;
  std::vector<double> all = run.time_s;
  for (const Channels& channels : run.joints) {
    auto& has = place.has.emplace_back();
    for (std::size_t i = 0; i < kQuantityCount; ++i) {
      has[i] = !channels.of[i].empty();
      append(all, channels.of[i]);
    }
  }
  all.insert(all.end(), run.masked.begin(), run.masked.end());
  const bool fits = over && file_.use_count() == 1 && places_[*over].has == place.has &&
                    heads_[*over].samples == sample_count(run);
  if (fits) {
    place.first = places_[*over].first;
    file_->write(place.first, all);
  } else {
    place.first = file_->append(all);
  }
  return place;
}

void Runs::spill() {
  file_ = std::make_shared<SpillFile>();
  for (const Run& run : memory_) places_.push_back(written(run, std::nullopt));
  memory_ = {};
}

const Run& Runs::Iterator::operator*() const {
  if (runs_->is_in_memory()) return runs_->memory_[index_];
  if (!read_) {
    read_ = std::make_shared<const Run>(runs_->part(index_, 0, runs_->head(index_).samples));
  }
  return *read_;
}

Runs::Iterator& Runs::Iterator::operator++() {
  ++index_;
  read_.reset();
  return *this;
}

}  // namespace torquewright::identification
