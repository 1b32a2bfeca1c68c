/// @file
/// @brief Attraction between two surfaces across their gap: hard wall and cubic potential. See docs/theory/adhesion.md.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <limits>

namespace viscoroll::detail {

/// Spacings per cohesive zone, which is 2.495 E* w / peak^2 long at an elastic edge. With 7.5 or more, the solution
/// does not depend on the path of loads (docs/theory/adhesion.md). Newton's method needs more: with 10, it fails for an
/// elastic roller on the path to the largest tension.
inline constexpr double kSpacingsPerZone = 12.5;

/// @brief Attraction sigma = peak (1 - g / range)^2 at the gap g, which ends at the range 3 work / peak, above a hard
/// wall at g = 0. It is a function of the gap alone. A closed gap has the attraction of g = 0.
struct TractionLaw {
  Eigen::ArrayXd peak;  ///< attraction of every node at g = 0 [Pa], > 0
  Eigen::ArrayXd work;  ///< work of separation of every node [J/m^2], > 0

  /// @return gap at which the attraction of a node ends [m]
  [[nodiscard]] double range(Eigen::Index node) const { return 3.0 * work[node] / peak[node]; }
  /// @return attraction of a node at a gap [Pa]
  [[nodiscard]] double attraction(Eigen::Index node, double gap) const {
    const double rest = remainder(node, gap);
    return peak[node] * rest * rest;
  }
  /// @return decrease of the attraction per gap [Pa/m], >= 0
  [[nodiscard]] double slope(Eigen::Index node, double gap) const {
    return 2.0 * peak[node] / range(node) * remainder(node, gap);
  }
  /// @return work that separates a node from a gap [J/m^2]
  [[nodiscard]] double remaining_work(Eigen::Index node, double gap) const {
    const double rest = remainder(node, gap);
    return work[node] * rest * rest * rest;
  }

 private:
  [[nodiscard]] double remainder(Eigen::Index node, double gap) const {
    return std::clamp(1.0 - gap / range(node), 0.0, 1.0);
  }
};

/// @brief Law of a mesh at one edge of a contact.
struct EdgeLaw {
  double peak;  ///< [Pa], > 0
  double work;  ///< [J/m^2], > 0
};

/// @brief Laws of a mesh at the two edges of a contact.
struct EdgeLaws {
  EdgeLaw opening;  ///< at the trailing edge, which opens
  EdgeLaw closing;  ///< at the leading edge, which closes
};

/// @brief Size of a contact with adhesion, on which the pressure near its edges depends.
struct ContactSize {
  double center = 0.0;                                           ///< position of its center along the path [m]
  double half_length = std::numeric_limits<double>::infinity();  ///< half of its length along the path [m]
  double pressure = 0.0;                                         ///< pressure at its center [Pa]
};

/// @brief Attraction between two bodies, from which a law follows for every mesh.
struct Attraction {
  double equivalent_load;  ///< load without adhesion at which the contact has about the same size [N], > 0
  double spacing;          ///< largest distance between neighboring nodes [m]
  double shortest_zone;    ///< length to which cohesive zones are shortened, unless the mesh is too coarse [m]
  Eigen::ArrayXd x;        ///< position of every node along the path, positive ahead [m]
  Eigen::ArrayXd z;        ///< position of every node across the path [m]
  Eigen::ArrayXd area;     ///< area of the patch of every node [m^2]; in line contact its length [m]
  /// Laws whose cohesive zones have a length [m], or that of the surfaces if it is longer, at an edge whose normal
  /// moves with a fraction of the rolling speed, in [0, 1].
  std::function<EdgeLaws(double zone, double fraction, const ContactSize& contact)> laws;

  /// @return length of the cohesive zones: the wanted one, or the shortest that the mesh resolves [m]
  [[nodiscard]] double resolved_zone() const;
  /// @brief Law whose nodes ahead of the center of the contact are those of the closing edge.
  /// @param[in] zone length of the cohesive zones [m]
  /// @param[in] contact size of the contact
  [[nodiscard]] TractionLaw law(double zone, const ContactSize& contact) const;
};

}  // namespace viscoroll::detail
