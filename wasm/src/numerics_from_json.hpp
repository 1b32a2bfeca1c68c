/// @file
/// @brief Parts of the table `numerics` that cases and motions share.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "table.hpp"
#include "viscoroll/formulation.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::wasm {

template <>
inline constexpr auto kNames<Compliance> =
    std::to_array<Name<Compliance>>({{"radial", Compliance::radial}, {"vertical", Compliance::vertical}});
template <>
inline constexpr auto kNames<Curvature> = std::to_array<Name<Curvature>>(
    {{"sphere", Curvature::sphere}, {"paper", Curvature::paper}, {"exact", Curvature::exact}});

/// @brief Keys of a mesh.
class MeshKeys {
 public:
  /// @brief Take the keys.
  explicit MeshKeys(Table& numerics)
      : nodes_(numerics.maybe_integer("nodes_per_revolution")),
        max_order_(numerics.maybe_integer("max_order")),
        theta_nodes_(numerics.maybe_integer("theta_nodes_per_revolution")) {}

  /// @return the mesh, if its nodes are given
  /// @throws InvalidInput for a mesh out of range, and if other keys are given without the nodes
  [[nodiscard]] std::optional<Mesh> mesh() const {
    if (nodes_) {
      Mesh mesh{.nodes_per_revolution = *nodes_, .max_order = max_order_, .theta_nodes_per_revolution = theta_nodes_};
      validate(mesh);
      return mesh;
    }
    if (max_order_ || theta_nodes_) {
      throw InvalidInput("numerics.nodes_per_revolution", "must be given with max_order or theta_nodes_per_revolution",
                         "");
    }
    return std::nullopt;
  }

 private:
  std::optional<int> nodes_;
  std::optional<int> max_order_;
  std::optional<int> theta_nodes_;
};

}  // namespace viscoroll::wasm
