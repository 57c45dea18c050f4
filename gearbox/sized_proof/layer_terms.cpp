// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/layer_terms.hpp"

#include <cmath>
#include <type_traits>

#include "gearbox/sized_proof/gear_mesh.hpp"
#include "gearbox/sized_proof/root_stress.hpp"
#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::gearbox::sized {
namespace {

template <class T>
constexpr bool is_number = std::is_same_v<T, double>;

/// Gears amid a box; any point of it would do.
CutGear<double> amid(const CutGear<Affine>& gear) {
  return cut_gear(gear.teeth, gear.shift.center, gear.tip.center);
}
GearMesh<double> amid(const GearMesh<Affine>& mesh) {
  const double between = mesh.between(), centre = mesh.centre.center;
  return meshed(mesh.is_inside, amid(mesh.first), amid(mesh.second), centre,
                working_tangent(between, centre));
}
const GearMesh<double>& amid(const GearMesh<double>& mesh) { return mesh; }

/// Where stress falls with the rounding of the hob (tests/gearbox/sized_proof holds it on a grid).
bool is_ruled(const LoadedTeeth& teeth, const CutGear<Affine>& gear) {
  return teeth.hob_depth == kStandardAddendum && gear.teeth >= 10.0 && gear.teeth <= 200.0 &&
         gear.shift.low >= -0.6 && gear.shift.high <= 1.1;
}

/// One layer's terms, condition by condition, the cheap ones first.
template <class T>
class Terms {
 public:
  Terms(const LoadedTeeth& teeth, std::size_t layer, const T& centre_mm, const T& shift,
        const Demands& demands)
      : teeth_(teeth),
        demands_(demands),
        layer_(layer),
        module_mm_(teeth.module_mm[layer]),
        centre_mm_(centre_mm),
        centre_((1.0 / module_mm_) * centre_mm),
        shift_(shift) {}

  LayerTerms<T> all() {
    if (layer_ == 0) {
      cut_sun();
    } else {
      planet_ = cut_gear(teeth_.planet[1], shift_, T(2.0 * shift_ + (teeth_.planet[1] + 2.0)));
    }
    if (teeth_.ring[layer_] > 0.0) cut_ring();
    set_mass();
    if (demands_.inertia) set_inertia();
    ask_planet();
    if (!is_over() && ring_) ask_ring();
    if (!is_over() && sun_) ask_sun();
    if (!is_over()) set_efficiencies();
    if (!is_over()) ask_flanks();
    if (!is_over()) ask_hobbed_roots();
    if (!is_over() && ring_) ask_ring_closely();
    return std::move(terms_);
  }

 private:
  bool is_over() const { return terms_.is_closed; }

  void require(const T& margin) {
    terms_.margins.push_back(margin);
    if constexpr (!is_number<T>) {
      if (margin.high < -kForgiven || margin.is_nowhere()) terms_.is_closed = true;
    }
  }

  void ask_width(const T& width_mm) {
    if constexpr (!is_number<T>) {
      if (width_mm.is_nowhere()) return;  // Then a margin says so, or evaluate goes another way.
      if (!(width_mm.low > 0.0)) return;
      const double kg = width_mm.low * terms_.kg_per_mm.low;
      if (width_mm.low > teeth_.widest_mm[layer_] + kForgiven || kg > demands_.heaviest_kg) {
        terms_.is_closed = true;
      }
    }
    terms_.width_mm.push_back(width_mm);
  }

  void cut_sun() {
    const double s = teeth_.sun, p = teeth_.planet[0];
    const T tangent = working_tangent(s + p, centre_);
    const T shifts = closing_shifts(s + p, tangent);
    const T increment = centre_ - 0.5 * (s + p);
    // The tips are shortened by what the shifts lose of each other.
    const T shortened = least(T(increment - shifts), T(0.0));
    const CutGear<T> sun =
        cut_gear(s, T(shifts - shift_), T(2.0 * (increment - shift_) + (s + 2.0)));
    planet_ = cut_gear(p, shift_, T(2.0 * (shift_ + shortened) + (p + 2.0)));
    sun_ = meshed(false, sun, planet_, centre_, tangent);
  }

  void cut_ring() {
    const double z = teeth_.ring[layer_], between = z - teeth_.planet[layer_];
    const T tangent = working_tangent(between, centre_);
    const T shift = shift_ + closing_shifts(between, tangent);
    ring_ = meshed(true, planet_, cut_gear(z, shift, T(2.0 * shift + (z - 2.0))), centre_, tangent);
  }

  /// Diameter of the reference profile's middle line, in m.
  T middle_m(const CutGear<T>& gear) const {
    return (1e-3 * module_mm_) * (2.0 * gear.shift + gear.teeth);
  }
  double rim_m(double depth) const { return 2e-3 * (depth * module_mm_ + teeth_.wall_mm[layer_]); }
  double areal_kg() const { return teeth_.density_kg_m3 * kPi / 4.0 * 1e-3; }

  T ring_area() const {
    const double rim = rim_m(teeth_.shaper_depth);
    return rim * (2.0 * middle_m(ring_->second) + rim);
  }
  T sun_area() const {
    const double rim = rim_m(teeth_.hob_depth);
    const T size = middle_m(sun_->first);
    // k (2 d - k), or all of the disc where no bore is left.
    return rim * (2.0 * size - rim) + squared(least(T(size - rim), T(0.0)));
  }
  T planets_area() const { return teeth_.planets * squared(middle_m(planet_)); }

  void set_mass() {
    T area = planets_area();
    if (ring_) area = area + ring_area();
    if (sun_) area = area + sun_area();
    terms_.kg_per_mm = areal_kg() * area;
  }

  /// Energy over half the square of the output's speed.
  void set_inertia() {
    const double ratio_squared = teeth_.ratio * teeth_.ratio;
    const T size_squared = squared(middle_m(planet_));
    const T arm_squared = squared((1e-3 * teeth_.carrier_speed) * centre_mm_);
    T sum = (ratio_squared * teeth_.planets) * size_squared *
            (arm_squared + (teeth_.planet_speed * teeth_.planet_speed / 8.0) * size_squared);
    if (sun_) {
      const T size = middle_m(sun_->first);
      const T bore = greatest(T(size - rim_m(teeth_.hob_depth)), T(0.0));
      sum = sum + (ratio_squared / 8.0) * sun_area() * (squared(size) + squared(bore));
    }
    if (ring_) {
      const double speed = teeth_.ratio * teeth_.ring_speed[layer_];
      const T size = middle_m(ring_->second);
      sum = sum + (speed * speed / 8.0) * ring_area() *
                      (squared(size) + squared(T(size + rim_m(teeth_.shaper_depth))));
    }
    terms_.kg_m2_per_mm = areal_kg() * sum;
  }

  T undercut(const CutGear<T>& gear) const {
    return gear.shift -
           (teeth_.undercut_depth - 0.5 * gear.teeth * kReferenceSine * kReferenceSine);
  }

  void ask_planet() {
    require((2.0 * teeth_.half_chord) * centre_mm_ - module_mm_ * planet_.tip -
            teeth_.min_neighbour_mm);
    require(undercut(planet_));
    if (ring_) return;
    // No ring is around it.
    require(teeth_.space_mm - 2.0 * centre_mm_ - module_mm_ * planet_.tip);
    require(tip_thickness(planet_) - teeth_.min_tip_thickness);
  }

  void ask_ring() {
    const CutGear<T>& ring = ring_->second;
    const T root_radius = ring.shift + (0.5 * ring.teeth + teeth_.shaper_depth);
    require((teeth_.space_mm - 2.0 * teeth_.wall_mm[layer_]) - (2.0 * module_mm_) * root_radius);
    require(ring.tip - ring.teeth * kReferenceCosine);
    require(ring_->deepest_on_first());
    require(ring_->contact_ratio - teeth_.min_contact_ratio);
    require(module_mm_ * (0.5 * ring.tip - centre_ - planet_.root_radius(teeth_.hob_depth)));
    require(module_mm_ * (root_radius - centre_ - 0.5 * planet_.tip));
    hob_[0] = largest_hob_radius(teeth_.hob_depth, planet_, ring_->deepest_on_first());
    require(hob_[0] - teeth_.hob_radius.value_or(0.0));
  }

  void ask_sun() {
    const CutGear<T>& sun = sun_->first;
    require(undercut(sun));
    require(sun.shift - teeth_.least_shift);
    require(teeth_.greatest_shift - sun.shift);
    require(sun_->contact_ratio - teeth_.min_contact_ratio);
    require(sun_->deepest_on_first());
    require(sun_->deepest_on_second());
    require(tip_thickness(sun) - teeth_.min_tip_thickness);
    const T sun_root = sun.root_radius(teeth_.hob_depth);
    require(module_mm_ * (centre_ - 0.5 * planet_.tip - sun_root));
    require(module_mm_ * (centre_ - 0.5 * sun.tip - planet_.root_radius(teeth_.hob_depth)));
    hob_[1] = largest_hob_radius(teeth_.hob_depth, sun, sun_->deepest_on_first());
    hob_[2] = largest_hob_radius(teeth_.hob_depth, planet_, sun_->deepest_on_second());
    require(hob_[1] - teeth_.hob_radius.value_or(0.0));
    require(hob_[2] - teeth_.hob_radius.value_or(0.0));
    if (!demands_.hollow_shaft_mm) return;
    require((2.0 * module_mm_) * sun_root -
            (2.0 * teeth_.hollow_wall_mm + *demands_.hollow_shaft_mm));
  }

  void set_efficiencies() {
    if (!demands_.efficiency) return;
    if (sun_) terms_.efficiency[0] = mesh_efficiency(*sun_, teeth_.friction);
    if (ring_) terms_.efficiency[1] = mesh_efficiency(*ring_, teeth_.friction);
  }

  MeshLoad sun_load() const { return {teeth_.sun_force_N, module_mm_}; }
  MeshLoad ring_load() const { return {teeth_.ring_force_N[layer_], module_mm_}; }

  void set_softness() {
    if (!teeth_.least_Nm_rad) return;
    T sum{0.0};
    const auto add = [&](const GearMesh<T>& mesh, double softness) {
      sum = sum + softness / (0.75 * mesh.contact_ratio + 0.25);
    };
    if (sun_) add(*sun_, teeth_.sun_softness);
    if (ring_) add(*ring_, teeth_.ring_softness[layer_]);
    terms_.softness = sum;
    ask_width(*teeth_.least_Nm_rad * sum);
  }

  void ask_flanks() {
    ask_width(T(teeth_.least_width_mm));
    set_softness();
    if (ring_) ask_width(flank_mm(teeth_, *ring_, false, ring_load()));
    if (!sun_) return;
    ask_width(flank_mm(teeth_, *sun_, false, sun_load()));
    ask_width(flank_mm(teeth_, *sun_, true, sun_load()));
  }

  T hob_radius(const T& largest) const {
    if (teeth_.hob_radius) return T(*teeth_.hob_radius);
    return greatest(least(largest, T(kHobTipRadius)), T(0.0));
  }

  void ask_hobbed(const GearMesh<T>& mesh, bool of_second, const T& radius, const MeshLoad& load,
                  double alternating) {
    if (is_over()) return;
    T stress_radius = radius;
    if constexpr (!is_number<T>) {
      constexpr double kWellKnown = 0.02;
      const bool is_known = radius.high - radius.low < kWellKnown;
      if (!is_known && is_ruled(teeth_, of_second ? mesh.second : mesh.first)) {
        stress_radius = T(radius.high);
      }
    }
    ask_width(external_root_mm(teeth_, mesh, of_second, stress_radius, radius, load, alternating));
  }

  void ask_hobbed_roots() {
    const double alternating = layer_ == 0 ? teeth_.alternating : 1.0;
    T largest = ring_ ? hob_[0] : hob_[2];
    if (ring_ && sun_) largest = least(hob_[0], hob_[2]);
    const T of_planet = hob_radius(largest);
    if (ring_) ask_hobbed(*ring_, false, of_planet, ring_load(), alternating);
    if (!sun_) return;
    ask_hobbed(*sun_, true, of_planet, sun_load(), alternating);
    ask_hobbed(*sun_, false, hob_radius(hob_[1]), sun_load(), 1.0);
  }

  void ask_ring_closely() {
    require(tip_thickness(planet_) - teeth_.min_tip_thickness);
    require(ring_tip_thickness(ring_->second) - teeth_.min_tip_thickness);
    require(trochoid_margin_rad(*ring_));
    if (is_over()) return;
    const RingShaper<T> shaper = ring_shaper(teeth_, *ring_);
    double place = 0.5;
    if (shaper.exists) {
      require(shaper.largest - teeth_.shaper_radius.value_or(0.0));
      const GearMesh<double>& middle = amid(*ring_);
      const RingShaper<double> tool = ring_shaper(teeth_, middle);
      if (tool.exists) place = worst_place(middle, tool);
      if (!(place >= 0.0 && place <= 1.0)) place = 0.5;
    }
    if (is_over()) return;
    if (const auto width_mm = ring_root_mm(teeth_, *ring_, shaper, ring_load(), place)) {
      ask_width(*width_mm);
    }
  }

  const LoadedTeeth& teeth_;
  const Demands& demands_;
  std::size_t layer_;
  double module_mm_;
  T centre_mm_, centre_;
  T shift_;
  CutGear<T> planet_;
  std::optional<GearMesh<T>> sun_, ring_;
  /// Largest hobs: of the planet in its ring, of the sun, of planet 1 beside it.
  std::array<T, 3> hob_;
  LayerTerms<T> terms_;
};

}  // namespace

LayerTerms<double> layer_terms(const LoadedTeeth& teeth, std::size_t layer, double centre_mm,
                               double shift, const Demands& demands) {
  return Terms<double>(teeth, layer, centre_mm, shift, demands).all();
}

LayerTerms<Affine> layer_terms(const LoadedTeeth& teeth, std::size_t layer, const Affine& centre_mm,
                               const Affine& shift, const Demands& demands) {
  return Terms<Affine>(teeth, layer, centre_mm, shift, demands).all();
}

double sun_clearance_mm(const LoadedTeeth& teeth, double shift_1, double shift_2) {
  return teeth.module_mm[0] * (0.5 * teeth.planet[0] - 1.0 + shift_1) -
         teeth.module_mm[1] * (0.5 * teeth.planet[1] + 1.0 + shift_2);
}

CentreRange centre_range(const LoadedTeeth& teeth) {
  const double between = teeth.sun + teeth.planet[0];
  const auto centre_mm = [&](double shifts) {
    const double value = kReferenceInvolute + 2.0 * kReferenceTangent * shifts / between;
    const double tangent = tangent_of_involute(std::max(0.0, value));
    return 0.5 * teeth.module_mm[0] * between * kReferenceCosine *
           std::sqrt(1.0 + tangent * tangent);
  };
  CentreRange range{centre_mm(2.0 * teeth.least_shift) * (1.0 - 1e-12),
                    centre_mm(2.0 * teeth.greatest_shift) * (1.0 + 1e-12)};
  for (const std::size_t layer : {0U, 1U}) {
    if (teeth.ring[layer] == 0.0) continue;
    const double base_mm =
        0.5 * teeth.module_mm[layer] * (teeth.ring[layer] - teeth.planet[layer]) * kReferenceCosine;
    range.low_mm = std::max(range.low_mm, base_mm);
  }
  return range;
}

}  // namespace torquewright::gearbox::sized
