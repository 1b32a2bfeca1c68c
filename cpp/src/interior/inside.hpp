/// @file
/// @brief Body whose interior is evaluated: the speed at which its material passes the tractions, and its layers, split
/// at the places where fields are evaluated, so that the recursion stops there.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "modal/layered_body.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Layers of a body, and the angular speed that determines the frequencies of their orders.
struct Inside {
  LayeredBody body;
  double angular_speed;  ///< order m has the frequency m Omega [rad/s]; the angular speed of the body if it rotates
};

/// @param[in] shape body with layers
/// @param[in] angular_speed Omega of the rolling body [rad/s], > 0
/// @param[in] radius radius of the rolling body [m], > 0, which converts wave numbers of a plane to orders
/// @param[in] line whether it is a line contact
/// @param[in] curvature curvature terms of a sphere: sphere or paper
/// @throws InvalidInput for invalid input, for line contact of a sphere or wheel, and for point contact of a
/// cylinder
[[nodiscard]] Inside inside_of(const LayeredShape& shape, double angular_speed, double radius, bool line,
                               Curvature curvature);

/// @return same, for the given tractions, which are checked
[[nodiscard]] Inside inside_of(const LayeredShape& shape, double angular_speed, const Tractions& tractions);

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
