/// @file
/// @brief Linear equations of frictionless contact, without their matrix.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "contact/contact_problem.hpp"
#include "influence/node_rows.hpp"
#include "influence/table_product.hpp"

namespace viscoroll::detail {

/// @brief Approximate inverse of the compliance for normal forces: T. F. Chan's optimal circulant.
[[nodiscard]] InverseConvolution normal_inverse(const SurfaceOperator& surface);

/// @brief Rows of nodes at which a law relates force and gap, at every node of the window:
/// displacement * stiffness * (upward displacement - penetration) + force * pressing = right.
/// A node in contact has the factors 1 and 0, and minus the stiffness times the initial gap on the right side.
struct LawRows {
  Eigen::ArrayXd displacement;  ///< factor of the displacement [-]
  Eigen::ArrayXd force;         ///< factor of the force [-]
  Eigen::ArrayXd right;         ///< right side [N]
};

/// @brief Equations of frictionless contact. Forces come first, then the penetration times a stiffness. The last
/// equation is the condition on the load or on the penetration.
///
/// If the contact is mirror-symmetric, one node represents itself and its image, and its unknown is the force times
/// sqrt(2). Sums of squares are then those of all nodes, and so is every step of a Krylov method.
///
/// The preconditioner satisfies the last equation, and so does every step from a guess that satisfies it. At a given
/// load the forces of a step sum to zero: a Krylov method meets the compliance restricted to such forces, which is
/// symmetric if the coating is lossless. At a given penetration the last unknown does not change, and the equation
/// drops out. The preconditioner inverts rows with a factor of the force as if they contained the force alone.
class FlatEquations {
 public:
  /// @param[in] problem contact problem; must outlive this object
  /// @param[in] inverse approximate inverse of its compliance; must outlive this object
  /// @param[in] nodes nodes whose forces are unknown, ascending
  /// @param[in] mirrored whether the contact is mirror-symmetric
  /// @param[in] stiffness stiffness that converts displacements to forces [N/m]
  /// @param[in] uniform forces that displace all nodes of a similar contact equally, at every node of the window; null
  /// to compute those of this contact
  /// @param[in] law rows of nodes that are not in contact; null if there are none
  FlatEquations(const ContactProblem& problem, const InverseConvolution& inverse,
                const std::vector<Eigen::Index>& nodes, bool mirrored, double stiffness,
                const Eigen::ArrayXd* uniform = nullptr, const LawRows* law = nullptr);

  [[nodiscard]] Eigen::VectorXd right_side() const;

  [[nodiscard]] Eigen::VectorXd unknowns(const Eigen::ArrayXd& pressing, double penetration) const;

  /// @return the unknowns, corrected so that they satisfy the last equation
  [[nodiscard]] Eigen::VectorXd corrected(Eigen::VectorXd unknowns) const;

  /// @return right side minus left side of the equations of nodes in contact, from the gap of every node
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& unknowns, const Eigen::ArrayXd& gap) const;

  /// @return forces of all nodes of the window, corrected so that the last equation holds to the last digit [N]
  [[nodiscard]] Eigen::ArrayXd pressing(const Eigen::VectorXd& unknowns) const;
  [[nodiscard]] double penetration(const Eigen::VectorXd& unknowns) const;

  /// @return forces that displace all nodes in contact equally, approximately, at every node of the window [N]
  [[nodiscard]] Eigen::ArrayXd uniform() const { return on_window(uniform_); }

  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& unknowns) const;

  /// @return solution of the same equations with the inverse symbol instead of the inverse of C
  [[nodiscard]] Eigen::VectorXd precondition(const Eigen::VectorXd& right) const;

 private:
  template <class Function>
  void for_nodes(const Function& function) const {
    for (int row = 0; row < rows_.rows(); ++row) rows_.for_row(row, function);
  }

  /// Sum of the forces of all nodes.
  [[nodiscard]] double sum(const Eigen::VectorXd& unknowns) const { return roots_.dot(unknowns.head(count_)); }

  /// Left side of the last equation.
  [[nodiscard]] double conditioned(const Eigen::VectorXd& unknowns) const {
    return condition_.per_force * sum(unknowns) + condition_.per_penetration * unknowns[count_];
  }

  /// Change of this side if all nodes in contact are lowered by the same amount.
  [[nodiscard]] double response() const { return condition_.per_force * sum(uniform_) + condition_.per_penetration; }

  /// Convert forces on the window to unknowns, and unknowns to forces.
  [[nodiscard]] Eigen::VectorXd unknown_forces(const Eigen::ArrayXd& forces) const;
  [[nodiscard]] Eigen::ArrayXd on_window(const Eigen::VectorXd& unknowns) const;

  [[nodiscard]] Eigen::VectorXd precondition_forces(const Eigen::Ref<const Eigen::VectorXd>& right) const;

  /// Factors of the displacement and of the force in every row, empty if all rows are those of nodes in contact.
  struct RowFactors {
    Eigen::VectorXd displacement;
    Eigen::VectorXd force;
  };

  const ContactProblem& problem_;
  const InverseConvolution& inverse_;
  NodeRows rows_;
  Eigen::Index count_;
  Eigen::VectorXd roots_;  // square root of the number of nodes that an unknown represents
  double stiffness_;
  NormalCondition condition_;
  double balance_;
  const LawRows* law_;
  std::optional<RowFactors> factors_;
  Eigen::VectorXd uniform_;         // forces that displace all nodes in contact equally, or nearly so
  mutable Eigen::VectorXd scaled_;  // operand of the products; freeing and allocating its memory costs more than them
};

}  // namespace viscoroll::detail
