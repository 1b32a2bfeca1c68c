/// @file
/// @brief Shear moduli of linear viscoelastic materials as functions of angular frequency.
///
/// Time factor exp(+i w t): the storage modulus is the real part and the loss modulus the imaginary part,
/// which is >= 0 at w >= 0 for a passive material. All moduli are shear moduli.
#pragma once

#include <complex>
#include <functional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace viscoroll {

/// @brief mu* = modulus, without loss.
struct Elastic {
  double modulus = 0.0;  ///< shear modulus [Pa], > 0
};

/// @brief Prony series, paper equation (65):
/// mu* = G0 (g_inf + sum_k g_k i w tau_k / (1 + i w tau_k)), g_inf = 1 - sum_k g_k >= 0: a body at rest needs one > 0.
struct Prony {
  double instantaneous_modulus = 0.0;    ///< G0, shear modulus at infinite frequency [Pa], > 0
  std::vector<double> weights;           ///< g_k [-], >= 0, with a sum <= 1
  std::vector<double> relaxation_times;  ///< tau_k [s], > 0, one for each weight
};

/// @brief Standard linear solid: the Prony series with one term, given by its two limits.
/// @param[in] instantaneous_modulus shear modulus at infinite frequency [Pa], > 0
/// @param[in] relaxed_modulus shear modulus at zero frequency [Pa], > 0 and <= instantaneous_modulus
/// @param[in] relaxation_time [s], > 0
/// @throws std::invalid_argument where a value is out of range
[[nodiscard]] Prony standard_linear_solid(double instantaneous_modulus, double relaxed_modulus, double relaxation_time);

/// @brief mu* = modulus + i w viscosity.
struct KelvinVoigt {
  double modulus = 0.0;    ///< shear modulus at rest [Pa], > 0
  double viscosity = 0.0;  ///< shear viscosity [Pa s], >= 0
};

/// @brief Fractional Zener solid (a spring beside a spring in series with a springpot):
/// mu* = (G_inf + G0 (i w tau)^alpha) / (1 + (i w tau)^alpha).
/// R. L. Bagley and P. J. Torvik, AIAA Journal 21 (1983) 741-748, equation (12) with equal orders.
struct FractionalZener {
  double instantaneous_modulus = 0.0;  ///< G0, shear modulus at infinite frequency [Pa], >= relaxed_modulus
  double relaxed_modulus = 0.0;        ///< G_inf, shear modulus at zero frequency [Pa], > 0
  double relaxation_time = 0.0;        ///< tau [s], > 0
  double order = 1.0;                  ///< alpha [-], in (0, 1]; 1 is the standard linear solid
};

/// @brief What a master curve does outside its table.
enum class Extrapolation {
  error,  ///< refuse, naming the frequency and the table's range
  hold,   ///< keep the value at the nearer end
};

/// @brief Tabulated modulus, linear in the logarithm of frequency between the entries.
/// A first frequency of 0 is the static modulus: it serves zero frequency alone.
struct MasterCurve {
  std::vector<double> frequency;  ///< angular frequency [rad/s], strictly increasing, >= 0, at least two above 0
  std::vector<double> storage;    ///< storage modulus [Pa], > 0
  std::vector<double> loss;       ///< loss modulus [Pa], >= 0
  Extrapolation extrapolation = Extrapolation::error;  ///< what to do outside the table
};

/// @brief Any other modulus, as a function.
struct CustomModulus {
  /// Fills `modulus` [Pa] at every `omega` [rad/s], which is >= 0 and includes 0. Called on the thread that called
  /// the library.
  std::function<void(std::span<const double> omega, std::span<std::complex<double>> modulus)> evaluate;
};

/// @brief The shear modulus of a layer.
using ShearModulus = std::variant<Elastic, Prony, KelvinVoigt, FractionalZener, MasterCurve, CustomModulus>;

/// @brief Check the parameters of a modulus.
/// @param[in] modulus any shear modulus
/// @param[in] prefix what stands before the parameter's name in messages
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const ShearModulus& modulus, std::string_view prefix = "shear_modulus.");

/// @brief Complex shear modulus mu*(w) [Pa].
/// @param[in] modulus any shear modulus
/// @param[in] omega angular frequencies [rad/s], >= 0
/// @return one value for each frequency, real at frequency 0
/// @throws std::invalid_argument for parameters out of range, a frequency outside a master curve, a value that is
/// not finite, a storage modulus <= 0, or a loss modulus < 0 (not passive)
[[nodiscard]] std::vector<std::complex<double>> complex_modulus(const ShearModulus& modulus,
                                                                std::span<const double> omega);

/// @brief Limit of the storage modulus at high frequency [Pa]; infinite for a Kelvin-Voigt solid with viscosity.
/// @param[in] modulus any shear modulus
/// @param[in] highest_frequency where a `CustomModulus` is evaluated in place of the limit [rad/s], > 0
[[nodiscard]] double short_time_modulus(const ShearModulus& modulus, double highest_frequency);

}  // namespace viscoroll
