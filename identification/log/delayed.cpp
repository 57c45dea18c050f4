// SPDX-License-Identifier: Apache-2.0
#include "identification/log/delayed.hpp"

namespace torquewright::identification {

std::vector<double> delayed(const std::vector<double>& time_s, const std::vector<double>& values,
                            double delay_s) {
  if (!(delay_s > 0.0) || values.empty()) return values;
  std::vector<double> late(values.size());
  std::size_t next = 0;  // the first sample after the instant that is asked for
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double at_s = time_s[i] - delay_s;
    while (next < i && time_s[next] <= at_s) ++next;
    if (next == 0) {
      late[i] = values.front();
      continue;
    }
    const double share = (at_s - time_s[next - 1]) / (time_s[next] - time_s[next - 1]);
    late[i] = values[next - 1] + share * (values[next] - values[next - 1]);
  }
  return late;
}

}  // namespace torquewright::identification
