/// @file
/// @brief Interface through which a contact solver sees a body: displacements of its surface due to nodal forces, and
/// slopes of the surface along the path.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "influence/node_rows.hpp"
#include "influence/table.hpp"
#include "modal/spectrum.hpp"
#include "surface/surface_window.hpp"

namespace viscoroll::detail {

/// @brief Vectors at the nodes of a window: one row per node, with columns x (forward), y (down) and z (sideways).
using VectorField = Eigen::ArrayX3d;

/// @brief Column of a `VectorField`.
enum Axis : Eigen::Index { kForward = 0, kDown = 1, kSideways = 2 };

/// @brief Which of the two bodies deform.
enum class Deforming { rolling, counterbody, both };

/// @brief Displacements of the surfaces of two bodies due to the same forces, each as it adds to the relative
/// displacement [m].
struct Displacements {
  VectorField rolling;      ///< no rows if the rolling body is rigid
  VectorField counterbody;  ///< no rows if the counterbody is rigid

  [[nodiscard]] VectorField relative() const& { return Displacements(*this).relative(); }
  [[nodiscard]] VectorField relative() && {
    if (counterbody.rows() == 0) return std::move(rolling);
    if (rolling.rows() == 0) return std::move(counterbody);
    rolling += counterbody;
    return std::move(rolling);
  }
};

/// @brief Work dissipated in each of two bodies, per radian of rotation of the rolling body [N m].
struct Losses {
  double rolling = 0.0;
  double counterbody = 0.0;

  [[nodiscard]] double sum() const { return rolling + counterbody; }
};

/// @brief Threads that perform a computation, and its progress and cancellation.
struct Execution {
  int threads;                          ///< number of threads, 0 for all cores
  std::reference_wrapper<Watch> watch;  ///< progress and cancellation
};

/// @brief Translation-invariant compliance from which scales and preconditioners are made. It equals that of the
/// operator around the lowest point and approximates it elsewhere. The local compliance of a sum of operators is the
/// sum of theirs.
struct LocalCompliance {
  /// [Entry], tables of flat patches that reach across the window; only that of r by r if no others are needed
  std::array<std::shared_ptr<const Table>, kEntries> tables;
  /// [component][axis] at every node, with components r, phi and theta, or r alone
  std::vector<std::array<WindowField, 3>> directions;
  /// Same at the points where displacements are evaluated, see `SurfaceOperator::collocation`
  std::vector<std::array<WindowField, 3>> displaced_directions;

  [[nodiscard]] const Table& table(Entry entry) const { return *tables[static_cast<std::size_t>(entry)]; }
  /// @param[in] force forces along x, y and z [N]
  /// @return loads along the components, one column each [N]
  [[nodiscard]] Eigen::ArrayXXd loads(const VectorField& force) const;
  /// @param[in] components displacements along the components, one column each [m]
  /// @return displacements along x, y and z [m]
  [[nodiscard]] VectorField displacements(const Eigen::ArrayXXd& components) const;
  /// @param[in] loads loads along the components, one column each [N]
  /// @return forces along x, y and z [N]
  [[nodiscard]] VectorField forces(const Eigen::ArrayXXd& loads) const;
};

/// @brief Displacements of a surface due to forces on the nodes of a window. Operators are immutable but have internal
/// buffers, so each may be used by one thread at a time.
class SurfaceOperator {
 public:
  virtual ~SurfaceOperator() = default;

  [[nodiscard]] virtual const Window& window() const = 0;
  [[nodiscard]] virtual const Execution& execution() const = 0;

  /// @brief Distance downstream of the nodes at which displacements are evaluated [spacings].
  /// It is 0, except where strong memory leaves the surface no resistance to forces that alternate from row to row
  /// (docs/theory/normal-contact.md).
  [[nodiscard]] virtual double collocation() const { return 0.0; }

  /// @brief Period of the surface [nodes]; empty if forces and displacements are not periodic.
  [[nodiscard]] virtual std::optional<WindowShape> period() const { return std::nullopt; }

  /// @param[in] force force on every node [N]
  /// @return displacement of every node [m]
  [[nodiscard]] virtual VectorField displacement(const VectorField& force) const = 0;

  /// @param[in] nodes loaded nodes
  /// @param[in] pressing force on each of them, upwards [N]
  /// @return upward displacements of these nodes [m]
  [[nodiscard]] virtual Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                            const Eigen::VectorXd& pressing) const = 0;

  /// @brief Whether `normal_displacement` accepts nodes that also represent their mirror images.
  [[nodiscard]] virtual bool takes_mirrored() const { return false; }

  /// @param[in] displaced,loaded node numbers
  /// @return upward displacement of the displaced nodes (rows) per pressing force on the loaded nodes (columns) [m/N];
  /// empty if the operator cannot provide single entries
  [[nodiscard]] virtual std::optional<Eigen::MatrixXd> normal_compliance(
      const std::vector<Eigen::Index>& /*displaced*/, const std::vector<Eigen::Index>& /*loaded*/) const {
    return std::nullopt;
  }

  /// @brief Which of the two bodies this surface belongs to. Forces act on the rolling body; displacements are those of
  /// the rolling body relative to the counterbody.
  [[nodiscard]] virtual Deforming deforming() const { return Deforming::rolling; }

  /// @param[in] force force on every node [N]
  /// @return displacements of every node of each body
  [[nodiscard]] virtual Displacements displacements(const VectorField& force) const;

  /// @return distance between a node and its downstream neighbor along the path of the material [m]
  [[nodiscard]] virtual double row_distance() const = 0;

  /// @brief Force with which pressure pushes the rolling body back along the deformed surface of the counterbody.
  /// It is the sum of p dw/dxi, where w is the displacement of the counterbody's own surface and xi the distance along
  /// the path of the material (docs/theory/planes-and-pairs.md). The slope is computed from differences between nodes.
  /// @param[in] force force on every node [N]
  /// @return force [N]
  [[nodiscard]] virtual double slope_force(const VectorField& force) const;

  /// @return the same surface with every other node, whose patches are twice as wide and long
  [[nodiscard]] virtual std::shared_ptr<const SurfaceOperator> coarsened() const = 0;

  /// @return the same surface on a window inside this one
  [[nodiscard]] virtual std::shared_ptr<const SurfaceOperator> within(const Window& window) const = 0;

  [[nodiscard]] virtual const LocalCompliance& local() const = 0;

  /// @param[in] force force on every node [N]
  /// @return dissipated work per radian of rotation [N m], computed from neither the contact nor the displacements
  [[nodiscard]] virtual Losses dissipation(const VectorField& force) const = 0;

  /// @return approximate number of floating-point operations of one application
  [[nodiscard]] virtual double operations() const = 0;

  [[nodiscard]] WindowShape shape() const { return window().shape(); }

  /// @param[in] pressing force on every node, upwards [N]
  /// @param[in] mirrored whether the forces are mirror-symmetric and `takes_mirrored` is true
  /// @return upward displacement of every node [m]
  [[nodiscard]] Eigen::ArrayXd normal_displacement(const Eigen::ArrayXd& pressing, bool mirrored = false) const;

  /// @return pressing force on a node per displacement that it causes there [N/m]
  [[nodiscard]] double normal_stiffness() const;
  /// @return tangential force on a node per displacement relative to its upstream neighbor [N/m]
  [[nodiscard]] double slip_stiffness() const;

 protected:
  /// @param[in] lost work dissipated in the body of this surface [N m]
  [[nodiscard]] Losses losses(double lost) const;

 private:
  [[nodiscard]] const NodeRows& every_node(bool mirrored) const;

  mutable std::array<std::optional<NodeRows>, 2> every_node_;  // without and with mirror images
};

/// @brief Mean slope along the path over the patch of each node, which is as long as the distance between rows.
/// It combines the differences over two and four rows so that the error of second order cancels, except next to the
/// first and last row, where there is hardly any pressure. See docs/theory/planes-and-pairs.md.
/// @param[in] values values at the nodes, row by row
/// @param[in] row nodes per row
/// @param[in] distance distance between rows [m]
/// @return slope at every node, 0 in the first and the last row
[[nodiscard]] Eigen::ArrayXd patch_slope(const Eigen::ArrayXd& values, Eigen::Index row, double distance);

/// @brief Interpolate displacements evaluated downstream of the nodes back to the nodes, by cubics through four rows.
/// @param[in] values values downstream of the nodes, row by row
/// @param[in] row nodes per row
/// @param[in] downstream distance from the nodes, see `SurfaceOperator::collocation` [rows], >= 0
/// @return value at every node; unchanged in the first two rows and the last one, where there is no pressure
[[nodiscard]] Eigen::ArrayXd at_nodes(const Eigen::ArrayXd& values, Eigen::Index row, double downstream);

}  // namespace viscoroll::detail
