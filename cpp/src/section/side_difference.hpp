/// @file
/// @brief By how much a tread that ends at its faces yields more than one that goes on, crowned to the first order,
/// order by order. See docs/theory/wheels.md.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "modal/harmonic_body.hpp"
#include "parallel.hpp"
#include "section/section_compliance.hpp"

namespace viscoroll::detail {

/// @brief The difference at some orders, times a modulus: that of the outermost layer at each. Between them it is
/// smooth.
struct SampledDifference {
  Eigen::ArrayXd orders;  ///< `sampled_orders`
  Eigen::ArrayXd z;       ///< of the lines, from the middle of the tread, or as far as it is felt, to its face [m]
  Eigen::Index components = 1;
  /// [part] a row for each order, of a matrix by columns: displacement along normal, phi and tangent of every line,
  /// component * lines
  /// + line, per force on all of a line and its mirror image, per radian [1/m]
  std::array<Eigen::MatrixXcd, 2> parts;

  [[nodiscard]] Eigen::Index amplitudes() const { return components * z.size(); }
  /// @brief Have one part at one of the orders.
  /// @param[in] part of the section
  /// @param[in] order its number
  /// @param[in] matrix as `SideDifference::at` has it
  void set(Parity part, Eigen::Index order, Eigen::MatrixXcd matrix);
};

/// @return orders at which the difference is to be known: 0, and from 1 on at equal ratios
[[nodiscard]] Eigen::ArrayXd sampled_orders(const CoatedWheel& wheel, const SectionFineness& fineness = {});

/// @return layers from the hub outwards, by a unit of stress
template <class Scalar>
[[nodiscard]] std::vector<SectionMedium<std::complex<double>>> section_media(const LayerStack<Scalar>& layers,
                                                                             const Scalar& unit);
/// @return the same per modulus of the outermost one, as an order sees them
[[nodiscard]] std::vector<SectionMedium<std::complex<double>>> section_media(const HarmonicBody& body,
                                                                             std::size_t order);

/// @brief What finite elements make of a crown, to the first order in its curvature, on a tread that goes on straight
/// along the path: what modal/crown.hpp says of all waves, of those that the elements carry.
class SectionCrown {
 public:
  /// @param[in] wheel at least one layer, crowned
  /// @param[in] tangential whether loads along phi and z occur, or those along r alone
  /// @param[in] fineness of the elements
  SectionCrown(const CoatedWheel& wheel, bool tangential, const SectionFineness& fineness);

  /// @param[in] m order of the wheel
  /// @param[in] layers what they are made of, from the hub outwards
  /// @param[in] parts that are asked for
  /// @return as `SectionCompliance::at`
  template <class Scalar>
  [[nodiscard]] std::array<SectionCompliance::Matrix<Scalar>, 2> at(double m,
                                                                    const std::vector<SectionMedium<Scalar>>& layers,
                                                                    std::span<const Parity> parts) const;

 private:
  SectionCompliance straight_;
  double crown_radius_;  // so flat that what it changes is linear in the curvature [m]
  SectionCompliance crowned_;
  double proportion_;   // of the curvature of the wheel's crown
  double lengthening_;  // of a radian, beside the wheel's
};

/// @brief Sections of a wheel's tread with faces and of one without, cut alike, so that what elements make of waves
/// that are too short for them drops out: of the flat tread, and in the first order what the crown adds to it.
class SideDifference {
 public:
  /// @param[in] wheel at least one layer
  /// @param[in] tangential whether loads along phi and z occur, or those along r alone
  /// @param[in] fineness of the elements
  SideDifference(const CoatedWheel& wheel, bool tangential, const SectionFineness& fineness = {});

  /// @param[in] body the wheel's layers at the orders of `sampled_orders`
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  [[nodiscard]] SampledDifference sampled(const HarmonicBody& body, int threads, Watch& watch) const;

  /// @brief The difference at one order, for loads and displacements (U, V, W) e^(i m phi), of which V lags by a
  /// quarter of a turn: real for real media, and analytic in theirs.
  /// @param[in] m order
  /// @param[in] layers from the hub outwards, with positive real parts
  /// @param[in] parts that are asked for
  /// @param[in] worker whose step this is
  /// @return [part] as in `SampledDifference` [1/(unit of stress)/m]
  [[nodiscard]] std::array<Eigen::MatrixXcd, 2> at(double m,
                                                   const std::vector<SectionMedium<std::complex<double>>>& layers,
                                                   std::span<const Parity> parts, const Worker& worker) const;

  /// @return room for the difference at some orders, at which the parts have a row each
  [[nodiscard]] SampledDifference at_orders(const Eigen::ArrayXd& orders) const;

 private:
  double left_out_;  // of half the width, in the middle [m]
  SectionCompliance face_;
  SectionCompliance endless_;
  std::optional<SectionCrown> crown_;
  bool tangential_;
};

}  // namespace viscoroll::detail
