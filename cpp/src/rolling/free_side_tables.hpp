/// @file
/// @brief Influence of forces on a tread that ends at two faces.
#pragma once

#include <array>
#include <memory>
#include <mutex>

#include "influence/side_influence.hpp"
#include "rolling/body.hpp"
#include "rolling/surface_tables.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll::detail {

/// @brief Nodes of a body and its speed.
struct MeshAtSpeed {
  MeshOnBody mesh;
  double angular_speed;  ///< of this body [rad/s]
};

/// @brief Change of the compliance due to the faces of a tread, summed over all orders.
/// @param[in] wheel at least one layer
/// @param[in] layers layers of the wheel
/// @param[in] rolling nodes on the wheel and its speed
/// @param[in] tangential whether forces along phi and z occur, or forces along r only
/// @param[in] execution threads, progress and cancellation
[[nodiscard]] SideSum sum_of_sides(const CoatedWheel& wheel, const LayeredBody& layers, const MeshAtSpeed& rolling,
                                   bool tangential, const Execution& execution);

/// @brief Tables of the unbounded tread, and sums of the effect of the faces, computed when they are first needed.
class FreeSideTables final : public SurfaceTables {
 public:
  /// @param[in] unbounded tables of the same layers without faces
  /// @param[in] wheel at least one layer
  /// @param[in] layers layers of the wheel
  /// @param[in] kinematics motion of the material through the contact
  FreeSideTables(std::unique_ptr<const SurfaceTables> unbounded, CoatedWheel wheel, LayeredBody layers,
                 const ContactKinematics& kinematics);

  [[nodiscard]] std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const override;

 private:
  [[nodiscard]] std::shared_ptr<const SideSum> sum(bool tangential, const Execution& execution) const;

  std::unique_ptr<const SurfaceTables> unbounded_;
  CoatedWheel wheel_;
  LayeredBody layers_;
  MeshAtSpeed rolling_;
  mutable std::timed_mutex mutex_;
  mutable std::array<std::shared_ptr<const SideSum>, 2> sums_;  // for forces along r only, and for all forces
};

}  // namespace viscoroll::detail
