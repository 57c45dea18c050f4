/* SPDX-License-Identifier: Apache-2.0 */
/* clip.hpp compiled as C: what a simulator written in C gets. */
#include "actuator/clip.hpp"

double clip_parallelogram_in_c(double stall, double no_load, double greatest, double speed,
                               double torque);
void clip_table_in_c(const torquewright_table* table, const double* speed, const double* torque,
                     double* clipped, size_t count);

double clip_parallelogram_in_c(double stall, double no_load, double greatest, double speed,
                               double torque) {
  const torquewright_parallelogram region = {stall, no_load, greatest};
  double clipped = 0.0;
  torquewright_parallelogram_clip_all(&region, &speed, &torque, &clipped, 1);
  return clipped;
}

void clip_table_in_c(const torquewright_table* table, const double* speed, const double* torque,
                     double* clipped, size_t count) {
  torquewright_table_clip_all(table, speed, torque, clipped, count);
}
