/// @file
/// @brief Difference between the compliance of a tread with faces and that of an unbounded tread, whose crown is
/// included to first order in its curvature (docs/theory/wheels.md). It is computed for each order m around the axis. A
/// cache keeps such differences for further speeds, loads and meshes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "modal/harmonic_body.hpp"
#include "section/section_compliance.hpp"

namespace viscoroll::detail {

/// @brief Difference at some orders, multiplied by the modulus of the outermost layer at each order. Between the orders
/// it is smooth.
struct SampledDifference {
  Eigen::ArrayXd orders;  ///< orders, see `sampled_orders`
  Eigen::ArrayXd z;       ///< axial positions of the surface nodes, one per line of nodes, ascending to the face [m]
  Eigen::Index components = 1;  ///< number of directions: 1, or 3 with tangential loads
  /// One matrix for each part, with one row for each order. A row contains a column-major matrix of displacements along
  /// normal, phi and tangent, at component * lines + line [1/m]. They are caused by a unit force per radian, half of
  /// which acts on a line and half on its mirror image.
  std::array<Eigen::MatrixXcd, 2> parts;

  /// @return number of rows of the matrix of one order: components times lines
  [[nodiscard]] Eigen::Index amplitudes() const { return components * z.size(); }
  /// @brief Store one part at one of the orders.
  /// @param[in] part part of the section
  /// @param[in] order index of the order
  /// @param[in] matrix result of `SideDifference::at`
  void set(Parity part, Eigen::Index order, Eigen::MatrixXcd matrix);
};

/// @return orders at which the difference is sampled: 0, and from 1 on at equal ratios
[[nodiscard]] Eigen::ArrayXd sampled_orders(const CoatedWheel& wheel, const SectionFineness& fineness = {});

/// @return materials of the layers from the hub outwards, relative to a unit of stress
template <class Scalar>
[[nodiscard]] std::vector<SectionMedium<std::complex<double>>> section_media(const LayerStack<Scalar>& layers,
                                                                             const Scalar& unit);
/// @return materials of the layers at an order, relative to the modulus of the outermost layer
[[nodiscard]] std::vector<SectionMedium<std::complex<double>>> section_media(const HarmonicBody& body,
                                                                             std::size_t order);

/// @brief Change of the compliance of an unbounded tread, straight along the path, due to a crown. It is computed with
/// finite elements, to first order in the curvature of the crown. It corresponds to `crowned_compliances`, but contains
/// only the waves that the elements resolve.
class SectionCrown {
 public:
  /// @param[in] wheel crowned wheel with at least one layer
  /// @param[in] tangential whether there are tangential loads besides normal ones
  /// @param[in] fineness sizes of the elements
  SectionCrown(const CoatedWheel& wheel, bool tangential, const SectionFineness& fineness);

  /// @brief Change of the compliance due to the crown at one order.
  /// @param[in] m order of the wheel
  /// @param[in] layers material of each layer, from the hub outwards
  /// @param[in] parts requested parts
  /// @return change, in the form of `SectionCompliance::at`
  template <class Scalar>
  [[nodiscard]] std::array<SectionCompliance::Matrix<Scalar>, 2> at(double m,
                                                                    const std::vector<SectionMedium<Scalar>>& layers,
                                                                    std::span<const Parity> parts) const;

 private:
  SectionCompliance straight_;
  double crown_radius_;  // radius of the reference crown, whose effect is linear in the curvature [m]
  SectionCompliance crowned_;
  double curvature_ratio_;  // curvature of the wheel's crown relative to the reference
  double radius_ratio_;     // outer radius of the straight section relative to that of the wheel
};

/// @brief Difference between the compliance of a tread with faces and that of an unbounded tread. Within the width of a
/// flat tread, both sections have the same elements.
///
/// The errors of the elements for short waves cancel in the difference: completely for a flat tread, and to first order
/// in the curvature for a crowned one.
class SideDifference {
 public:
  /// @param[in] wheel wheel with at least one layer
  /// @param[in] tangential whether there are tangential loads besides normal ones
  /// @param[in] fineness sizes of the elements
  SideDifference(const CoatedWheel& wheel, bool tangential, const SectionFineness& fineness = {});

  /// @brief Difference at all orders of a body.
  /// @param[in] body layers of the wheel at the orders of `sampled_orders`
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  [[nodiscard]] SampledDifference sampled(const HarmonicBody& body, int threads, Watch& watch) const;

  /// @brief Difference at one order, for loads and displacements (U, i V, W) e^(i m phi). It is real for real media,
  /// and analytic in the moduli.
  /// @param[in] m order
  /// @param[in] layers material of each layer from the hub outwards, with positive real parts
  /// @param[in] parts requested parts
  /// @param[in] worker worker whose `checkpoint` is called between solves
  /// @return for each part, the matrix of `SampledDifference` without the factors i [1/(unit of stress)/m]
  [[nodiscard]] std::array<Eigen::MatrixXcd, 2> at(double m,
                                                   const std::vector<SectionMedium<std::complex<double>>>& layers,
                                                   std::span<const Parity> parts, const Worker& worker) const;

  /// @return result with these orders, whose rows are allocated but not set: see `SampledDifference::set`
  [[nodiscard]] SampledDifference allocated(const Eigen::ArrayXd& orders) const;

 private:
  double omitted_;  // length on each side of the middle without elements, because the faces do not affect it [m]
  SectionCompliance face_;
  SectionCompliance unbounded_;
  std::optional<SectionCrown> crown_;
  bool tangential_;
};

/// @brief Differences between a tread with faces and an unbounded one, from a cache of the last few treads of the
/// process.
///
/// The key contains the dimensions of the wheel and all other numbers on which the differences depend.
/// @param[in] wheel wheel with at least one layer
/// @param[in] tangential whether there are tangential loads besides normal ones
/// @param[in] key_numbers all other numbers on which the differences depend
/// @param[in] compute function that computes the differences if the cache does not contain them
/// @return the differences
[[nodiscard]] std::shared_ptr<const std::vector<SampledDifference>> cached_differences(
    const CoatedWheel& wheel, bool tangential, const std::vector<double>& key_numbers,
    const std::function<std::vector<SampledDifference>()>& compute);

/// @brief Difference between a rolling tread with faces and an unbounded one.
///
/// The key contains the moduli relative to that of the outermost layer, so that layers that share one relaxation
/// function are solved once for all speeds.
/// @param[in] wheel wheel with at least one layer
/// @param[in] body its layers at the orders of `sampled_orders`
/// @param[in] tangential whether there are tangential loads besides normal ones
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return the difference
[[nodiscard]] std::shared_ptr<const SampledDifference> cached_difference(const CoatedWheel& wheel,
                                                                         const HarmonicBody& body, bool tangential,
                                                                         int threads, Watch& watch);

}  // namespace viscoroll::detail
