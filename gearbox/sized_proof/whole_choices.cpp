// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/whole_choices.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "gearbox/sized_proof/enclosures/affine.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train/central_gears.hpp"

namespace torquewright::gearbox::sized {
namespace {

constexpr double kNearShare = 1e-9;

std::int64_t whole_part(const Rational& value) {
  return mpz_class(value.get_num() / value.get_den()).get_si();
}

Rational rational(std::int64_t number) { return {static_cast<long>(number)}; }

/// Of one planet count and pair of modules.
class Walk {
 public:
  Walk(const Problem& problem, const std::function<bool(const WholeNumbers&)>& take)
      : problem_(problem),
        parts_(train_parts(problem.topology)),
        take_(take),
        off_(problem.synthesis->ring_teeth_off),
        low_(problem.target_ratio * (1 - problem.ratio_tolerance)),
        high_(problem.target_ratio * (1 + problem.ratio_tolerance)) {
    if (low_ > high_) std::swap(low_, high_);
    near_low_ = io::nearest(low_) - kNearShare * std::abs(io::nearest(low_));
    near_high_ = io::nearest(high_) + kNearShare * std::abs(io::nearest(high_));
    has_first_ring_ = parts_.ring_of_layer(0).has_value();
    has_second_layer_ = parts_.layer_count() > 1;
  }

  /// False: it was ended.
  bool through(std::int64_t planets, const Rational& first_mm, const Rational& second_mm) {
    whole_ = {};
    whole_.planets = planets;
    whole_.module_mm = {first_mm, second_mm};
    first_bore_ = whole_part(problem_.rotor_inner_diameter_mm / first_mm);
    second_bore_ = whole_part(problem_.rotor_inner_diameter_mm / second_mm);
    modules_ = io::nearest(Rational(first_mm / second_mm));
    const std::int64_t spare = has_first_ring_ ? off_ : 0;
    for (whole_.sun = minimum(0); whole_.sun <= first_bore_; ++whole_.sun) {
      for (whole_.planet[0] = minimum(1);
           whole_.sun + 2 * whole_.planet[0] - spare <= first_bore_ && has_room();
           ++whole_.planet[0]) {
        if (!first_rings()) return false;
      }
    }
    return true;
  }

 private:
  std::int64_t minimum(std::size_t gear) const {
    return problem_.min_teeth.at(std::string(parts_.gears[gear]));
  }

  /// pi/n - asin(P/(S + P)) against its minimum; where rounding decides, with 256 bits' worth of
  /// doubt on the generous side.
  bool has_room() const {
    const double planet = real(whole_.planet[0]);
    const double room_rad =
        std::numbers::pi / real(whole_.planets) - std::asin(planet / (real(whole_.sun) + planet));
    return room_rad >= io::nearest(problem_.min_carrier_clearance_rad) - 1e-13;
  }

  bool first_rings() {
    whole_.ring = {};
    if (!has_first_ring_) return second_layers();
    const std::int64_t coaxial = whole_.sun + 2 * whole_.planet[0];
    for (std::int64_t ring = coaxial - off_; ring <= std::min(first_bore_, coaxial + off_);
         ++ring) {
      whole_.ring = {ring, 0};
      if ((whole_.sun + ring) % whole_.planets != 0) continue;
      if (!(has_second_layer_ ? second_layers() : offered())) return false;
    }
    return true;
  }

  bool second_layers() {
    const double between = modules_ * real(whole_.sun + whole_.planet[0]);
    const auto low = static_cast<std::int64_t>(std::ceil(between - real(off_) - kNearShare));
    const auto high = static_cast<std::int64_t>(std::floor(between + real(off_) + kNearShare));
    // Of the paper's train planet 2 is the smaller by a tooth for each planet; else the bore ends
    // it.
    const std::int64_t most =
        parts_.is_the_papers ? whole_.planet[0] - whole_.planets : second_bore_ - low;
    for (std::int64_t planet = minimum(2); planet <= most; ++planet) {
      for (std::int64_t ring = planet + low; ring <= planet + high; ++ring) {
        if (!parts_.is_the_papers && ring > second_bore_) continue;
        whole_.planet[1] = planet;
        whole_.ring[1] = ring;
        if (!offered()) return false;
      }
    }
    whole_.planet[1] = whole_.ring[1] = 0;
    return true;
  }

  /// The choice, if it meets the rest; false: it was the last one that is wanted.
  bool offered() {
    const std::size_t held = parts_.gear_layers[parts_.held_ring];
    const double roll = real(whole_.ring[held]) / real(whole_.planet[held]);
    const double sun = 1.0 + roll * real(whole_.planet[0]) / real(whole_.sun);
    double output = 1.0;
    if (parts_.output_ring) {
      const std::size_t layer = parts_.gear_layers[*parts_.output_ring];
      output -= roll * real(whole_.planet[layer]) / real(whole_.ring[layer]);
    }
    const double near = sun / output;
    if (!(near >= near_low_ && near <= near_high_)) return true;
    if (!meets_ratio() || (has_second_layer_ && !are_planets_alike())) return true;
    return !meets_ceilings(near) || take_(whole_);
  }

  bool meets_ratio() const {
    std::vector<Rational> teeth;
    for (const std::int64_t count : teeth_in_order(parts_, whole_)) {
      teeth.push_back(rational(count));
    }
    const Rational ratio = basic_ratios<Rational>(parts_, teeth).reduction();
    return ratio >= low_ && ratio <= high_;
  }

  /// n g divides R2 P1 - R1 P2, g = gcd(P1, P2); the sun, turned over, stands for a ring that
  /// planet 1 lacks. kinematics.md eq. (10), (20).
  bool are_planets_alike() const {
    const auto& [p1, p2] = whole_.planet;
    const std::int64_t first = has_first_ring_ ? whole_.ring[0] : -whole_.sun;
    return (whole_.ring[1] * p1 - first * p2) % (whole_.planets * std::gcd(p1, p2)) == 0;
  }

  bool meets_ceilings(double ratio) const {
    const auto& inertia_kg_m2 = problem_.floors.reflected_inertia_kg_m2;
    if (inertia_kg_m2 &&
        ratio * ratio * io::nearest(problem_.rotor_inertia_kg_m2) >= io::nearest(*inertia_kg_m2)) {
      return false;
    }
    const auto& backlash = problem_.floors.backlash_rad_per_mm;
    return !backlash || backlash_rad_per_mm() <= io::nearest(*backlash) * (1.0 + kNearShare);
  }

  /// It goes with base circles, which no shift changes.
  double backlash_rad_per_mm() const {
    std::vector<double> teeth, base_mm;
    const std::vector<std::int64_t> counts = teeth_in_order(parts_, whole_);
    for (std::size_t gear = 0; gear < counts.size(); ++gear) {
      teeth.push_back(real(counts[gear]));
      base_mm.push_back(0.5 * kReferenceCosine * teeth.back() *
                        io::nearest(whole_.module_mm[parts_.gear_layers[gear]]));
    }
    const auto by_mesh = mesh_backlash_rad_per_m(parts_, teeth, base_mm);
    return std::accumulate(by_mesh.begin(), by_mesh.end(), 0.0);
  }

  const Problem& problem_;
  const TrainParts& parts_;
  const std::function<bool(const WholeNumbers&)>& take_;
  std::int64_t off_;
  Rational low_, high_;
  double near_low_ = 0.0, near_high_ = 0.0;
  bool has_first_ring_ = false, has_second_layer_ = false;
  std::int64_t first_bore_ = 0, second_bore_ = 0;
  double modules_ = 1.0;  ///< First over second.
  WholeNumbers whole_;
};

}  // namespace

void for_each_choice(const Problem& problem, const std::function<bool(const WholeNumbers&)>& take) {
  Walk walk(problem, take);
  const std::vector<Rational>& second_mm = problem.synthesis->layer_2_module_mm;
  for (const std::int64_t planets : problem.planet_count) {
    for (const Rational& first_mm : problem.module_mm) {
      const std::vector<Rational> own{first_mm};
      for (const Rational& other_mm : second_mm.empty() ? own : second_mm) {
        if (!walk.through(planets, first_mm, other_mm)) return;
      }
    }
  }
}

}  // namespace torquewright::gearbox::sized
