/// @file
/// @brief Shear moduli of linear viscoelastic materials as functions of angular frequency.
///
/// With the time factor exp(+i w t), the storage modulus is the real part and the loss modulus the imaginary part. The
/// loss modulus of a passive material is >= 0 at w >= 0. All moduli are shear moduli.
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "viscoroll/fields.hpp"

namespace viscoroll {

/// @brief Elastic material without loss, mu* = modulus.
struct Elastic {
  double modulus = 0.0;  ///< shear modulus [Pa], > 0

  static constexpr const char* type = "elastic";
  static constexpr auto fields() { return std::tuple{Field{"modulus", &Elastic::modulus}}; }
};

/// @brief Prony series, equation (65) of the paper.
///
///     mu* = G0 (g_inf + sum_k g_k i w tau_k / (1 + i w tau_k)),   g_inf = 1 - sum_k g_k >= 0
///
/// A body at rest requires g_inf > 0.
struct Prony {
  double instantaneous_modulus = 0.0;    ///< G0, shear modulus at infinite frequency [Pa], > 0
  std::vector<double> weights;           ///< g_k [-], >= 0; their sum is <= 1
  std::vector<double> relaxation_times;  ///< tau_k [s], > 0, one for each weight

  static constexpr const char* type = "prony";
  static constexpr auto fields() {
    return std::tuple{Field{"instantaneous_modulus", &Prony::instantaneous_modulus}, Field{"weights", &Prony::weights},
                      Field{"relaxation_times", &Prony::relaxation_times}};
  }
};

/// @brief Kelvin-Voigt solid, mu* = modulus + i w viscosity.
struct KelvinVoigt {
  double modulus = 0.0;    ///< shear modulus at rest [Pa], > 0
  double viscosity = 0.0;  ///< shear viscosity [Pa s], >= 0

  static constexpr const char* type = "kelvin_voigt";
  static constexpr auto fields() {
    return std::tuple{Field{"modulus", &KelvinVoigt::modulus}, Field{"viscosity", &KelvinVoigt::viscosity}};
  }
};

/// @brief Fractional Zener solid: a spring in parallel with a series of a spring and a springpot.
///
///     mu* = (G_inf + G0 (i w tau)^alpha) / (1 + (i w tau)^alpha)
///
/// R. L. Bagley and P. J. Torvik, AIAA Journal 21 (1983) 741-748, equation (12) with equal orders.
struct FractionalZener {
  double instantaneous_modulus = 0.0;  ///< G0, shear modulus at infinite frequency [Pa], >= relaxed_modulus
  double relaxed_modulus = 0.0;        ///< G_inf, shear modulus at zero frequency [Pa], > 0
  double relaxation_time = 0.0;        ///< tau [s], > 0
  double order = 1.0;                  ///< alpha [-], in (0, 1]; 1 is the standard linear solid

  static constexpr const char* type = "fractional_zener";
  static constexpr auto fields() {
    return std::tuple{Field{"instantaneous_modulus", &FractionalZener::instantaneous_modulus},
                      Field{"relaxed_modulus", &FractionalZener::relaxed_modulus},
                      Field{"relaxation_time", &FractionalZener::relaxation_time},
                      Field{"order", &FractionalZener::order}};
  }
};

/// @brief Havriliak-Negami solid: a fractional Zener solid whose dispersion has unequal slopes below and above its
/// center.
///
///     mu* = G0 - (G0 - G_inf) / (1 + (i w tau)^alpha)^beta
///
/// S. Havriliak and S. Negami, Polymer 8 (1967) 161-210, for the modulus in place of the permittivity.
struct HavriliakNegami {
  double instantaneous_modulus = 0.0;  ///< G0, shear modulus at infinite frequency [Pa], >= relaxed_modulus
  double relaxed_modulus = 0.0;        ///< G_inf, shear modulus at zero frequency [Pa], > 0
  double relaxation_time = 0.0;        ///< tau [s], > 0
  double order = 1.0;                  ///< alpha [-], in (0, 1]: slope of the loss modulus below its peak
  double asymmetry = 1.0;  ///< beta [-], in (0, 1]: slope above the peak / alpha; 1 is the fractional Zener solid

  static constexpr const char* type = "havriliak_negami";
  static constexpr auto fields() {
    return std::tuple{Field{"instantaneous_modulus", &HavriliakNegami::instantaneous_modulus},
                      Field{"relaxed_modulus", &HavriliakNegami::relaxed_modulus},
                      Field{"relaxation_time", &HavriliakNegami::relaxation_time},
                      Field{"order", &HavriliakNegami::order}, Field{"asymmetry", &HavriliakNegami::asymmetry}};
  }
};

/// @brief Treatment of values outside a tabulated or fitted range.
enum class Extrapolation {
  error,  ///< throw an error that names the value and the range
  hold,   ///< use the value at the nearer end of the range
};

/// @brief Tabulated modulus. Storage and loss modulus are interpolated linearly over the logarithm of the frequency. If
/// the first entry has frequency 0, it is the static modulus and is used at zero frequency only.
struct MasterCurve {
  std::vector<double> frequency;  ///< angular frequency [rad/s], strictly increasing, >= 0, at least two above 0
  std::vector<double> storage;    ///< storage modulus [Pa], > 0
  std::vector<double> loss;       ///< loss modulus [Pa], >= 0
  Extrapolation extrapolation = Extrapolation::error;  ///< treatment of frequencies outside the table

  static constexpr const char* type = "master_curve";
  static constexpr auto fields() {
    return std::tuple{Field{"frequency", &MasterCurve::frequency}, Field{"storage", &MasterCurve::storage},
                      Field{"loss", &MasterCurve::loss}, Field{"extrapolation", &MasterCurve::extrapolation, true}};
  }
};

/// @brief A modulus given by a function.
struct CustomModulus {
  /// Function that fills `modulus` [Pa] for every `omega` [rad/s], >= 0, including 0. It is called on the thread that
  /// called the library.
  std::function<void(std::span<const double> omega, std::span<std::complex<double>> modulus)> evaluate;
};

/// @brief Shear modulus of a layer.
using ShearModulus =
    std::variant<Elastic, Prony, KelvinVoigt, FractionalZener, HavriliakNegami, MasterCurve, CustomModulus>;

/// @brief Check the parameters of a modulus.
/// @param[in] modulus any shear modulus
/// @param[in] prefix text before the parameter's name in messages
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const ShearModulus& modulus, std::string_view prefix = "shear_modulus.");

/// @brief Complex shear modulus mu*(w) [Pa].
/// @param[in] modulus any shear modulus
/// @param[in] omega angular frequencies [rad/s], >= 0
/// @return one value for each frequency, real at frequency 0
/// @throws InvalidInput for a parameter out of range, a frequency outside a master curve, a value that is not
/// finite, a storage modulus <= 0, or a loss modulus < 0 (not passive)
[[nodiscard]] std::vector<std::complex<double>> complex_modulus(const ShearModulus& modulus,
                                                                std::span<const double> omega);

/// @brief Short-time limit of the storage modulus.
/// @param[in] modulus any shear modulus
/// @param[in] highest_frequency frequency at which a `CustomModulus` is evaluated in place of the limit [rad/s], > 0
/// @return modulus [Pa]; infinite for a Kelvin-Voigt solid with viscosity
[[nodiscard]] double short_time_modulus(const ShearModulus& modulus, double highest_frequency);

}  // namespace viscoroll
