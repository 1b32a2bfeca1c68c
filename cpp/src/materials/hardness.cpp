#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll {
namespace {

/// Smallest difference between instruments and between laboratories [Shore].
constexpr double kReproducibility = 2.0;

/// Rounding of the rebound in data sheets, which give it in whole percent.
constexpr double kRounding = 0.005;

/// Offset of Qi's scale, on which Shore A and D coincide: S = S_A = S_D + 50.
constexpr double kShoreAOfD = 50.0;

/// Young's modulus / shear modulus of an incompressible material.
constexpr double kIncompressible = 3.0;

/// Shear modulus [Pa] from the spring force of a durometer on a flat punch.
double gent(double shore_a) {
  return 0.0981e6 * (56.0 + 7.62336 * shore_a) / (0.137505 * (254.0 - 2.54 * shore_a)) / kIncompressible;
}

/// Shear modulus [Pa] from log10(E / MPa) = 0.0235 S - 0.6403.
double qi(double shore) { return std::pow(10.0, 0.0235 * shore - 0.6403) * 1e6 / kIncompressible; }

/// Loss factor of an oscillator that retains a fraction of its energy over half a cycle.
double half_cycle(double fraction) { return -std::log(fraction) / std::numbers::pi; }

/// Loss factor of a Kelvin-Voigt solid that retains a fraction of the energy until its force vanishes. With the damping
/// ratio zeta = loss factor / 2, the fraction is exp(-2 zeta (pi - 2 asin(zeta)) / sqrt(1 - zeta^2)).
double until_force_vanishes(double fraction) {
  double low = 0.0;
  double high = 1.0 - 1e-9;
  for (int bisection = 0; bisection < 60; ++bisection) {  // to double precision
    const double ratio = 0.5 * (low + high);
    const double retained =
        std::exp(-2.0 * ratio * (std::numbers::pi - 2.0 * std::asin(ratio)) / std::sqrt(1.0 - ratio * ratio));
    (retained > fraction ? low : high) = ratio;
  }
  return 2.0 * low;
}

}  // namespace

Estimate hardness_to_modulus(double hardness, ShoreScale scale) {
  const bool is_a = scale == ShoreScale::a;
  const Range range = is_a ? Range{.unit = "Shore A", .minimum = 20.0, .maximum = 90.0}
                           : Range{.unit = "Shore D", .minimum = 30.0, .maximum = 85.0};
  if (!range.contains(hardness)) {
    std::string given = detail::text(hardness);
    if (is_a && hardness > range.maximum && hardness <= 100.0) {
      given += "; use scale='D' for harder materials: " + given + " Shore A is about " +
               detail::text(hardness - kShoreAOfD) + " Shore D";
    }
    detail::reject("hardness", range, given);
  }
  if (!is_a) {
    const double value = qi(hardness + kShoreAOfD);
    return {.value = value, .lower = 0.5 * value, .upper = 2.0 * value};
  }
  const auto [lower, upper] =
      std::ranges::minmax(std::array{gent(hardness - kReproducibility), gent(hardness + kReproducibility),
                                     qi(hardness - kReproducibility), qi(hardness + kReproducibility)});
  return {.value = std::sqrt(gent(hardness) * qi(hardness)), .lower = lower, .upper = upper};
}

Estimate rebound_to_loss_factor(double rebound) {
  const Range range{.minimum = 0.02, .maximum = 1.0, .excludes_maximum = true};
  if (!range.contains(rebound)) {
    std::string given = detail::text(rebound);
    if (rebound > 1.0 && rebound <= 100.0) given += "; " + given + " % is " + detail::text(rebound / 100.0);
    detail::reject("rebound", range, given, ", as a fraction of the energy");
  }
  return {.value = half_cycle(rebound),
          .lower = half_cycle(std::min(rebound + kRounding, 1.0)),
          .upper = until_force_vanishes(std::max(rebound - kRounding, 0.0))};
}

ShearModulus hardness(const Hardness& sheet) {
  const double modulus = hardness_to_modulus(sheet.hardness, sheet.scale).value;
  if (!sheet.rebound) {
    for (const auto& [name, value] :
         {std::pair{"reference_frequency", sheet.reference_frequency}, std::pair{"decades", sheet.decades}}) {
      if (value) throw InvalidInput(name, "must be left out without a rebound", "");
    }
    return Elastic{.modulus = modulus};
  }
  const double loss = rebound_to_loss_factor(*sheet.rebound).value;
  if (!sheet.reference_frequency) {
    throw InvalidInput("reference_frequency",
                       "must be given with a rebound: the frequency of modulus and loss factor, such as 1 rad/s for a "
                       "durometer that is read after one second",
                       "");
  }
  LossFactor law{.modulus = modulus, .loss_factor = loss, .reference_frequency = *sheet.reference_frequency};
  law.decades = sheet.decades.value_or(law.decades);
  return loss_factor(law);
}

}  // namespace viscoroll
