/// @file
/// @brief Waves of the bands of orders along one direction, at the offsets of a mesh.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/dense_products.hpp"
#include "influence/order_bands.hpp"
#include "influence/sampled_angles.hpp"
#include "influence/waves.hpp"

namespace viscoroll::detail {

/// @brief Waves of all bands along one direction. The first bands contain long waves, whose sums are interpolated from
/// a few sampled offsets.
class BandWaves {
 public:
  /// @param[in] bands orders
  /// @param[in] spacing spacing of the offsets, which start at 0 [rad]
  /// @param[in] reach largest offset [spacings]
  BandWaves(const std::vector<OrderBand>& bands, double spacing, int reach);

  [[nodiscard]] const RowMajorMatrix& operator()(std::size_t band, bool odd) const {
    return odd ? waves_[band].sines : waves_[band].cosines;
  }
  /// @return number of bands that are summed at the sampled offsets only
  [[nodiscard]] std::size_t long_bands() const { return long_; }
  /// @return number of sampled offsets
  [[nodiscard]] Eigen::Index sampled_offsets() const { return offsets_ ? offsets_->sampled.size() : 0; }
  /// @return interpolation from the sampled to all offsets, [offset, sampled offset]
  [[nodiscard]] const Eigen::MatrixXd& polynomials(bool odd) const { return odd ? offsets_->odd : offsets_->even; }

 private:
  std::size_t long_;
  std::optional<SampledOffsets> offsets_;
  std::vector<Waves> waves_;  // [band]
};

}  // namespace viscoroll::detail
