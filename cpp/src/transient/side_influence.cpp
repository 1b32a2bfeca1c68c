#include "transient/side_influence.hpp"

#include "base/dense_products.hpp"
#include "influence/tread_weights.hpp"

namespace viscoroll::detail {

using Eigen::Index;
using Eigen::MatrixXd;

HalfField side_influence(const SampledDifference& difference, const SideFactors& factors, const RowShape& shape,
                         double column_distance) {
  const TreadColumns columns{.first = 0, .spacing = column_distance};
  const Index lines = difference.z.size();
  const Index height = shape.components * shape.half_nodes;
  const Eigen::VectorXd weights = half_weights(shape.half_nodes);
  MatrixXd gathered = MatrixXd::Zero(difference.amplitudes(), height);
  MatrixXd read = gathered;
  for (Index p = 0; p < shape.components; ++p) {
    const auto of_component = [&](MatrixXd& shares) {
      return shares.block(p * lines, p * shape.half_nodes, lines, shape.half_nodes);
    };
    const bool odd = p == 2;
    of_component(gathered) = patch_mean_weights(difference.z, columns, shape.half_nodes, odd) * weights.asDiagonal();
    of_component(read) = node_weights(difference.z, columns, shape.half_nodes, odd) * weights.asDiagonal();
  }
  const Index offsets = factors.phi_reach + 1;
  const Eigen::MatrixXcd ahead = factors.values.bottomRows(offsets);
  const Eigen::MatrixXcd& samples = difference.parts[kEvenPart];
  const MatrixXd tables = product(MatrixXd(ahead.real()), MatrixXd(samples.real())) -
                          product(MatrixXd(ahead.imag()), MatrixXd(samples.imag()));
  HalfField influence(offsets * height, height);
  for (Index j = 0; j < offsets; ++j) {
    const MatrixXd of_lines = tables.row(j).reshaped(difference.amplitudes(), difference.amplitudes());
    influence.middleRows(j * height, height) = 0.5 * (product(read.transpose(), product(of_lines, gathered)) +
                                                      product(gathered.transpose(), product(of_lines, read)));
  }
  return influence;
}

}  // namespace viscoroll::detail
