/// @file
/// @brief Tests of a solid over long times: compression set and creep.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace viscoroll::detail {

/// Relaxation function: relaxed modulus and terms, in any units of stress and time.
struct RelaxingTerms {
  std::vector<double> moduli;
  std::vector<double> times;
  double relaxed = 0.0;
};

/// Strain of a solid without stress or under constant stress, from the strains of its dashpots.
///
/// A term with the spring M_k and the dashpot strain e_k has the stress M_k (e - e_k), where tau_k de_k/dt = e - e_k.
/// With the stress s, e = (s + sum_k M_k e_k) / M, where M = relaxed + sum_k M_k. The equations for
/// y_k = sqrt(M_k tau_k) e_k are symmetric:
///
///     dy/dt = -A y + v s / M,   A = diag(1 / tau_k) - v v^T / M,   v_k = sqrt(M_k / tau_k),   e = (s + v^T y) / M
///
/// Terms with times below 1e-6 of the `shortest` time of the test are in equilibrium, without stress: they are left
/// out.
class LongTest {
 public:
  LongTest(const RelaxingTerms& terms, double shortest);

  /// @return strain at `recovery` after a strain of 1, held over `duration`, was released
  [[nodiscard]] double compression_set(double duration, double recovery) const;

  /// @return strain at a time under a constant stress of 1
  [[nodiscard]] double creep(double time) const;

 private:
  Eigen::ArrayXd moduli_;
  Eigen::ArrayXd times_;
  double total_;
  Eigen::VectorXd coupling_;  ///< v
  Eigen::ArrayXd rates_;      ///< eigenvalues of A
  Eigen::MatrixXd modes_;     ///< its eigenvectors
};

}  // namespace viscoroll::detail
