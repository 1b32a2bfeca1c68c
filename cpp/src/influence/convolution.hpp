/// @file
/// @brief Influence tables applied on a window of surface nodes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "influence/fft.hpp"
#include "influence/synthesis.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Rectangular window of nodes, numbered row by row: node (i, k) is i * theta_nodes + k.
struct WindowShape {
  int phi_nodes;
  int theta_nodes;

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(phi_nodes) * theta_nodes; }
};

/// @brief Matrix over the nodes of a window that is a sum of tables between diagonal scalings:
/// sum_t sign_t diag(left_t) C_t diag(right_t). Whatever couples the nodes of this model has this form, since
/// C_r = Q^T C_s Q and C_s is translation invariant.
class ScaledConvolution {
 public:
  /// @brief One summand.
  struct Term {
    std::size_t left;   ///< which scaling of the result
    std::size_t table;  ///< which table
    std::size_t right;  ///< which scaling of the operand
    double sign;
  };

  /// @param[in] shape window; the tables reach across it
  /// @param[in] tables shared, not copied
  /// @param[in] scalings of nodes, used on either side
  /// @param[in] terms summands
  ScaledConvolution(WindowShape shape, std::shared_ptr<const std::vector<Table>> tables,
                    std::vector<Eigen::ArrayXd> scalings, std::vector<Term> terms);

  [[nodiscard]] WindowShape shape() const { return shape_; }

  /// @brief Product with a vector over the window, by FFT on the window doubled in both directions.
  [[nodiscard]] Eigen::ArrayXd apply(const Eigen::ArrayXd& operand) const;

  /// @brief Square block of the matrix.
  /// @param[in] nodes its rows and columns
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  [[nodiscard]] Eigen::MatrixXd block(std::span<const Eigen::Index> nodes, int threads, Watch& watch) const;

 private:
  WindowShape shape_;
  std::shared_ptr<const std::vector<Table>> tables_;
  std::vector<Eigen::ArrayXd> scalings_;
  std::vector<Term> terms_;
  int padded_phi_;
  int padded_theta_;
  RealFft fft_;
  std::vector<ComplexBuffer> table_spectra_;  // of the tables that occur in terms; others stay empty
};

}  // namespace viscoroll::detail
