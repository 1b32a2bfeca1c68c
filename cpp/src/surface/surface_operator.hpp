/// @file
/// @brief All that a contact solver sees of a body: what nodal forces do to its surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "influence/node_rows.hpp"
#include "influence/table.hpp"
#include "modal/spectrum.hpp"
#include "parallel.hpp"
#include "surface/surface_window.hpp"
#include "surface/window.hpp"

namespace viscoroll::detail {

/// @brief Vectors at the nodes of a window: a row for each node, with columns x (forward), y (down) and z (sideways).
using VectorField = Eigen::ArrayX3d;

/// @brief Column of a `VectorField`.
enum Axis : Eigen::Index { kForward = 0, kDown = 1, kSideways = 2 };

/// @brief Which of two bodies deform.
enum class Deforming { rolling, counterpart, both };

/// @brief What the same forces do to the surfaces of two bodies, each as it adds to their relative displacement [m].
struct Displacements {
  VectorField rolling;      ///< no rows where it is rigid
  VectorField counterpart;  ///< no rows where it is rigid

  [[nodiscard]] VectorField relative() const& { return Displacements(*this).relative(); }
  [[nodiscard]] VectorField relative() && {
    if (counterpart.rows() == 0) return std::move(rolling);
    if (rolling.rows() == 0) return std::move(counterpart);
    rolling += counterpart;
    return std::move(rolling);
  }
};

/// @brief Work lost in each of two bodies, per radian of the one that rolls [N m].
struct Losses {
  double rolling = 0.0;
  double counterpart = 0.0;

  [[nodiscard]] double sum() const { return rolling + counterpart; }
};

/// @brief Who computes, and who may stop it.
struct Execution {
  int threads;                          ///< 0 for all cores
  std::reference_wrapper<Watch> watch;  ///< progress and cancellation
};

/// @brief Translation-invariant compliance that is an operator's own around the lowest point, and near it elsewhere:
/// what scales and preconditioners are made of. The compliance of a sum of operators is the sum of theirs.
struct LocalCompliance {
  /// [Entry], tables of flat patches that reach across the window; only that of r by r where there are no others
  std::array<std::shared_ptr<const Table>, kEntries> tables;
  /// [component][axis] of r, phi and theta, or of r alone, at every node
  std::vector<std::array<WindowField, 3>> directions;
  /// the same where displacements are taken, see `SurfaceOperator::collocation`
  std::vector<std::array<WindowField, 3>> displaced_directions;

  [[nodiscard]] const Table& table(Entry entry) const { return *tables[static_cast<std::size_t>(entry)]; }
  /// @return forces along x, y and z as loads along the components, a column for each
  [[nodiscard]] Eigen::ArrayXXd loads(const VectorField& force) const;
  /// @return displacements along the components, a column for each, as those along x, y and z
  [[nodiscard]] VectorField displacements(const Eigen::ArrayXXd& components) const;
  /// @return loads along the components, a column for each, as forces along x, y and z
  [[nodiscard]] VectorField forces(const Eigen::ArrayXXd& loads) const;
};

/// @brief Displacements of a surface by forces on the nodes of a window. Operators do not change, but keep buffers: one
/// serves one thread at a time.
class SurfaceOperator {
 public:
  virtual ~SurfaceOperator() = default;

  [[nodiscard]] virtual const Window& window() const = 0;
  [[nodiscard]] virtual const Execution& execution() const = 0;

  /// @brief Where displacements are taken, downstream of the nodes [spacings]: 0, at the nodes, but where memory leaves
  /// the surface no resistance to forces that alternate from row to row (docs/theory/normal-contact.md).
  [[nodiscard]] virtual double collocation() const { return 0.0; }

  /// @param[in] force on every node [N]
  /// @return displacement of every node [m]
  [[nodiscard]] virtual VectorField displacement(const VectorField& force) const = 0;

  /// @param[in] nodes that carry forces
  /// @param[in] pressing force on each of them, upwards [N]
  /// @return their upward displacements [m]
  [[nodiscard]] virtual Eigen::VectorXd normal_displacement(const NodeRows& nodes,
                                                            const Eigen::VectorXd& pressing) const = 0;

  /// @brief Whether `normal_displacement` takes nodes that stand for their mirror images as well.
  [[nodiscard]] virtual bool takes_mirrored() const { return false; }

  /// @param[in] displaced,loaded nodes
  /// @return upward displacement of the former per pressing force on the latter, a row and a column for each [m/N];
  /// nothing where it is known by products alone
  [[nodiscard]] virtual std::optional<Eigen::MatrixXd> normal_compliance(
      const std::vector<Eigen::Index>& /*displaced*/, const std::vector<Eigen::Index>& /*loaded*/) const {
    return std::nullopt;
  }

  /// @brief Of which of the two bodies it is. Forces are those on the body that rolls; displacements those of it,
  /// relative to what it rolls on.
  [[nodiscard]] virtual Deforming deforming() const { return Deforming::rolling; }

  /// @param[in] force on every node [N]
  /// @return displacements of every node of each body
  [[nodiscard]] virtual Displacements displacements(const VectorField& force) const;

  /// @return way of the material from a node to the next one downstream [m]
  [[nodiscard]] virtual double row_distance() const = 0;

  /// @brief The force with which pressure pushes the rolling body back along the deformed surface of what it rolls on:
  /// the sum of p dw/d(way of the material), w that surface's own displacement (docs/theory/planes-and-pairs.md), by
  /// differences between nodes.
  /// @param[in] force on every node [N]
  /// @return [N]
  [[nodiscard]] virtual double pushback(const VectorField& force) const;

  /// @return the same surface with every other node, each of whose patches is twice as wide and long
  [[nodiscard]] virtual std::shared_ptr<const SurfaceOperator> coarsened() const = 0;

  /// @return the same surface on a window inside this one
  [[nodiscard]] virtual std::shared_ptr<const SurfaceOperator> within(const Window& window) const = 0;

  [[nodiscard]] virtual const LocalCompliance& local() const = 0;

  /// @param[in] force on every node [N]
  /// @return work lost per radian of turning [N m], which uses neither the contact nor the displacements
  [[nodiscard]] virtual Losses dissipation(const VectorField& force) const = 0;

  /// @return floating-point operations of one displacement, roughly
  [[nodiscard]] virtual double operations() const = 0;

  [[nodiscard]] WindowShape shape() const { return window().shape(); }

  /// @param[in] pressing force on every node, upwards [N]
  /// @param[in] mirrored whether mirror images bear the same, and `takes_mirrored`
  /// @return upward displacement of every node [m]
  [[nodiscard]] Eigen::ArrayXd normal_displacement(const Eigen::ArrayXd& pressing, bool mirrored = false) const;

  /// @return force per own displacement of a node, pressed [N/m]
  [[nodiscard]] double normal_stiffness() const;
  /// @return force along the plane per displacement of a node relative to its upstream neighbor [N/m]
  [[nodiscard]] double slip_stiffness() const;

 protected:
  /// @param[in] lost by the one body that this is the surface of [N m]
  [[nodiscard]] Losses losses(double lost) const;

 private:
  [[nodiscard]] const NodeRows& every_node(bool mirrored) const;

  mutable std::array<std::optional<NodeRows>, 2> every_node_;  // without mirror images and with them
};

}  // namespace viscoroll::detail
