#include "contact/dense_lu.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

namespace viscoroll::detail {

Eigen::MatrixXd solve_dense(Eigen::MatrixXd matrix, Eigen::MatrixXd right_sides, int threads, Watch& watch) {
  constexpr Eigen::Index kBlock = 96;    // rows eliminated at a time: a block of pivots stays in the L2 cache
  constexpr Eigen::Index kStripe = 128;  // columns that a thread takes at a time
  const Eigen::Index size = matrix.rows();

  for (Eigen::Index start = 0; start < size; start += kBlock) {
    const Eigen::Index block = std::min(kBlock, size - start);
    const Eigen::Index rest = size - start - block;
    const Eigen::PartialPivLU<Eigen::MatrixXd> pivots(matrix.block(start, start, block, block));
    const auto below = matrix.block(start + block, start, rest, block);

    const auto eliminate = [&](auto&& row, auto&& remainder) {
      row = pivots.solve(row).eval();
      remainder.noalias() -= below * row;
    };
    eliminate(right_sides.middleRows(start, block), right_sides.bottomRows(rest));
    const auto stripes = static_cast<std::size_t>((rest + kStripe - 1) / kStripe);
    parallel_for(stripes, threads, watch, "solving the contact equations", [&](std::size_t stripe, const Worker&) {
      const Eigen::Index first = start + block + static_cast<Eigen::Index>(stripe) * kStripe;
      const Eigen::Index width = std::min(kStripe, size - first);
      eliminate(matrix.block(start, first, block, width), matrix.block(start + block, first, rest, width));
    });
  }

  // Each block row now reads x_block = b_block - A_right x_right.
  for (Eigen::Index start = (size - 1) / kBlock * kBlock; start >= 0; start -= kBlock) {
    const Eigen::Index block = std::min(kBlock, size - start);
    const Eigen::Index rest = size - start - block;
    right_sides.middleRows(start, block).noalias() -=
        matrix.block(start, start + block, block, rest) * right_sides.bottomRows(rest);
  }
  return right_sides;
}

}  // namespace viscoroll::detail
