/* SPDX-License-Identifier: Apache-2.0 */
/* Torque limits for a simulator's inner loop. C99 and C++, header only, no allocation, no library.
 *
 * Two descriptions of a region: the parallelogram of a motor without losses, and a table for
 * anything else (friction, saturation, field weakening, battery; made by
 * actuator/mor/clip_table.hpp). Torque in Nm, speed in rad/s, both of the same side of the
 * gearbox. Every function is pure; the batched ones work through arrays of `count` samples, where
 * `clipped_Nm` may be `torque_Nm` itself. A speed or torque that is not a number yields one that is
 * not.
 */
#pragma once

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* From least to greatest torque. */
typedef struct torquewright_interval {
  double least_Nm;
  double greatest_Nm;
} torquewright_interval;

/* |torque| <= greatest_torque and |torque + slope speed| <= stall_torque with
 * slope = stall_torque / no_load_speed. All three positive. */
typedef struct torquewright_parallelogram {
  double stall_torque_Nm;
  double no_load_speed_rad_s;
  double greatest_torque_Nm;
} torquewright_parallelogram;

/* The region from one speed to the next: linear bounds. Made by torquewright_make_rows. */
typedef struct torquewright_row {
  double speed_rad_s;
  double next_speed_rad_s;
  double least_Nm; /* at speed_rad_s */
  double least_slope_Nm_s_rad;
  double greatest_Nm;
  double greatest_slope_Nm_s_rad;
} torquewright_row;

/* Rows of ascending speed; beyond the ends the end points hold. A row of no width is a jump; at
 * speed 0 itself `rest` holds. */
typedef struct torquewright_table {
  const torquewright_row* row;
  size_t rows;
  torquewright_interval rest;
  /* The row at the start of each of `cells` equal cells from the first speed to the last, or one
   * before it where rounding may put a speed into the next cell; then the last row: cells + 1
   * entries, which find a row at once. Null: rows are searched for by bisection. */
  const uint32_t* first_row;
  size_t cells;
  double cells_per_rad_s;
} torquewright_table;

static inline double torquewright_clamp(double value, torquewright_interval within) {
  const double raised = value < within.least_Nm ? within.least_Nm : value;
  return raised > within.greatest_Nm ? within.greatest_Nm : raised;
}

/* Past the overspeed, where the two conditions have nothing in common, only -sign(speed) times the
 * greatest torque is left. */
static inline torquewright_interval torquewright_parallelogram_limits(
    const torquewright_parallelogram* region, double speed_rad_s) {
  const double cap_Nm = region->greatest_torque_Nm;
  const double line_Nm = region->stall_torque_Nm / region->no_load_speed_rad_s * speed_rad_s;
  const torquewright_interval cap = {-cap_Nm, cap_Nm};
  torquewright_interval limits;
  limits.least_Nm = torquewright_clamp(-region->stall_torque_Nm - line_Nm, cap);
  limits.greatest_Nm = torquewright_clamp(region->stall_torque_Nm - line_Nm, cap);
  return limits;
}

static inline double torquewright_parallelogram_clip(const torquewright_parallelogram* region,
                                                     double speed_rad_s, double torque_Nm) {
  const double clipped_Nm =
      torquewright_clamp(torque_Nm, torquewright_parallelogram_limits(region, speed_rad_s));
  return speed_rad_s == speed_rad_s ? clipped_Nm : speed_rad_s;
}

static inline void torquewright_parallelogram_clip_all(const torquewright_parallelogram* region,
                                                       const double* speed_rad_s,
                                                       const double* torque_Nm, double* clipped_Nm,
                                                       size_t count) {
  const torquewright_parallelogram copy = *region;
  for (size_t i = 0; i < count; ++i) {
    clipped_Nm[i] = torquewright_parallelogram_clip(&copy, speed_rad_s[i], torque_Nm[i]);
  }
}

/* Fills `row`, which has room for `count`, from points of ascending speed; the last row is the end
 * point. Requires count >= 1. */
static inline void torquewright_make_rows(const double* speed_rad_s, const double* least_Nm,
                                          const double* greatest_Nm, size_t count,
                                          torquewright_row* row) {
  for (size_t i = 0; i < count; ++i) {
    const int is_last = i + 1 == count;
    const double width_rad_s = is_last ? 0.0 : speed_rad_s[i + 1] - speed_rad_s[i];
    const double per_width = width_rad_s > 0.0 ? 1.0 / width_rad_s : 0.0;
    row[i].speed_rad_s = speed_rad_s[i];
    row[i].next_speed_rad_s = is_last ? HUGE_VAL : speed_rad_s[i + 1];
    row[i].least_Nm = least_Nm[i];
    row[i].greatest_Nm = greatest_Nm[i];
    row[i].least_slope_Nm_s_rad = is_last ? 0.0 : per_width * (least_Nm[i + 1] - least_Nm[i]);
    row[i].greatest_slope_Nm_s_rad =
        is_last ? 0.0 : per_width * (greatest_Nm[i + 1] - greatest_Nm[i]);
  }
}

/* The last row that begins at or before the speed. Requires first speed <= speed <= last speed. */
static inline const torquewright_row* torquewright_row_at(const torquewright_table* table,
                                                          double speed_rad_s) {
  if (table->first_row != NULL) {
    const double cells = (speed_rad_s - table->row[0].speed_rad_s) * table->cells_per_rad_s;
    size_t cell = (size_t)(int64_t)cells; /* signed: one instruction */
    cell = cell < table->cells ? cell : table->cells;
    const torquewright_row* row = table->row + table->first_row[cell];
    while (row->next_speed_rad_s <= speed_rad_s) ++row;
    return row;
  }
  size_t low = 0;
  size_t high = table->rows;
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    if (table->row[middle].speed_rad_s <= speed_rad_s) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return table->row + low;
}

static inline torquewright_interval torquewright_table_limits(const torquewright_table* table,
                                                              double speed_rad_s) {
  if (speed_rad_s == 0.0) return table->rest;
  const torquewright_interval ends = {table->row[0].speed_rad_s,
                                      table->row[table->rows - 1].speed_rad_s};
  const double within = torquewright_clamp(speed_rad_s, ends);
  const torquewright_row* row = torquewright_row_at(table, within);
  const double past_rad_s = within - row->speed_rad_s;
  torquewright_interval limits;
  limits.least_Nm = row->least_Nm + past_rad_s * row->least_slope_Nm_s_rad;
  limits.greatest_Nm = row->greatest_Nm + past_rad_s * row->greatest_slope_Nm_s_rad;
  return limits;
}

static inline double torquewright_table_clip(const torquewright_table* table, double speed_rad_s,
                                             double torque_Nm) {
  const double clipped_Nm =
      torquewright_clamp(torque_Nm, torquewright_table_limits(table, speed_rad_s));
  return speed_rad_s == speed_rad_s ? clipped_Nm : speed_rad_s;
}

static inline void torquewright_table_clip_all(const torquewright_table* table,
                                               const double* speed_rad_s, const double* torque_Nm,
                                               double* clipped_Nm, size_t count) {
  const torquewright_table copy = *table;
  for (size_t i = 0; i < count; ++i) {
    clipped_Nm[i] = torquewright_table_clip(&copy, speed_rad_s[i], torque_Nm[i]);
  }
}

#ifdef __cplusplus
} /* extern "C" */

namespace torquewright::actuator {

using Interval = torquewright_interval;
using Parallelogram = torquewright_parallelogram;
using TableView = torquewright_table;

inline Interval limits(const Parallelogram& region, double speed_rad_s) {
  return torquewright_parallelogram_limits(&region, speed_rad_s);
}
inline Interval limits(const TableView& table, double speed_rad_s) {
  return torquewright_table_limits(&table, speed_rad_s);
}

inline double clip(const Parallelogram& region, double speed_rad_s, double torque_Nm) {
  return torquewright_parallelogram_clip(&region, speed_rad_s, torque_Nm);
}
inline double clip(const TableView& table, double speed_rad_s, double torque_Nm) {
  return torquewright_table_clip(&table, speed_rad_s, torque_Nm);
}

inline void clip(const Parallelogram& region, const double* speed_rad_s, const double* torque_Nm,
                 double* clipped_Nm, size_t count) {
  torquewright_parallelogram_clip_all(&region, speed_rad_s, torque_Nm, clipped_Nm, count);
}
inline void clip(const TableView& table, const double* speed_rad_s, const double* torque_Nm,
                 double* clipped_Nm, size_t count) {
  torquewright_table_clip_all(&table, speed_rad_s, torque_Nm, clipped_Nm, count);
}

}  // namespace torquewright::actuator
#endif
