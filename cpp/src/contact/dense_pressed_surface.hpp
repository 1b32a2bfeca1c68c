/// @file
/// @brief Small frictionless contacts, solved with the compliance matrix between their nodes and its factors.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/dense_solvers.hpp"
#include "contact/active_set.hpp"
#include "contact/contact_problem.hpp"

namespace viscoroll::detail {

/// @brief A surface with so few nodes in contact that products with a matrix take less time than operator applications.
/// If a contact is mirror-symmetric, only one side is solved for. Factors precondition a Krylov method; they are kept
/// while few nodes join or leave.
class DensePressedSurface : public PressedSurface {
 public:
  /// @param[in] problem problem whose surface provides single entries of its compliance; must outlive this object
  explicit DensePressedSurface(const ContactProblem& problem);

  /// @param[in] problem contact problem
  /// @param[in] nodes nodes that may be in contact
  /// @return whether the nodes are few enough and the compliance between them is available
  [[nodiscard]] static bool is_applicable(const ContactProblem& problem, const std::vector<Eigen::Index>& nodes);

  void press(PressedNodes& contact, double tolerance) override;
  [[nodiscard]] Eigen::ArrayXd height(const PressedNodes& contact) override;
  [[nodiscard]] const Eigen::ArrayXd& weights() const override { return weights_; }
  [[nodiscard]] double stiffness() const override { return problem_.surface->normal_stiffness(); }
  /// @return number of operator applications and matrix products
  [[nodiscard]] int products() const { return products_; }

 private:
  /// Nodes that are unknowns, and the number of nodes that each represents.
  struct Unknowns {
    std::vector<Eigen::Index> nodes;
    Eigen::VectorXd counts;
  };

  [[nodiscard]] Eigen::Index image_of(Eigen::Index node) const;
  [[nodiscard]] Unknowns unknowns_of(const std::vector<Eigen::Index>& contact) const;
  [[nodiscard]] Eigen::MatrixXd compliance(const Unknowns& unknowns) const;
  void update_factors(const std::vector<Eigen::Index>& nodes, const Eigen::MatrixXd& matrix);
  [[nodiscard]] Eigen::VectorXd approximate_forces(const Eigen::VectorXd& scaled_displacements) const;

  const ContactProblem& problem_;
  bool is_symmetric_;
  Eigen::ArrayXd weights_;
  int products_ = 0;
  SingleFactors factors_;
  std::vector<Eigen::Index> factored_;  // nodes of the factored matrix, ascending
  std::vector<Eigen::Index> places_;    // index of each unknown in `factored_`, or -1
};

}  // namespace viscoroll::detail
