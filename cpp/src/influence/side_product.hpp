/// @file
/// @brief Product with the influence of free faces, which depends on the positions of load and displacement across the
/// tread, and interpolation between the lines of nodes of a section and the columns of nodes of a mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "influence/fft.hpp"
#include "influence/side_sum.hpp"
#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief Positions of columns across the tread.
struct TreadColumns {
  int first;       ///< number of the first column; column 0 is in the middle of the tread
  double spacing;  ///< distance between columns, and width of their patches [m]
};

/// @brief Weights with which the values on the lines enter the mean of a field over the patch of each column. The patch
/// is cut off at the faces of the tread.
/// @param[in] lines distances of the lines from the middle of the tread [m], ascending; the last line is at the face.
/// The first is in the middle, or where the effect of the faces begins; positions nearer to the middle have zero
/// weights.
/// @param[in] columns positions of the columns
/// @param[in] count number of columns
/// @param[in] odd whether the field changes sign across the middle
/// @return [line, column]
[[nodiscard]] Eigen::MatrixXd patch_mean_weights(const Eigen::ArrayXd& lines, const TreadColumns& columns,
                                                 Eigen::Index count, bool odd);

/// @return weights with which the values on the lines enter the value in the middle of each column, [line, column];
/// parameters same as in `patch_mean_weights`
[[nodiscard]] Eigen::MatrixXd node_weights(const Eigen::ArrayXd& lines, const TreadColumns& columns, Eigen::Index count,
                                           bool odd);

/// @brief Product that gathers forces on patches on the few lines of nodes of the section, transforms them along phi,
/// multiplies by one matrix per frequency, and reads the displacements at the columns.
class SideProduct {
 public:
  /// @param[in] shape window
  /// @param[in] columns columns of the window, in the direction of theta
  /// @param[in] difference difference between the sections with and without faces
  /// @param[in] factors factors at offsets across the window
  /// @param[in] average whether the result is a mean over patches (for work) or the value at nodes
  SideProduct(WindowShape shape, const TreadColumns& columns, const SampledDifference& difference,
              const SideFactors& factors, bool average);

  /// @param[in] loads one column per component (r, phi, theta), or r alone, and one row per node
  /// @return displacements in the same layout
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads) const;

  /// @return approximate number of floating-point operations of a product
  [[nodiscard]] double operations() const;

 private:
  /// The even or the odd part about the middle of the tread.
  struct Part {
    std::vector<Eigen::MatrixXd> gathered;   // [component], weights of lines in the forces on columns, [line, column]
    std::vector<Eigen::MatrixXd> read;       // [component], weights of lines in the result at columns
    std::vector<Eigen::MatrixXcd> spectrum;  // [frequency], for amplitudes component * lines + line
  };

  WindowShape shape_;
  Eigen::Index components_;
  Eigen::Index lines_;
  int period_;  // along phi, long enough to keep images apart
  RealFft fft_;
  std::array<Part, 2> parts_;
};

}  // namespace viscoroll::detail
