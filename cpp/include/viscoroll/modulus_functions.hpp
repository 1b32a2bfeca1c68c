/// @file
/// @brief Moduli that equal a modulus of materials.hpp, made from other parameters: limits, creep tests, data sheets.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>

#include "viscoroll/fields.hpp"
#include "viscoroll/materials.hpp"

namespace viscoroll {

/// @brief Standard linear solid: the Prony series with one term, given by its two limits.
/// @param[in] instantaneous_modulus shear modulus at infinite frequency [Pa], > 0
/// @param[in] relaxed_modulus shear modulus at zero frequency [Pa], in [1e-12, 1] times instantaneous_modulus
/// @param[in] relaxation_time relaxation time [s], > 0
/// @return the series
/// @throws InvalidInput if a value is out of range
[[nodiscard]] Prony standard_linear_solid(double instantaneous_modulus, double relaxed_modulus, double relaxation_time);

/// @brief Prony series of the modulus that belongs to the creep compliance
///
///     J(t) = J_0 + sum_k J_k (1 - exp(-t / tau_k))
///
/// The conversion is exact. The relaxation times are -1/s at the zeros s of the compliance J_0 + sum_k J_k / (1 + s
/// tau_k).
/// @param[in] instantaneous_compliance J_0, shear compliance at infinite frequency [1/Pa], > 0
/// @param[in] compliances J_k [1/Pa], >= 0
/// @param[in] retardation_times tau_k [s], > 0, one for each compliance
/// @return the series
/// @throws InvalidInput if a value is out of range
[[nodiscard]] Prony creep_compliance(double instantaneous_compliance, std::span<const double> compliances,
                                     std::span<const double> retardation_times);

/// @brief Causal modulus whose loss factor is nearly independent of frequency.
///
/// E. Kjartansson, J. Geophys. Res. 84 (1979) 4737-4748:
///
///     mu* = modulus sqrt(1 + loss_factor^2) (i w / reference_frequency)^alpha,   alpha = (2 / pi) atan(loss_factor)
///
/// The law holds over `decades` above and below the reference frequency; beyond that range the material is elastic.
///
/// With a compression set or a creep test, the relaxation continues one decade beyond that range, where the law ends,
/// to the end of the test:
///
///     G(t) = G_1 (t / t_1)^-beta,   t_1 = 10^(decades + 1) / reference_frequency
///
/// The exponent beta is the one for which the material has the measured set or the measured creep.
struct LossFactor {
  double modulus = 0.0;                    ///< storage modulus at the reference frequency [Pa], > 0
  double loss_factor = 0.0;                ///< tan delta [-], in [1e-6, 2]
  double reference_frequency = 0.0;        ///< angular frequency [rad/s], > 0
  double decades = 3.0;                    ///< decades on each side over which the law holds [-], in [0.5, 8]
  std::optional<double> compression_set;   ///< strain that remains after a compression, relative to it [-], in (0, 1)
  std::optional<double> compression_time;  ///< duration of the compression [s], > 0; only with a compression set
  std::optional<double> recovery_time;     ///< time from its release to the measurement [s], > 0; 1800 by default
  std::optional<double> creep_ratio;       ///< strain at `creep_time` / strain at `creep_start` [-], > 1
  std::optional<double> creep_time;        ///< time under constant stress [s], > creep_start; only with a creep ratio
  std::optional<double> creep_start;       ///< time of the first strain [s], > 0; only with a creep ratio

  static constexpr auto fields() {
    return std::tuple{Field{"modulus", &LossFactor::modulus},
                      Field{"loss_factor", &LossFactor::loss_factor},
                      Field{"reference_frequency", &LossFactor::reference_frequency},
                      Field{"decades", &LossFactor::decades, true},
                      Field{"compression_set", &LossFactor::compression_set, true},
                      Field{"compression_time", &LossFactor::compression_time, true},
                      Field{"recovery_time", &LossFactor::recovery_time, true},
                      Field{"creep_ratio", &LossFactor::creep_ratio, true},
                      Field{"creep_time", &LossFactor::creep_time, true},
                      Field{"creep_start", &LossFactor::creep_start, true}};
  }
};

/// @brief Prony series of a nearly constant loss factor. The relative error of the loss factor is at most 0.5 % for
/// loss factors up to 1, and 3 % up to 2; in the lowest decade of its range it is larger with a compression set or a
/// creep test.
/// @param[in] law parameters
/// @return the series
/// @throws InvalidInput if a value is out of range
[[nodiscard]] Prony loss_factor(const LossFactor& law);

/// @brief Scale of a Shore durometer.
enum class ShoreScale {
  a,  ///< Shore A, for soft rubbers
  d,  ///< Shore D, for hard rubbers and plastics
};

/// @brief Value of a material property estimated from a data sheet.
struct Estimate {
  double value = 0.0;  ///< best estimate
  double lower = 0.0;  ///< lower bound
  double upper = 0.0;  ///< upper bound
};

/// @brief Estimate the static shear modulus of a rubber from its Shore hardness.
///
/// Shore A: geometric mean of the relations of A. N. Gent, Rubber Chem. Technol. 31 (1958) 896, and of H. J. Qi,
/// K. Joyce and M. C. Boyce, Rubber Chem. Technol. 76 (2003) 419; the bounds contain both at +-2 Shore. Shore D: the
/// relation of Qi; the bounds are half and twice its value.
/// @param[in] hardness Shore A in [20, 90], or Shore D in [30, 85]
/// @param[in] scale scale of the hardness
/// @return shear modulus [Pa]
/// @throws InvalidInput if the hardness is out of range
[[nodiscard]] Estimate hardness_to_modulus(double hardness, ShoreScale scale);

/// @brief Estimate the loss factor from the rebound resilience.
///
/// An impact is half a cycle of an oscillator, which retains the fraction exp(-pi loss_factor) of its energy. The upper
/// bound is that of an impact that ends when the force of a Kelvin-Voigt solid vanishes.
/// @param[in] rebound fraction of the energy that is retained [-], in [0.02, 1)
/// @return loss factor [-]
/// @throws InvalidInput if the rebound is out of range
[[nodiscard]] Estimate rebound_to_loss_factor(double rebound);

/// @brief Material of a data sheet, given by hardness and rebound.
struct Hardness {
  double hardness = 0.0;                      ///< number of `scale`
  ShoreScale scale = ShoreScale::a;           ///< scale of the hardness
  std::optional<double> rebound;              ///< fraction of the energy [-]; without it, the material is elastic
  std::optional<double> reference_frequency;  ///< frequency of the modulus [rad/s]; required with a rebound
  std::optional<double> decades;              ///< same as in `LossFactor`, only with a rebound

  static constexpr auto fields() {
    return std::tuple{Field{"hardness", &Hardness::hardness}, Field{"scale", &Hardness::scale, true},
                      Field{"rebound", &Hardness::rebound, true},
                      Field{"reference_frequency", &Hardness::reference_frequency, true},
                      Field{"decades", &Hardness::decades, true}};
  }
};

/// @brief Modulus of a material that is given by hardness and rebound.
/// @param[in] sheet values of the data sheet
/// @return an elastic modulus, or the Prony series of a loss factor
/// @throws InvalidInput if a value is out of range, and for a rebound without a frequency or the reverse
[[nodiscard]] ShearModulus hardness(const Hardness& sheet);

/// @brief Type of modulus that a function makes from parameters, or from a struct that has `fields`.
template <class Function, std::size_t count>
struct ModulusFunction {
  const char* type;                             ///< name of the type in files
  Function* make;                               ///< function that returns the modulus
  std::array<const char*, count> parameters{};  ///< names of its parameters in files; none for a struct
};

template <class Function, std::size_t count>
ModulusFunction(const char*, Function*, std::array<const char*, count>) -> ModulusFunction<Function, count>;
template <class Function>
ModulusFunction(const char*, Function*) -> ModulusFunction<Function, 0>;

/// @brief Types of moduli that functions make. Other types are the structs of `ShearModulus` with `type` and `fields`.
inline constexpr std::tuple kModulusFunctions{
    ModulusFunction{"standard_linear_solid", &standard_linear_solid,
                    std::array{"instantaneous_modulus", "relaxed_modulus", "relaxation_time"}},
    ModulusFunction{"creep_compliance", &creep_compliance,
                    std::array{"instantaneous_compliance", "compliances", "retardation_times"}},
    ModulusFunction{"loss_factor", &loss_factor},
    ModulusFunction{"hardness", &hardness},
};

}  // namespace viscoroll
