/// @file
/// @brief Influence tables applied on a window of surface nodes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "influence/fft.hpp"
#include "influence/synthesis.hpp"

namespace viscoroll::detail {

/// @brief Rectangular window of nodes, numbered row by row: node (i, k) is i * theta_nodes + k.
struct WindowShape {
  int phi_nodes;
  int theta_nodes;

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(phi_nodes) * theta_nodes; }
};

/// @brief A field to another one through a table: what a `Convolution` is the sum of.
struct ConvolutionTerm {
  std::size_t result;   ///< which field it adds to
  std::size_t table;    ///< which table
  std::size_t operand;  ///< which field it is fed with
  double sign;
};

/// @brief Several fields over a window to several others by translation-invariant tables, with FFTs on the window
/// doubled in both directions: one transform for each field rather than for each table.
class Convolution {
 public:
  /// @param[in] shape window; the tables reach across it
  /// @param[in] tables of which those that occur in terms are used
  /// @param[in] terms summands
  Convolution(WindowShape shape, const std::vector<Table>& tables, std::vector<ConvolutionTerm> terms);

  /// @param[in] operands one column for each field, rows being nodes
  /// @return one column for each field
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& operands) const;

 private:
  void load(const Eigen::ArrayXXd& operands, Eigen::Index field, RealBuffer& padded) const;

  WindowShape shape_;
  std::vector<ConvolutionTerm> terms_;
  std::size_t results_;
  int padded_phi_;
  int padded_theta_;
  RealFft fft_;
  std::vector<ComplexBuffer> table_spectra_;  // of the tables that occur in terms; others stay empty
};

}  // namespace viscoroll::detail
