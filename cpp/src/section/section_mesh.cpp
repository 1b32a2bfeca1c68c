#include "section/section_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace viscoroll::detail {
namespace {

using Size = std::function<double(double)>;

/// Distance of the end of an unbounded section from the width, in thicknesses. The effect of the end of a bonded tread
/// decays by e^-1.4 per thickness if the tread is incompressible, and faster otherwise; it changes the stiffness under
/// a punch by 2e-4.
constexpr double kUnboundedSectionReach = 6.0;

/// Edges of elements from `first` to `last` with about the given size.
std::vector<double> edges(double first, double last, const Size& size) {
  // The number of samples resolves the size function, also at fine ends.
  constexpr double kFewestSamples = 400.0;
  const double in_ends = 4.0 * (last - first) / std::min(size(first), size(last));
  const int samples = static_cast<int>(std::max(kFewestSamples, in_ends));
  const double step = (last - first) / samples;
  std::vector<double> elements{0.0};
  for (int i = 0; i < samples; ++i) elements.push_back(elements.back() + step / size(first + (i + 0.5) * step));
  const int count = std::max(1, static_cast<int>(std::ceil(elements.back() - 1e-9)));
  std::vector<double> result{first};
  std::size_t place = 0;
  for (int n = 1; n < count; ++n) {
    const double wanted = elements.back() * n / count;
    while (elements[place + 1] < wanted) ++place;
    const double share = (wanted - elements[place]) / (elements[place + 1] - elements[place]);
    result.push_back(first + step * (static_cast<double>(place) + share));
  }
  result.push_back(last);
  return result;
}

/// Edges and the middles between them.
Eigen::ArrayXd with_middles(const std::vector<double>& edges) {
  Eigen::ArrayXd places(2 * static_cast<Eigen::Index>(edges.size()) - 1);
  for (Eigen::Index i = 0; i < places.size(); ++i) {
    const auto left = static_cast<std::size_t>(i / 2);
    places[i] = i % 2 == 0 ? edges[left] : 0.5 * (edges[left] + edges[left + 1]);
  }
  return places;
}

/// Slope of the crown at a distance from the middle. It is limited where the crown is vertical.
double crown_slope(const CoatedWheel& wheel, double z) {
  if (std::isinf(wheel.crown_radius)) return 0.0;
  constexpr double kLeastCosine = 1e-3;
  const double sine = z / wheel.crown_radius;
  return sine / std::max(std::sqrt(1.0 - sine * sine), kLeastCosine);
}

}  // namespace

SectionMesh::SectionMesh(const CoatedWheel& wheel, SectionEnd end, const SectionFineness& fineness) {
  const double thickness = coating_thickness(wheel);
  const double half = 0.5 * wheel.width;
  const double unit = std::min(thickness, wheel.width);
  const auto away = [&](double distance) { return unit * (fineness.finest + fineness.growth * distance / unit); };
  const double largest = fineness.largest * thickness;
  const double widest = std::min(std::max(largest, fineness.widest * wheel.width), 0.25 * half);

  std::vector<double> across = edges(0.0, half, [&](double z) { return std::min(away(half - z), widest); });
  loaded_lines_ = 2 * across.size() - 1;
  if (end == SectionEnd::unbounded) {
    const std::vector<double> beyond = edges(half, half + kUnboundedSectionReach * thickness,
                                             [&](double z) { return std::min(away(z - half), thickness); });
    across.insert(across.end(), beyond.begin() + 1, beyond.end());
  }
  z_ = with_middles(across);

  std::vector<double> radii{wheel.core_radius};
  const double surface = wheel.core_radius + thickness;
  for (std::size_t l = 0; l < wheel.layers.size(); ++l) {
    const double inner = radii.back();
    const double outer = l + 1 == wheel.layers.size() ? surface : inner + wheel.layers[l].thickness;
    const std::vector<double> layer = edges(
        inner, outer, [&](double r) { return std::min({away(surface - r), away(r - wheel.core_radius), largest}); });
    radii.insert(radii.end(), layer.begin() + 1, layer.end());
    layer_of_row_.insert(layer_of_row_.end(), layer.size() - 1, l);
  }
  const Eigen::ArrayXd straight = with_middles(radii);
  r_ = straight.replicate(1, z_.size());
  slope_.resize(z_.size());
  const double outermost = wheel.layers.back().thickness;
  const Eigen::ArrayXd falls = wheel.hub == Hub::crowned
                                   ? Eigen::ArrayXd::Ones(straight.size())
                                   : Eigen::ArrayXd(((straight - surface) / outermost + 1.0).max(0.0));
  for (Eigen::Index i = 0; i < z_.size(); ++i) {
    r_.col(i) -= falls * crown_drop(wheel, z_[i]);
    slope_[i] = crown_slope(wheel, z_[i]);
  }
}

}  // namespace viscoroll::detail
