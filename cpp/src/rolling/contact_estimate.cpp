#include "rolling/contact_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "modal/layer_stack.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll::detail {
namespace {

/// Smallest moduli of a group of layers.
struct SmallestModuli {
  double shear;     ///< shear modulus [Pa]
  double confined;  ///< modulus of a material that cannot expand sideways [Pa]
};

/// Layers between two rigid bodies, or a half-space.
struct Part {
  double thickness;  ///< [m]
  SmallestModuli moduli;
};

/// Total thickness and smallest moduli of some layers. `frequency` is that at which material passes the contact.
Part part_of(std::span<const NamedLayer> layers, double angular_speed, double frequency) {
  double thickness = 0.0;
  SmallestModuli least{.shear = std::numeric_limits<double>::infinity(),
                       .confined = std::numeric_limits<double>::infinity()};
  for (const auto& [name, layer] : layers) {
    thickness += layer.thickness;
    const auto moduli = modulus_in_rolling(layer.shear_modulus, angular_speed, std::array{0.0, frequency});
    const double shear = std::max(moduli.front().real(), 0.5 * std::abs(moduli.back()));
    const double ratio = shear_ratio(layer, shear);
    least.shear = std::min(least.shear, shear);
    if (ratio > 0.0) least.confined = std::min(least.confined, shear / ratio);
  }
  return {.thickness = thickness, .moduli = least};
}

/// Layers of the rolling body, base of the counterbody, and layers of the counterbody.
std::vector<Part> parts_of(const RollingPair& pair, double angular_speed, double frequency) {
  std::vector<Part> parts;
  const auto append = [&](std::span<const NamedLayer> layers) {
    if (!layers.empty()) parts.push_back(part_of(layers, angular_speed, frequency));
  };
  append(pair.body->layers());
  const std::span<const NamedLayer> counterbody = pair.on->layers();
  const std::size_t base = !counterbody.empty() && std::isinf(counterbody.front().layer.thickness) ? 1 : 0;
  append(counterbody.first(base));
  append(counterbody.subspan(base));
  return parts;
}

// Squares of the ratios of estimated to actual half-widths, such that the estimate from a penetration is as large as
// that from its load: for 14 pairs, the first meshes have 0.6 to 1.5 times as many nodes across the contact.
constexpr double kThickExcess = 2.1;
constexpr double kIncompressibleExcess = 4.0;
constexpr double kCompressibleExcess = 2.0;
constexpr double kLineExcess = 1.8;   // further factor in line contact
constexpr double kTreadExcess = 1.3;  // further factor of treads, whose contacts may end at their faces

/// Load of a contact, and the penetration that goes with it.
struct Pressed {
  double load;         ///< [N], or per length
  double penetration;  ///< [m]
};

/// Contact of half-width `a`, from the limits of thick and thin layers.
Pressed pressed_at(double a, double radius, const Part& part, const ContactForm& form) {
  const auto& [thickness, moduli] = part;
  const double strip = std::pow(a, form.dimensions) / radius;
  const double hertz = form.thick * moduli.shear * strip * a;  // Poisson's ratio 0: most compliant
  const double incompressible = form.incompressible * moduli.shear * strip * std::pow(a, 4) / std::pow(thickness, 3);
  const double compressible = form.confined * moduli.confined * strip * a * a / thickness;
  const double thin = std::min(incompressible, compressible);
  // Volume is conserved in an incompressible layer. In line contact, every octave of thickness adds to the penetration.
  const double dimensions = form.dimensions;
  const double of_thin = incompressible < compressible ? dimensions / (2.0 * (dimensions + 2.0)) / kIncompressibleExcess
                                                       : 0.5 / kCompressibleExcess;
  const double of_thick =
      (form.is_line() ? 0.5 * std::log1p(4.0 * std::min(thickness, radius) / a) : 1.0) / kThickExcess;
  const double load = hertz + thin;
  return {.load = load, .penetration = a * a / radius * (hertz * of_thick + thin * of_thin) / load};
}

double load_at(double a, double radius, const Part& part, const ContactForm& form) {
  return pressed_at(a, radius, part, form).load;
}

/// Radius of a circle, or of a line contact, with the mean of the curvatures.
double mean_radius(const RollingPair& pair) {
  const Curvatures& own = pair.body->curvatures();
  const Curvatures& counterbody = pair.on->curvatures();
  return pair.body->form().dimensions / (own.along + counterbody.along + own.across + counterbody.across);
}

/// Load as a sum over strips across the contact. Each strip is a roller with the gap that the crown leaves.
/// @param[in] a half-width of the contact of the middle strip [m]
double load_of_strips(double a, const RollingPair& pair, const Part& part) {
  constexpr int kStrips = 32;  // the load is a smooth function of a to half a percent
  const double along = pair.body->curvatures().along + pair.on->curvatures().along;
  const double across = pair.body->curvatures().across + pair.on->curvatures().across;
  const double half = std::min(0.5 * width(pair), a * std::sqrt(along / across));
  double load = 0.0;
  for (int i = 0; i < kStrips; ++i) {
    const double z = half * (i + 0.5) / kStrips;
    const double strip = std::sqrt(std::max(a * a - z * z * across / along, 0.0));
    load += 2.0 * half / kStrips * load_at(strip, 1.0 / along, part, kLineContact);
  }
  return load;
}

/// Smallest half-width of a contact that is large enough according to a monotonic criterion.
template <class IsLargeEnough>
double smallest_radius(const RollingPair& pair, const IsLargeEnough& is_large_enough) {
  double low = 0.0;
  double high = mean_radius(pair);
  while (!is_large_enough(high) && std::isfinite(high)) high *= 2.0;
  // Bisect to the last digits: meshes depend on this size, and results should be smooth functions of the load.
  while (high - low > 1e-14 * high) {
    const double middle = 0.5 * (low + high);
    (is_large_enough(middle) ? high : low) = middle;
  }
  return high;
}

double contact_radius(const RollingPair& pair, const std::vector<Part>& parts, double load) {
  const double radius = mean_radius(pair);
  const auto load_of = [&](const Part& part, double a) {
    return std::isfinite(width(pair)) ? load_of_strips(a, pair, part) : load_at(a, radius, part, pair.body->form());
  };
  return smallest_radius(pair, [&](double a) {
    if (parts.size() == 1) return load_of(parts.front(), a) >= load;
    double compliance = 0.0;  // compliances of the parts add up
    for (const Part& part : parts) compliance += 1.0 / load_of(part, a);
    return compliance * load <= 1.0;
  });
}

/// Half-width at a penetration, as much too large as `contact_radius`.
double contact_radius_at(const RollingPair& pair, const std::vector<Part>& parts, double penetration) {
  const bool is_tread = std::isfinite(width(pair));
  const double radius =
      is_tread ? 1.0 / (pair.body->curvatures().along + pair.on->curvatures().along) : mean_radius(pair);
  const ContactForm& form = is_tread ? kLineContact : pair.body->form();
  const double excess = is_tread ? kTreadExcess : form.is_line() ? kLineExcess : 1.0;
  return smallest_radius(pair, [&](double a) {
    double compliance = 0.0;
    double weighted = 0.0;
    for (const Part& part : parts) {
      const Pressed pressed = pressed_at(a, radius, part, form);
      compliance += 1.0 / pressed.load;
      weighted += pressed.penetration / pressed.load;
    }
    return weighted >= excess * penetration * compliance;
  });
}

/// Half-width of the contact across, for a given half-width along.
double reach_across(const RollingPair& pair, double along) {
  if (std::isinf(width(pair))) return along;
  const double curvature = pair.body->curvatures().across + pair.on->curvatures().across;
  const double ratio = (pair.body->curvatures().along + pair.on->curvatures().along) / curvature;
  // Exponent for ellipses: 1/2 in thin layers, and about 2/3 on a half-space.
  const double across = along * std::pow(ratio, ratio > 1.0 ? 2.0 / 3.0 : 0.5);
  return std::min(across, 0.5 * width(pair));
}

/// @param[in] radius_of function that returns the half-width of the contact for the moduli of its parts
template <class RadiusOf>
ContactReach estimate(const RollingPair& pair, double angular_speed, const RadiusOf& radius_of) {
  constexpr int kPasses = 3;  // a fixed number, so that the result is a smooth function of the load
  double radius = radius_of(parts_of(pair, angular_speed, 0.0));
  for (int pass = 0; pass < kPasses; ++pass) {
    const double frequency = angular_speed * std::max(1.0, pair.body->radius() / radius);
    radius = radius_of(parts_of(pair, angular_speed, frequency));
  }
  return {.along = radius, .across = reach_across(pair, radius)};
}

}  // namespace

ContactReach estimate_contact(const RollingPair& pair, double angular_speed, double load) {
  return estimate(pair, angular_speed,
                  [&](const std::vector<Part>& parts) { return contact_radius(pair, parts, load); });
}

namespace {

/// Tension that the edges of an adhesive contact of half-width `a` take from its load.
double edge_tension(double a, double work, const std::vector<Part>& parts, const ContactForm& form) {
  double compliance = 0.0;  // of the surfaces
  double lifted = 0.0;      // of layers that are thin
  for (const Part& part : parts) {
    compliance += 0.5 / part.moduli.shear;
    if (std::isfinite(part.thickness)) lifted += part.thickness / part.moduli.confined;
  }
  const double dimensions = form.dimensions;
  const double thick = form.is_line() ? 2.0 * std::numbers::pi * a : 8.0 * std::numbers::pi * std::pow(a, 3);
  const double area = form.is_line() ? 2.0 * a : std::numbers::pi * std::pow(a, dimensions);
  const double thin = lifted > 0.0 ? area * std::sqrt(2.0 * work / lifted) : 0.0;
  return std::max(std::sqrt(thick * work / compliance), thin);
}

}  // namespace

double equivalent_load(const RollingPair& pair, const LoadCase& load_case) {
  constexpr int kPasses = 60;  // each reduces the error at least to a half
  const double given = std::max(load_case.load.value_or(0.0), 0.0);
  const double work = load_case.adhesion->separation_work.value_or(load_case.adhesion->work);
  double load = given;
  for (int pass = 0; pass < kPasses; ++pass) {
    const double a = load > 0.0 ? estimate_contact(pair, load_case.angular_speed, load).along : mean_radius(pair);
    const double frequency = load_case.angular_speed * std::max(1.0, pair.body->radius() / a);
    const double tension = edge_tension(a, work, parts_of(pair, load_case.angular_speed, frequency), pair.body->form());
    load = given + tension;
  }
  return load;
}

ContactReach estimate_contact(const PairAtSpeed& pair, const LoadCase& load_case) {
  if (load_case.adhesion) {
    const ContactReach attracted = estimate_contact(pair, load_case.angular_speed, equivalent_load(pair, load_case));
    if (!load_case.penetration || !(*load_case.penetration + pair.centrifugal > 0.0)) return attracted;
    LoadCase pressed = load_case;
    pressed.adhesion.reset();
    const ContactReach reach = estimate_contact(pair, pressed);
    return reach.along > attracted.along ? reach : attracted;
  }
  if (load_case.load) return estimate_contact(pair, load_case.angular_speed, *load_case.load);
  const double penetration = *load_case.penetration + pair.centrifugal;
  return estimate(pair, load_case.angular_speed,
                  [&](const std::vector<Part>& parts) { return contact_radius_at(pair, parts, penetration); });
}

double load_upper_bound(const RollingPair& pair, double stiffest_modulus) {
  const double radius = pair.body->radius();
  const double hertz = 16.0 / 3.0 * stiffest_modulus * radius * radius;
  const double bonded =
      std::numbers::pi * stiffest_modulus * std::pow(radius, 5) / (32.0 * std::pow(thickness(pair), 3));
  const double wide = std::isfinite(width(pair)) ? std::max(1.0, width(pair) / radius) : 1.0;
  return 1e3 * wide * (hertz + bonded) / std::pow(radius, 2 - pair.body->form().dimensions);
}

}  // namespace viscoroll::detail
