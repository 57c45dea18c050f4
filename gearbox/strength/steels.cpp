// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/steels.hpp"

#include <algorithm>

namespace torquewright::gearbox {

const std::vector<Steel>& steels() {
  static const std::vector<Steel> list{
      {"case_hardened",
       {.treatment = Treatment::kCaseHardened,
        .young_MPa = 206000.0,
        .poisson = 0.3,
        .bending_endurance_MPa = 430.0,
        .contact_endurance_MPa = 1500.0,
        .yield_MPa = {}},
       "The numbers are GEARpie's (cfernandesFEUP/GEARpie, CLASSES/MATERIAL_LIBRARY.py, STEEL), "
       "which names no grade; a worked example of DIN 3990-11 (hanslhansl/din3990, "
       "examples/example_1.py) has the same of case-hardened steel, sigma_FE 860 = 2 x 430."},
      {"nitriding_steel_best",
       {.treatment = Treatment::kNitrided,
        .young_MPa = 206000.0,
        .poisson = 0.3,
        .bending_endurance_MPa = 468.0,
        .contact_endurance_MPa = 1450.0,
        .yield_MPa = {}},
       "The numbers of waa552/fyp-website, data.js, nitWro, 650 to 900 HV; it names no quality, "
       "and "
       "they are the highest of such tables: for steel and treatment that are proved."},
      {"nitrided_tempered_steel_best",
       {.treatment = Treatment::kNitrided,
        .young_MPa = 206000.0,
        .poisson = 0.3,
        .bending_endurance_MPa = 432.0,
        .contact_endurance_MPa = 1217.0,
        .yield_MPa = {}},
       "The numbers of waa552/fyp-website, data.js, nitWroThr, 450 to 650 HV; it names no quality, "
       "and they are the highest of such tables: for steel and treatment that are proved."},
      {"case_hardened_best",
       {.treatment = Treatment::kCaseHardened,
        .young_MPa = 206000.0,
        .poisson = 0.3,
        .bending_endurance_MPa = 525.0,
        .contact_endurance_MPa = 1650.0,
        .yield_MPa = {}},
       "The numbers of waa552/fyp-website, data.js, caseHardWro, 660 to 800 HV; it names no "
       "quality, "
       "and they are the highest of such tables: for steel and treatment that are proved."}};
  return list;
}

const Steel* find_steel(std::string_view name) {
  const auto found = std::find_if(steels().begin(), steels().end(),
                                  [&](const Steel& steel) { return steel.name == name; });
  return found == steels().end() ? nullptr : &*found;
}

}  // namespace torquewright::gearbox
