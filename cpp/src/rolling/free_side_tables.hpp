/// @file
/// @brief Influence on a tread that ends at two faces.
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "influence/side_sum.hpp"
#include "rolling/body.hpp"
#include "rolling/surface_tables.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll::detail {

/// @brief How nodes of a body cross the contact.
struct MeshAtSpeed {
  MeshOnBody mesh;
  double angular_speed;  ///< of this body [rad/s]
};

/// @brief What the faces of a tread add, summed over all orders.
/// @param[in] wheel at least one layer
/// @param[in] layers of it
/// @param[in] rolling nodes on it
/// @param[in] tangential whether loads along phi and z occur, or those along r alone
/// @param[in] execution threads, progress and cancellation
[[nodiscard]] SideSum sum_of_sides(const CoatedWheel& wheel, const LayeredBody& layers, const MeshAtSpeed& rolling,
                                   bool tangential, const Execution& execution);

/// @brief Tables of the endless tread, and sums of what the faces add, made as they are first asked for.
class FreeSideTables final : public SurfaceTables {
 public:
  /// @param[in] endless tables of the same layers without faces
  /// @param[in] wheel at least one layer
  /// @param[in] layers of it
  /// @param[in] crossing how its material crosses the contact
  FreeSideTables(std::unique_ptr<const SurfaceTables> endless, CoatedWheel wheel, LayeredBody layers,
                 const Crossing& crossing);

  [[nodiscard]] std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const override;

 private:
  [[nodiscard]] std::shared_ptr<const SideSum> sum(bool tangential, const Execution& execution) const;

  std::unique_ptr<const SurfaceTables> endless_;
  CoatedWheel wheel_;
  LayeredBody layers_;
  MeshAtSpeed rolling_;
  mutable std::timed_mutex mutex_;
  mutable std::array<std::shared_ptr<const SideSum>, 2> sums_;  // of loads along r alone, and of all
};

}  // namespace viscoroll::detail
