#include "creep/mirrored_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/dense_products.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr Index kPhi = 1;  // component whose sign depends on the sense of phi

/// Multiplications between two checkpoints; they take some tens of milliseconds.
constexpr Index kAtOnce = 100'000'000;

constexpr std::array kEntriesInUse{Entry::rr,     Entry::rphi,     Entry::rtheta,
                                   Entry::phiphi, Entry::phitheta, Entry::thetatheta};

std::vector<TableRequest> requests(Index components) {
  std::vector<TableRequest> requests;
  for (const Entry entry : kEntriesInUse) {
    if (components == 3 || entry == Entry::rr) requests.push_back({.entry = entry});
  }
  return requests;
}

/// Offset beyond which all values are negligible relative to the sum of the center values of all tables.
Index useful_reach(const std::vector<std::vector<Table>>& tables) {
  constexpr double kNegligible = 1e-10;
  std::vector<double> centers(tables.front().size());
  for (const auto& of_sum : tables) {
    for (std::size_t e = 0; e < centers.size(); ++e) centers[e] += of_sum[e](0, 0);
  }
  Index reach = 0;
  for (const auto& of_sum : tables) {
    for (std::size_t e = 0; e < centers.size(); ++e) {
      const auto matters = [&](double value) { return std::abs(value) > kNegligible * std::abs(centers[e]); };
      int j = of_sum[e].phi_reach();
      while (j > reach && std::ranges::none_of(of_sum[e].row(j), matters)) --j;
      reach = std::max<Index>(reach, j);
    }
  }
  return reach;
}

std::vector<Table> summed(const TableSum& sum, const RowShape& shape, int threads, Watch& watch) {
  const auto aside = static_cast<int>(2 * shape.half_nodes - 2);
  return sum.tables(requests(shape.components), static_cast<int>(shape.most), aside, threads, watch);
}

}  // namespace

Eigen::ArrayXd half_weights(Index half_nodes) {
  Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(half_nodes, std::numbers::sqrt2);
  weights[0] = 1.0;
  return weights;
}

MirroredTables::MirroredTables(const TableSum& sum, const RowShape& shape, int threads, Watch& watch) {
  const std::vector<std::vector<Table>> tables{summed(sum, shape, threads, watch)};
  *this = MirroredTables(tables.front(), shape, extent_of(tables, shape), watch);
}

std::vector<MirroredTables> MirroredTables::of_all(const std::vector<std::unique_ptr<const TableSum>>& sums,
                                                   const RowShape& shape, int threads, Watch& watch) {
  std::vector<std::vector<Table>> tables;
  tables.reserve(sums.size());
  for (const auto& sum : sums) tables.push_back(summed(*sum, shape, threads, watch));
  const Extent extent = extent_of(tables, shape);
  std::vector<MirroredTables> mirrored;
  mirrored.reserve(sums.size());
  for (const auto& of_sum : tables) mirrored.push_back(MirroredTables(of_sum, shape, extent, watch));
  return mirrored;
}

MirroredTables MirroredTables::sum_of(std::span<const MirroredTables> tables, std::span<const double> factors,
                                      const std::function<void()>& checkpoint) {
  MirroredTables sum = tables.front();
  for (Index column = 0; column < sum.ahead_.cols(); ++column) {
    checkpoint();
    sum.ahead_.col(column) *= factors.front();
    for (std::size_t i = 1; i < tables.size(); ++i) sum.ahead_.col(column) += factors[i] * tables[i].ahead_.col(column);
  }
  return sum;
}

MirroredTables::Extent MirroredTables::extent_of(const std::vector<std::vector<Table>>& tables, const RowShape& shape) {
  constexpr double kLeft = 1e-6;  // too small to affect moments
  double center = 0.0;
  double end = 0.0;
  for (const auto& of_sum : tables) {
    const Table& radial = of_sum.front();
    center += radial(0, 0);
    end += radial(radial.phi_reach(), 0);
  }
  return {.reach = useful_reach(tables), .dies_out = shape.ring || std::abs(end) < kLeft * center};
}

MirroredTables::MirroredTables(const std::vector<Table>& tables, const RowShape& shape, const Extent& extent,
                               Watch& watch)
    : shape_(shape), extent_(extent) {
  const Index half_nodes = shape.half_nodes;
  const Eigen::ArrayXd weights = half_weights(half_nodes);
  const auto fill = [&](Index p, Index q, int j, Eigen::Ref<HalfField> block) {
    const SignedEntry source = entry_of(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
    const Table& table = tables[static_cast<std::size_t>(source.entry)];
    const double image = q == 2 ? -1.0 : 1.0;  // sign of the force on the other side
    for (Index k = 0; k < half_nodes; ++k) {
      for (Index from = 0; from < half_nodes; ++from) {
        const auto near = static_cast<int>(k - from);
        const auto far = static_cast<int>(k + from);
        double value = table(j, near);
        if (from > 0) value += image * table(j, far);
        if (from == 0 && q == 2) value = 0.0;
        block(p * half_nodes + k, q * half_nodes + from) = source.sign * value * weights[k] / weights[from];
      }
    }
  };
  ahead_.resize((extent_.reach + 1) * height(), height());
  for (Index j = 0; j <= extent_.reach; ++j) {
    watch.poll("mirroring tables", static_cast<double>(j) / static_cast<double>(extent_.reach + 1));
    for (Index p = 0; p < components(); ++p) {
      for (Index q = 0; q < components(); ++q)
        fill(p, q, static_cast<int>(j), ahead_.middleRows(j * height(), height()));
    }
  }
}

Eigen::Matrix3d MirroredTables::influence(Index displaced, Index loaded) const {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  const Index offset = displaced / half_nodes() - loaded / half_nodes();
  if (std::abs(offset) > extent_.reach) return matrix;
  const double* const first = &ahead_(std::abs(offset) * height() + displaced % half_nodes(), loaded % half_nodes());
  for (Index q = 0; q < components(); ++q) {
    for (Index p = 0; p < components(); ++p) {
      const bool is_reversed = offset < 0 && (p == kPhi) != (q == kPhi);
      const double value = first[half_nodes() * (p + q * ahead_.rows())];
      matrix(p, q) = is_reversed ? -value : value;
    }
  }
  return matrix;
}

Eigen::MatrixXd MirroredTables::compliance(const std::vector<Index>& displaced,
                                           const std::vector<Index>& loaded) const {
  Eigen::MatrixXd matrix(components() * static_cast<Index>(displaced.size()),
                         components() * static_cast<Index>(loaded.size()));
  for (std::size_t j = 0; j < loaded.size(); ++j) {
    for (std::size_t i = 0; i < displaced.size(); ++i) {
      matrix.block(components() * static_cast<Index>(i), components() * static_cast<Index>(j), components(),
                   components()) = influence(displaced[i], loaded[j]).topLeftCorner(components(), components());
    }
  }
  return matrix;
}

Eigen::MatrixXd MirroredTables::compliance(const std::vector<Index>& displaced, const std::vector<Index>& loaded,
                                           const std::array<HalfField, 3>& direction) const {
  Eigen::MatrixXd matrix(displaced.size(), loaded.size());
  if (components() == 1) {
    struct Place {
      Index row;
      Index node;
    };
    const auto place_of = [&](Index node) { return Place{.row = node / half_nodes(), .node = node % half_nodes()}; };
    std::vector<Place> places(displaced.size());
    std::ranges::transform(displaced, places.begin(), place_of);
    for (Index j = 0; j < matrix.cols(); ++j) {
      const auto [row, node] = place_of(loaded[static_cast<std::size_t>(j)]);
      const auto column = ahead_.col(node);
      for (Index i = 0; i < matrix.rows(); ++i) {
        const Place& place = places[static_cast<std::size_t>(i)];
        const Index offset = std::abs(place.row - row);
        matrix(i, j) = offset > extent_.reach ? 0.0 : column[offset * height() + place.node];
      }
    }
    return matrix;
  }
  const auto along = [&](const std::vector<Index>& nodes) {
    Eigen::Matrix3Xd components(3, static_cast<Index>(nodes.size()));
    for (Index p = 0; p < 3; ++p) {
      components.row(p) = direction[static_cast<std::size_t>(p)].reshaped()(nodes).transpose();
    }
    return components;
  };
  const Eigen::Matrix3Xd moved = along(displaced);
  const Eigen::Matrix3Xd pressed = along(loaded);
  for (Index j = 0; j < matrix.cols(); ++j) {
    for (Index i = 0; i < matrix.rows(); ++i) {
      const auto between = influence(displaced[static_cast<std::size_t>(i)], loaded[static_cast<std::size_t>(j)]);
      matrix(i, j) = moved.col(i).dot(between * pressed.col(j));
    }
  }
  return matrix;
}

void MirroredTables::add(const HalfField& loads, Index first, Index last, const Frame& frame, const Offsets& offsets,
                         HalfField& result) const {
  const auto [shift, reach] = frame;
  const Index count = last - first + 1;
  // The product leaves out the nodes beside the loaded ones.
  const auto sources = loads.middleCols(first, count);
  const auto is_loaded = [&](Index node) {
    for (Index p = 0; p < components(); ++p) {
      if ((sources.row(p * half_nodes() + node).array() != 0.0).any()) return true;
    }
    return false;
  };
  Index width = half_nodes();
  while (width > 1 && !is_loaded(width - 1)) --width;
  const auto add_influence = [&](Index component, HalfField& displaced) {
    const Index start = component * half_nodes();
    add_product(ahead_.block(offsets.first * height(), start, displaced.rows(), width),
                sources.middleRows(start, width), displaced);
  };
  HalfField forward = HalfField::Zero(offsets.count * height(), count);
  for (Index q = 0; q < components(); ++q) {
    if (q != kPhi) add_influence(q, forward);
  }
  HalfField backward;
  if (components() == 3) {
    HalfField along = HalfField::Zero(forward.rows(), count);
    add_influence(kPhi, along);
    backward = forward - along;
    for (Index j = 0; j < offsets.count; ++j) backward.middleRows(j * height() + half_nodes(), half_nodes()) *= -1.0;
    forward += along;
  }
  const HalfField& other = components() == 1 ? forward : backward;
  for (Index source = 0; source < count; ++source) {
    const Index place = first + source + shift;
    const Index up = std::min(reach, result.cols() - 1 - place);
    for (Index j = offsets.first; j <= std::min(up, offsets.first + offsets.count - 1); ++j) {
      result.col(place + j) += forward.block((j - offsets.first) * height(), source, height(), 1);
    }
    // Half way around the ring both offsets are the same.
    const Index down = std::min({reach, place, shape_.ring && *shape_.ring % 2 == 0 ? *shape_.ring / 2 - 1 : reach});
    for (Index j = std::max<Index>(1, offsets.first); j <= std::min(down, offsets.first + offsets.count - 1); ++j) {
      result.col(place - j) += other.block((j - offsets.first) * height(), source, height(), 1);
    }
  }
}

HalfField MirroredTables::displaced(const HalfField& loads, Index first, Index last, const Frame& frame,
                                    const std::function<void()>& checkpoint) const {
  constexpr Index kRowsTogether = 64;  // rows, for fast products and intermediate fields of moderate size
  const Index offsets = std::max<Index>(1, kAtOnce / (kRowsTogether * height() * height()));
  HalfField result = HalfField::Zero(height(), loads.cols() + 2 * frame.shift);
  for (Index row = first; row <= last; row += kRowsTogether) {
    for (Index offset = 0; offset <= frame.reach; offset += offsets) {
      checkpoint();
      add(loads, row, std::min(row + kRowsTogether - 1, last), frame,
          {.first = offset, .count = std::min(offsets, frame.reach + 1 - offset)}, result);
    }
  }
  return result;
}

HalfField MirroredTables::displacement(const HalfField& loads, Index first, Index last,
                                       const std::function<void()>& checkpoint) const {
  const Index needed = std::max(last, loads.cols() - 1 - first);
  return displaced(loads, first, last, {.shift = 0, .reach = std::min(extent_.reach, needed)}, checkpoint);
}

HalfField MirroredTables::displacement_in_reach(const HalfField& loads, Index first, Index last,
                                                const std::function<void()>& checkpoint) const {
  return displaced(loads, first, last, {.shift = extent_.reach, .reach = extent_.reach}, checkpoint);
}

}  // namespace viscoroll::detail
