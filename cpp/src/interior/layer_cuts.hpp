/// @file
/// @brief Layers split at the places where fields are evaluated, so that the recursion stops there.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "modal/layered_body.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Layers of a body, split at a list of places.
class LayerCuts {
 public:
  LayerCuts(const LayeredBody& body, std::span<const Place> places);

  /// @brief Return the pieces of the layers, outwards.
  [[nodiscard]] LayerStack<std::complex<double>> pieces(const LayerStack<std::complex<double>>& layers) const;

  /// @return number of boundaries between pieces, including the innermost and the outermost
  [[nodiscard]] std::size_t boundaries() const { return boundaries_.size(); }
  /// @return index of the boundary at a place
  [[nodiscard]] std::size_t boundary(std::size_t place) const { return boundary_[place]; }

 private:
  std::vector<double> boundaries_;     // between pieces, outwards
  std::vector<std::size_t> layer_;     // layer of each piece
  std::vector<std::size_t> boundary_;  // [place]
};

}  // namespace viscoroll::detail
