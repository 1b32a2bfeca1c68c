/// @file
/// @brief Products with the influence of free sides, which depends on where across the tread loads and displacements
/// are.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "influence/fft.hpp"
#include "influence/side_sum.hpp"
#include "influence/spectral_product.hpp"
#include "influence/tread_shares.hpp"

namespace viscoroll::detail {

/// @brief Forces on patches are gathered on the section's lines of nodes, which are few; there a transform along phi
/// and a matrix for each frequency make displacements of them, which are read where they are asked for.
class SideProduct {
 public:
  /// @param[in] shape window
  /// @param[in] columns of it, the same way as theta
  /// @param[in] difference of the section
  /// @param[in] factors at offsets across the window
  /// @param[in] average whether means over patches are read, as where work is meant, or values at nodes
  SideProduct(WindowShape shape, const TreadColumns& columns, const SampledDifference& difference,
              const SideFactors& factors, bool average);

  /// @param[in] loads a column for each of (r, phi, theta), or of r alone, and a row for each node
  /// @return the same of what they cause
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads) const;

  /// @return floating-point operations of it, roughly
  [[nodiscard]] double operations() const;

 private:
  /// One of the two parts about the middle of the tread.
  struct Part {
    std::vector<Eigen::MatrixXd> gathered;   // [component] shares of lines in the forces on columns, [line, column]
    std::vector<Eigen::MatrixXd> read;       // [component] shares of lines in what columns show
    std::vector<Eigen::MatrixXcd> spectrum;  // [frequency] of amplitudes component * lines + line
  };

  WindowShape shape_;
  Eigen::Index components_;
  Eigen::Index lines_;
  int period_;  // along phi, so long that images do not meet
  RealFft fft_;
  std::array<Part, 2> parts_;
};

}  // namespace viscoroll::detail
