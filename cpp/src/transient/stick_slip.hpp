/// @file
/// @brief Stick and slip at an instant of a motion: the problem, its equations with two interchangeable linear solvers,
/// and the search for the state of every node. See docs/theory/transient-friction.md.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "contact/stick_slip_system.hpp"
#include "transient/center_motion.hpp"
#include "transient/contact_inverse.hpp"
#include "transient/step_operator.hpp"

namespace viscoroll::detail {

/// @brief Elastic contact with friction at the end of a time step. A node slips by its displacement relative to the
/// counterbody in this step. Forces are multiplied by the compliance at the end of the step, see
/// docs/theory/transient.md. Arrays contain the nodes row by row.
struct StickSlipProblem {
  const StepOperator& surface;
  Eigen::ArrayXd gap;  ///< without the forces at the end of the step, at a penetration of 0
  /// Slip of the nodes along x and z, without the forces at the end of the step and the displacement of the center.
  Eigen::ArrayX2d known_slip;
  Eigen::ArrayX2d slip_per_center_displacement;  ///< slip due to a unit displacement of the center
  Eigen::ArrayXd weights;                        ///< weights of the nodes, see `half_weights`
  double load;                                   ///< sum of the normal forces, or an estimate if it is a result
  /// Condition for load and penetration. Its `coasted` is 0, because the penetration is measured from there.
  ApproachCondition approach;
  double friction;  ///< coefficient of friction
  /// Condition for the displacement of the center, given the displacements of all parts from `StepOperator::displaced`.
  std::function<CenterRow(const std::vector<HalfField>& displaced)> center_row;
  bool center_row_needs_displacements;  ///< whether the result of `center_row` depends on its argument
};

/// @brief State that solves a problem: forces, nodes in contact, and the displacement of the center.
struct StickSlip {
  VectorField force;  ///< of the plane on the coating, row by row
  double penetration = 0.0;
  double center_displacement = 0.0;  ///< displacement of the center in the step [m]
  Eigen::ArrayX2d slip;              ///< of the nodes over the plane in this step, along x and z
  std::vector<Eigen::Index> nodes;   ///< in contact, ascending
  Eigen::Index sticking = 0;         ///< number of sticking nodes among them
};

/// @brief Solve by the semismooth Newton method for forces, penetration and displacement of the center together.
/// @param[in] problem problem of this step
/// @param[in] guess forces to start from
/// @param[in,out] stiffness of an earlier contact
/// @throws ConvergenceError if the sets do not settle
[[nodiscard]] StickSlip solve_stick_slip(const StickSlipProblem& problem, const VectorField& guess,
                                         ContactStiffness& stiffness);

/// @brief Conditions at an instant, common to the direct and the iterative solver of its linear systems. Nodes slip
/// from their own positions in the previous step.
class TransientStickSlipSystem : public StickSlipSystem {
 public:
  [[nodiscard]] ConditionScales scales() const override { return scales_; }
  [[nodiscard]] double load() const override { return problem_.load; }
  [[nodiscard]] Eigen::Index first_node() const override { return 0; }
  [[nodiscard]] int products() const override { return products_; }

  void find_displacements(ContactSolution& state) override;

 protected:
  /// @param[in] problem must outlive this object
  /// @param[in] displaced displacements under a guess of the forces; may be empty if the condition on the center does
  /// not depend on them
  TransientStickSlipSystem(const StickSlipProblem& problem, const std::vector<HalfField>& displaced);

  [[nodiscard]] const StickSlipProblem& problem() const { return problem_; }
  /// @return condition on the center, for the displacements found last
  [[nodiscard]] const CenterRow& center() const { return center_; }
  /// @return factor that makes the larger coefficient of the condition for load and penetration 1, in units of force
  [[nodiscard]] double approach_scale() const;
  /// @return residual of the condition on the center [N]
  [[nodiscard]] double center_excess(const ContactSolution& state) const;
  /// @return whether a node is in the middle of its row, where the sideways displacement is zero
  [[nodiscard]] bool in_middle(Eigen::Index node) const { return node % problem_.surface.half_nodes() == 0; }
  void count_products(int more) { products_ += more; }

 private:
  const StickSlipProblem& problem_;
  ConditionScales scales_;
  CenterRow center_;
  int products_ = 0;
};

/// @brief Direct solver with dense factors of the nodes that are, or recently were, in contact: for contacts of some
/// hundred nodes.
/// @param[in] problem must outlive the system
/// @param[in] guess forces to start from
/// @param[in,out] stiffness of an earlier contact
[[nodiscard]] std::unique_ptr<StickSlipSystem> direct_stick_slip(const StickSlipProblem& problem,
                                                                 const VectorField& guess, ContactStiffness& stiffness);

/// @brief Iterative solver for large contacts: a Krylov method with about twenty products with the compliance for each
/// system. The preconditioner contains the own block of each node.
/// @param[in] problem,guess same as in `direct_stick_slip`
[[nodiscard]] std::unique_ptr<StickSlipSystem> iterative_stick_slip(const StickSlipProblem& problem,
                                                                    const VectorField& guess);

}  // namespace viscoroll::detail
