/* SPDX-License-Identifier: Apache-2.0 */
/* Torque limits for a simulator's inner loop. C99 and C++, header only, no allocation, no library.
 *
 * Two descriptions of a region: the parallelogram of a motor without losses, and a table for
 * anything else (friction, saturation, field weakening, battery; made by actuator/clip_table.hpp).
 * Torque in Nm, speed in rad/s, both of the same side of the gearbox. Every function is pure; the
 * batched ones work through arrays of `count` samples, where `clipped_Nm` may be `torque_Nm`
 * itself. A speed or torque that is not a number yields one that is not.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The torques from least to greatest. */
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

/* Rows of ascending speed, interpolated linearly; beyond the ends the end rows hold. Two rows of
 * the same speed are a jump; at speed 0 itself `rest` holds. Requires rows >= 2. */
typedef struct torquewright_table {
  const double* speed_rad_s;
  const double* least_Nm;
  const double* greatest_Nm;
  size_t rows;
  torquewright_interval rest;
  /* The last row at or before the start of each of `cells` equal cells from the first speed to the
   * last: finds the row at once. Null: it is searched for by bisection. */
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

/* The last row whose speed is at most the given one. Requires first speed <= speed < last speed. */
static inline size_t torquewright_table_row(const torquewright_table* table, double speed_rad_s) {
  const double* speeds = table->speed_rad_s;
  if (table->first_row != NULL) {
    size_t cell = (size_t)((speed_rad_s - speeds[0]) * table->cells_per_rad_s);
    if (cell >= table->cells) cell = table->cells - 1;
    size_t row = table->first_row[cell];
    while (speeds[row] > speed_rad_s) --row; /* rounding put it one cell too far */
    while (speeds[row + 1] <= speed_rad_s) ++row;
    return row;
  }
  size_t low = 0;
  size_t high = table->rows - 1;
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    if (speeds[middle] <= speed_rad_s) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

static inline torquewright_interval torquewright_table_limits(const torquewright_table* table,
                                                              double speed_rad_s) {
  const size_t last = table->rows - 1;
  torquewright_interval limits;
  if (speed_rad_s == 0.0) return table->rest;
  if (!(speed_rad_s > table->speed_rad_s[0])) {
    limits.least_Nm = table->least_Nm[0];
    limits.greatest_Nm = table->greatest_Nm[0];
    return limits;
  }
  if (speed_rad_s >= table->speed_rad_s[last]) {
    limits.least_Nm = table->least_Nm[last];
    limits.greatest_Nm = table->greatest_Nm[last];
    return limits;
  }
  const size_t row = torquewright_table_row(table, speed_rad_s);
  const double share = (speed_rad_s - table->speed_rad_s[row]) /
                       (table->speed_rad_s[row + 1] - table->speed_rad_s[row]);
  limits.least_Nm =
      table->least_Nm[row] + share * (table->least_Nm[row + 1] - table->least_Nm[row]);
  limits.greatest_Nm =
      table->greatest_Nm[row] + share * (table->greatest_Nm[row + 1] - table->greatest_Nm[row]);
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
