/// @file
/// @brief Small contacts without friction: the compliance between their nodes as a matrix, and its factors.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/active_set.hpp"
#include "contact/contact_problem.hpp"
#include "dense_solvers.hpp"

namespace viscoroll::detail {

/// @brief A surface on which so few nodes touch that products with a matrix take less time than those of the surface.
/// Of a contact that is the same on both sides of the path one side is solved for. Factors are kept while few nodes
/// come and go, and precondition a Krylov method.
class PressedByMatrix : public PressedSurface {
 public:
  /// @param[in] problem whose surface tells its compliance between nodes; outlives this object
  explicit PressedByMatrix(const ContactProblem& problem);

  /// @param[in] problem which
  /// @param[in] nodes that may touch
  /// @return whether they are few enough, and the compliance between them is known
  [[nodiscard]] static bool serves(const ContactProblem& problem, const std::vector<Eigen::Index>& nodes);

  void press(PressedNodes& contact, double tolerance) override;
  [[nodiscard]] Eigen::ArrayXd height(const PressedNodes& contact) override;
  [[nodiscard]] const Eigen::ArrayXd& weights() const override { return weights_; }
  [[nodiscard]] double stiffness() const override { return problem_.surface->normal_stiffness(); }
  /// @return products with the surface, and with the matrix
  [[nodiscard]] int products() const { return products_; }

 private:
  /// Nodes that are solved for, and how many each stands for.
  struct Unknowns {
    std::vector<Eigen::Index> nodes;
    Eigen::VectorXd counts;
  };

  [[nodiscard]] Eigen::Index image_of(Eigen::Index node) const;
  [[nodiscard]] Unknowns unknowns_of(const std::vector<Eigen::Index>& contact) const;
  [[nodiscard]] Eigen::MatrixXd compliance(const Unknowns& unknowns) const;
  void follow(const std::vector<Eigen::Index>& nodes, const Eigen::MatrixXd& matrix);
  [[nodiscard]] Eigen::VectorXd about_forces(const Eigen::VectorXd& displacements) const;

  const ContactProblem& problem_;
  bool is_symmetric_;
  Eigen::ArrayXd weights_;
  int products_ = 0;
  SingleFactors factors_;
  std::vector<Eigen::Index> factored_;  // nodes, ascending
  std::vector<Eigen::Index> places_;    // among these of each that is solved for, or -1
};

}  // namespace viscoroll::detail
