// SPDX-License-Identifier: Apache-2.0
#include "actuator/source_text/c_source.hpp"

namespace torquewright::actuator {

const std::string_view kCSource = R"(#ifndef TORQUEWRIGHT_REGION_IN_C
#define TORQUEWRIGHT_REGION_IN_C

#include <stddef.h>

typedef struct torquewright_region_limits {
  double least_Nm;
  double greatest_Nm;
} torquewright_region_limits;

/* From one speed to the next: straight bounds. */
typedef struct torquewright_region_row {
  double speed_rad_s;
  double next_speed_rad_s;
  double least_Nm; /* at speed_rad_s */
  double least_slope_Nm_s_rad;
  double greatest_Nm;
  double greatest_slope_Nm_s_rad;
} torquewright_region_row;

/* A bound over voltage and temperature. Place 2.25 is a quarter of the way from corner 2 to corner
 * 3, wherever a condition puts those. Conditions follow one another, temperatures within voltages. */
typedef struct torquewright_region_bound {
  size_t corners;
  size_t places;
  size_t rest_place; /* at rest from below; the next is from above */
  const double* corner_rad_s;
  const double* place;
  const double* torque_Nm;
} torquewright_region_bound;

typedef struct torquewright_region {
  double peak_torque_Nm;
  double voltage_V; /* of the rows */
  double temperature_K;
  const torquewright_region_row* row;
  size_t rows;
  torquewright_region_limits rest;
  const unsigned short* first_row; /* at the start of each of `cells` equal cells of speed */
  size_t cells;
  double cells_per_rad_s;
  size_t voltages; /* 0: no grid */
  size_t temperatures;
  const double* grid_voltage_V;
  const double* grid_temperature_K;
  torquewright_region_bound least;
  torquewright_region_bound greatest;
} torquewright_region;

static inline double torquewright_region_within(double value, double least, double greatest) {
  const double raised = value < least ? least : value;
  return raised > greatest ? greatest : raised;
}

/* At a velocity [rad/s], at the voltage and temperature of the rows. */
static inline torquewright_region_limits torquewright_region_limits_at(
    const torquewright_region* region, double velocity_rad_s) {
  const torquewright_region_row* row = region->row;
  torquewright_region_limits limits;
  double within, past;
  size_t cell;
  if (!(velocity_rad_s != 0.0)) return region->rest;
  within = torquewright_region_within(velocity_rad_s, row[0].speed_rad_s,
                                      row[region->rows - 1].speed_rad_s);
  if (!(within == within)) return region->rest;
  cell = (size_t)(long)((within - row[0].speed_rad_s) * region->cells_per_rad_s);
  row += region->first_row[cell < region->cells ? cell : region->cells];
  while (row->next_speed_rad_s <= within) ++row;
  past = within - row->speed_rad_s;
  limits.least_Nm = row->least_Nm + past * row->least_slope_Nm_s_rad;
  limits.greatest_Nm = row->greatest_Nm + past * row->greatest_slope_Nm_s_rad;
  return limits;
}

/* The torque [Nm] within the limits; what is no number stays none. */
static inline double torquewright_region_clip(const torquewright_region* region, double torque_Nm,
                                              double velocity_rad_s) {
  const torquewright_region_limits at = torquewright_region_limits_at(region, velocity_rad_s);
  const double clipped = torquewright_region_within(torque_Nm, at.least_Nm, at.greatest_Nm);
  return velocity_rad_s == velocity_rad_s ? clipped : velocity_rad_s;
}

/* `count` samples; clipped_Nm may be torque_Nm itself. */
static inline void torquewright_region_clip_all(const torquewright_region* region,
                                                const double* torque_Nm,
                                                const double* velocity_rad_s, double* clipped_Nm,
                                                size_t count) {
  const torquewright_region copy = *region;
  size_t i;
  for (i = 0; i < count; ++i) {
    clipped_Nm[i] = torquewright_region_clip(&copy, torque_Nm[i], velocity_rad_s[i]);
  }
}

/* The last of `count` ascending numbers at or before a value, but for the last of all. */
static inline size_t torquewright_region_before(const double* ascending, size_t count,
                                                double value) {
  size_t low = 0, high = count - 1;
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    if (ascending[middle] <= value) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

static inline double torquewright_region_share(double from, double to, double value) {
  return to > from ? torquewright_region_within((value - from) / (to - from), 0.0, 1.0) : 0.0;
}

/* Four conditions around one, and how much of each. */
typedef struct torquewright_region_mixture {
  size_t condition[4];
  double weight[4];
} torquewright_region_mixture;

static inline torquewright_region_mixture torquewright_region_mix(
    const torquewright_region* region, double voltage_V, double temperature_K) {
  const double* volts = region->grid_voltage_V;
  const double* kelvins = region->grid_temperature_K;
  const size_t columns = region->temperatures;
  torquewright_region_mixture mixture;
  size_t v0 = 0, v1 = 0, t0 = 0, t1 = 0;
  double v = 0.0, t = 0.0;
  if (region->voltages > 1) {
    v0 = torquewright_region_before(volts, region->voltages, voltage_V);
    v1 = v0 + 1;
    v = torquewright_region_share(volts[v0], volts[v1], voltage_V);
  }
  if (columns > 1) {
    t0 = torquewright_region_before(kelvins, columns, temperature_K);
    t1 = t0 + 1;
    t = torquewright_region_share(kelvins[t0], kelvins[t1], temperature_K);
  }
  mixture.condition[0] = v0 * columns + t0;
  mixture.condition[1] = v0 * columns + t1;
  mixture.condition[2] = v1 * columns + t0;
  mixture.condition[3] = v1 * columns + t1;
  mixture.weight[0] = (1.0 - v) * (1.0 - t);
  mixture.weight[1] = (1.0 - v) * t;
  mixture.weight[2] = v * (1.0 - t);
  mixture.weight[3] = v * t;
  return mixture;
}

static inline double torquewright_region_mixed(const torquewright_region_mixture* mixture,
                                               const double* values, size_t width, size_t i) {
  double sum = 0.0;
  int k;
  for (k = 0; k < 4; ++k) {
    sum += mixture->weight[k] * values[mixture->condition[k] * width + i];
  }
  return sum;
}

static inline double torquewright_region_bound_at(const torquewright_region_bound* bound,
                                                  const torquewright_region_mixture* mixture,
                                                  double velocity_rad_s) {
  const size_t corners = bound->corners, places = bound->places;
  double low = torquewright_region_mixed(mixture, bound->corner_rad_s, corners, 0);
  double high = torquewright_region_mixed(mixture, bound->corner_rad_s, corners, 1);
  double place, before, after, share;
  size_t corner = 0, i;
  while (corner + 2 < corners && velocity_rad_s >= high) {
    ++corner;
    low = high;
    high = torquewright_region_mixed(mixture, bound->corner_rad_s, corners, corner + 1);
  }
  place = (double)corner + torquewright_region_share(low, high, velocity_rad_s);
  i = torquewright_region_before(bound->place, places, place);
  share = torquewright_region_share(bound->place[i], bound->place[i + 1], place);
  before = torquewright_region_mixed(mixture, bound->torque_Nm, places, i);
  after = torquewright_region_mixed(mixture, bound->torque_Nm, places, i + 1);
  return before + share * (after - before);
}

/* At a supply voltage without load [V] and a winding temperature [K]; beyond the grid its edge
 * holds. A region without a grid has the limits of its rows. */
static inline torquewright_region_limits torquewright_region_limits_under(
    const torquewright_region* region, double velocity_rad_s, double voltage_V,
    double temperature_K) {
  torquewright_region_limits limits;
  torquewright_region_mixture mixture;
  if (region->voltages == 0) return torquewright_region_limits_at(region, velocity_rad_s);
  mixture = torquewright_region_mix(region, voltage_V, temperature_K);
  if (velocity_rad_s == 0.0) {
    const torquewright_region_bound* least = &region->least;
    const torquewright_region_bound* most = &region->greatest;
    double other;
    limits.least_Nm = torquewright_region_mixed(&mixture, least->torque_Nm, least->places,
                                                least->rest_place);
    other = torquewright_region_mixed(&mixture, least->torque_Nm, least->places,
                                      least->rest_place + 1);
    if (other < limits.least_Nm) limits.least_Nm = other;
    limits.greatest_Nm =
        torquewright_region_mixed(&mixture, most->torque_Nm, most->places, most->rest_place);
    other =
        torquewright_region_mixed(&mixture, most->torque_Nm, most->places, most->rest_place + 1);
    if (other > limits.greatest_Nm) limits.greatest_Nm = other;
    return limits;
  }
  limits.least_Nm = torquewright_region_bound_at(&region->least, &mixture, velocity_rad_s);
  limits.greatest_Nm = torquewright_region_bound_at(&region->greatest, &mixture, velocity_rad_s);
  return limits;
}

static inline double torquewright_region_clip_under(const torquewright_region* region,
                                                    double torque_Nm, double velocity_rad_s,
                                                    double voltage_V, double temperature_K) {
  const torquewright_region_limits at =
      torquewright_region_limits_under(region, velocity_rad_s, voltage_V, temperature_K);
  const double clipped = torquewright_region_within(torque_Nm, at.least_Nm, at.greatest_Nm);
  return velocity_rad_s == velocity_rad_s ? clipped : velocity_rad_s;
}

#endif /* TORQUEWRIGHT_REGION_IN_C */
)";

}  // namespace torquewright::actuator
