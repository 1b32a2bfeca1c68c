#include "transient/mirrored_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr std::array kEntriesInUse{Entry::rr,     Entry::rphi,     Entry::rtheta,
                                   Entry::phiphi, Entry::phitheta, Entry::thetatheta};

std::vector<TableRequest> requests(Index components) {
  std::vector<TableRequest> requests;
  for (const Entry entry : kEntriesInUse) {
    if (components == 3 || entry == Entry::rr) requests.push_back({.entry = entry});
  }
  return requests;
}

/// Nodes that follow each other in a row.
struct Run {
  Index row;
  Index first;  // node of the row
  Index place;  // in the list of nodes
  Index length;
};

std::vector<Run> runs_of(const std::vector<Index>& nodes, Index half_nodes) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Index row = nodes[i] / half_nodes;
    const Index node = nodes[i] % half_nodes;
    if (!runs.empty() && runs.back().row == row && runs.back().first + runs.back().length == node) {
      ++runs.back().length;
    } else {
      runs.push_back({.row = row, .first = node, .place = static_cast<Index>(i), .length = 1});
    }
  }
  return runs;
}

/// Influence of a run of nodes on another one, from one direction to another one.
template <class Influence>
Eigen::MatrixXd projected(const Influence& influence, const Run& to, const Run& from,
                          const std::array<HalfField, 3>& displaced, const std::array<HalfField, 3>& loaded) {
  const Index half_nodes = influence.rows() / 3;
  Eigen::MatrixXd part = Eigen::MatrixXd::Zero(to.length, from.length);
  for (Index p = 0; p < 3; ++p) {
    const auto left = displaced[static_cast<std::size_t>(p)].col(to.row).segment(to.first, to.length);
    for (Index q = 0; q < 3; ++q) {
      const auto right = loaded[static_cast<std::size_t>(q)].col(from.row).segment(from.first, from.length);
      part += left.asDiagonal() *
              influence.block(p * half_nodes + to.first, q * half_nodes + from.first, to.length, from.length) *
              right.asDiagonal();
    }
  }
  return part;
}

/// The offset beyond which no value of a table is above a share of its center.
Index useful_reach(const Table& table) {
  constexpr double kNegligible = 1e-10;
  const double center = std::abs(table(0, 0));
  for (int j = table.phi_reach(); j > 0; --j) {
    for (const double value : table.row(j)) {
      if (std::abs(value) > kNegligible * center) return j;
    }
  }
  return 0;
}

}  // namespace

Eigen::ArrayXd half_weights(Index half_nodes) {
  Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(half_nodes, std::numbers::sqrt2);
  weights[0] = 1.0;
  return weights;
}

MirroredTables::MirroredTables(const CoatingSum& sum, Index components, Index half_nodes, int threads, Watch& watch)
    : components_(components), half_nodes_(half_nodes), ring_(sum.mesh().nodes_per_revolution) {
  const auto most = static_cast<int>(ring_ / 2);
  const auto aside = static_cast<int>(std::min<Index>(2 * half_nodes - 2, theta_nodes_per_revolution(sum.mesh()) / 2));
  const std::vector<Table> tables = sum.tables(requests(components), most, aside, threads, watch);
  for (const Table& table : tables) reach_ = std::max(reach_, useful_reach(table));

  const Eigen::ArrayXd weights = half_weights(half_nodes);
  const auto fill = [&](Index p, Index q, int j, Eigen::Ref<HalfField> block) {
    const SignedEntry source = entry_of(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
    const Table& table = tables[static_cast<std::size_t>(source.entry)];
    const double image = q == 2 ? -1.0 : 1.0;  // of the force on the other side
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
  const auto stack = [&](int sense) {
    HalfField blocks((reach_ + 1) * height(), height());
    for (Index j = 0; j <= reach_; ++j) {
      for (Index p = 0; p < components; ++p) {
        for (Index q = 0; q < components; ++q) {
          fill(p, q, sense * static_cast<int>(j), blocks.middleRows(j * height(), height()));
        }
      }
    }
    return blocks;
  };
  ahead_ = stack(1);
  if (components == 3) behind_ = stack(-1);
}

Eigen::MatrixXd MirroredTables::compliance(const std::vector<Index>& nodes,
                                           const std::array<HalfField, 3>& direction) const {
  const auto count = static_cast<Index>(nodes.size());
  const std::vector<Run> runs = runs_of(nodes, half_nodes_);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  for (std::size_t b = 0; b < runs.size(); ++b) {
    for (std::size_t a = b; a < runs.size() && runs[a].row - runs[b].row <= reach_; ++a) {
      const Run& to = runs[a];
      const Run& from = runs[b];
      const auto influence = block(to.row - from.row);
      auto part = matrix.block(to.place, from.place, to.length, from.length);
      if (components_ == 1) {
        part = influence.block(to.first, from.first, to.length, from.length);
        continue;
      }
      part = projected(influence, to, from, direction, direction);
    }
  }
  return matrix;
}

Eigen::MatrixXd MirroredTables::compliance(const std::vector<Index>& nodes, const std::array<HalfField, 3>& displaced,
                                           const std::array<HalfField, 3>& loaded) const {
  const auto count = static_cast<Index>(nodes.size());
  const std::vector<Run> runs = runs_of(nodes, half_nodes_);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  for (const Run& from : runs) {
    for (const Run& to : runs) {
      if (std::abs(to.row - from.row) > reach_) continue;
      matrix.block(to.place, from.place, to.length, from.length) =
          projected(block(to.row - from.row), to, from, displaced, loaded);
    }
  }
  return matrix;
}

void MirroredTables::add(const HalfField& loads, Index first, Index last, Index shift, Index reach,
                         HalfField& result) const {
  const Index count = last - first + 1;
  if (count <= 0) return;
  // Of r alone, the nodes beside the loaded ones are left out of the product.
  const auto sources = loads.middleCols(first, count);
  Index width = height();
  while (components_ == 1 && width > 1 && (sources.row(width - 1).array() == 0.0).all()) --width;
  const auto product = [&](const HalfField& stack) -> HalfField {
    return stack.topLeftCorner((reach + 1) * height(), width) * sources.topRows(width);
  };
  const HalfField forward = product(ahead_);
  const HalfField backward = components_ == 1 ? HalfField() : product(behind_);
  const HalfField& other = components_ == 1 ? forward : backward;
  for (Index source = 0; source < count; ++source) {
    const Index place = first + source + shift;
    const Index up = std::min(reach, result.cols() - 1 - place);
    for (Index j = 0; j <= up; ++j) {
      result.col(place + j) += forward.block(j * height(), source, height(), 1);
    }
    // Half way around the ring both offsets are the same one.
    const Index down = std::min({reach, place, ring_ % 2 == 0 ? ring_ / 2 - 1 : reach});
    for (Index j = 1; j <= down; ++j) {
      result.col(place - j) += other.block(j * height(), source, height(), 1);
    }
  }
}

HalfField MirroredTables::displacement(const HalfField& loads, Index first, Index last) const {
  HalfField result = HalfField::Zero(height(), loads.cols());
  add(loads, first, last, 0, std::min(reach_, std::max(last, loads.cols() - 1 - first)), result);
  return result;
}

HalfField MirroredTables::displacement_in_reach(const HalfField& loads, Index first, Index last) const {
  HalfField result = HalfField::Zero(height(), loads.cols() + 2 * reach_);
  add(loads, first, last, reach_, reach_, result);
  return result;
}

}  // namespace viscoroll::detail
