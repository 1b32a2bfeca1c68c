/// @file
/// @brief Attraction between two surfaces across their gap: hard wall and cubic potential. See docs/theory/adhesion.md.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>

namespace viscoroll::detail {

/// @brief Attraction sigma = peak (1 - g / range)^2 at the gap g, which ends at the range 3 work / peak, above a hard
/// wall at g = 0. It is a function of the gap alone. A closed gap has the attraction of g = 0.
struct TractionLaw {
  double peak;          ///< attraction at g = 0 [Pa], > 0
  Eigen::ArrayXd work;  ///< work of separation of every node [J/m^2], > 0

  /// @return gap at which the attraction of a node ends [m]
  [[nodiscard]] double range(Eigen::Index node) const { return 3.0 * work[node] / peak; }
  /// @return attraction of a node at a gap [Pa]
  [[nodiscard]] double attraction(Eigen::Index node, double gap) const {
    const double rest = remainder(node, gap);
    return peak * rest * rest;
  }
  /// @return decrease of the attraction per gap [Pa/m], >= 0
  [[nodiscard]] double slope(Eigen::Index node, double gap) const {
    return 2.0 * peak / range(node) * remainder(node, gap);
  }

 private:
  [[nodiscard]] double remainder(Eigen::Index node, double gap) const {
    return std::clamp(1.0 - gap / range(node), 0.0, 1.0);
  }
};

/// @brief Works of the law at the two edges of a contact [J/m^2].
struct WorksAtEdges {
  double opening;  ///< at the trailing edge, which opens
  double closing;  ///< at the leading edge, which closes
};

/// @brief Attraction between two bodies, from which a law follows for every mesh.
struct Attraction {
  double work;             ///< smallest work of adhesion [J/m^2], > 0
  double modulus;          ///< relaxed plane-strain modulus E* of both surfaces together [Pa], > 0
  double cohesive_length;  ///< E* work / strength^2 [m]; 0 if the strength is unbounded
  double equivalent_load;  ///< load without adhesion at which the contact has about the same size [N], > 0
  double spacing;          ///< largest distance between neighboring nodes [m]
  Eigen::ArrayXd x;        ///< position of every node along the path, positive ahead [m]
  Eigen::ArrayXd z;        ///< position of every node across the path [m]
  Eigen::ArrayXd area;     ///< area of the patch of every node [m^2]; in line contact its length [m]
  /// Works of a law with a peak [Pa] at an edge whose normal moves with a fraction of the rolling speed, in [0, 1].
  std::function<WorksAtEdges(double peak, double fraction)> works;

  /// @return shortest cohesive length that the mesh resolves, or that of the material if it is longer [m]
  [[nodiscard]] double resolved_length() const;
  /// @return peak of a law with a cohesive length [Pa]
  [[nodiscard]] double peak_of(double length) const;
  /// @brief Law of a cohesive length, whose nodes ahead of the center of the contact have the work of the closing edge.
  /// @param[in] length cohesive length [m]
  /// @param[in] center position of the center of the contact along the path [m]
  [[nodiscard]] TractionLaw law(double length, double center) const;
};

}  // namespace viscoroll::detail
