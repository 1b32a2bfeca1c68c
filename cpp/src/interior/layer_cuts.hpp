/// @file
/// @brief Layers cut where fields are wanted, so that the recursion stops there.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "modal/medium.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief The layers of a sphere, cut at a list of places.
class LayerCuts {
 public:
  LayerCuts(const CoatedSphere& sphere, std::span<const Place> places);

  /// @brief Pieces of the layers, from the center outwards.
  [[nodiscard]] std::vector<Medium<std::complex<double>>> pieces(
      std::span<const Medium<std::complex<double>>> layers) const;

  /// @return number of boundaries between pieces, the innermost and the outermost among them
  [[nodiscard]] std::size_t boundaries() const { return radii_.size(); }
  /// @return number of the boundary at a place
  [[nodiscard]] std::size_t boundary(std::size_t place) const { return boundary_[place]; }

 private:
  std::vector<double> radii_;          // of all boundaries, ascending
  std::vector<std::size_t> layer_;     // that each piece belongs to
  std::vector<std::size_t> boundary_;  // [place]
};

}  // namespace viscoroll::detail
