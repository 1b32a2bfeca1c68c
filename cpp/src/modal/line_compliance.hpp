/// @file
/// @brief What a surface answers to tractions that do not vary sideways: plane strain, and shear along the line.
#pragma once

#include <complex>
#include <vector>

namespace viscoroll::detail {

/// @brief Compliance of one order, displacement per stress [m/Pa], in the real form of `layer_system.hpp`: along the
/// way of the material displacements are i v, and tractions i tau.
template <class Scalar>
struct LineCompliance {
  Scalar normal;  ///< outward displacement by normal stress
  Scalar mixed;   ///< outward displacement by tau, and v by normal stress
  Scalar along;   ///< v by tau
  Scalar axial;   ///< displacement along the line by traction along it
};

/// @brief The compliance of several orders.
using LineSpectrum = std::vector<LineCompliance<std::complex<double>>>;

}  // namespace viscoroll::detail
