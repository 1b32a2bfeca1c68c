#include "influence/convolution.hpp"

#include <algorithm>

namespace viscoroll::detail {
Convolution::Convolution(WindowShape shape, const LoadedNodes& loaded, const std::vector<Table>& tables,
                         const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch)
    : product_(shape, doubled(shape, {.phi_nodes = loaded.rows, .theta_nodes = loaded.columns})),
      spectra_(tables.size()) {
  const WindowShape period = product_.period();
  // Offsets of displaced nodes from loaded nodes.
  const int farthest_downstream = shape.phi_nodes - 1 - loaded.first_row;
  const int farthest_upstream = loaded.first_row + loaded.rows - 1;
  const int farthest_aside = (shape.theta_nodes + loaded.columns) / 2 - 1;
  for (const ConvolutionTerm& term : terms) {
    ComplexBuffer& spectrum = spectra_[term.table];
    const Table& table = tables[term.table];
    const bool odd = table.mirror() < 0.0;
    const auto value = [&](int row, int column) {
      const int j = row <= farthest_downstream ? row : row - period.phi_nodes;
      return j >= -farthest_upstream && column <= farthest_aside ? table(j, column) : 0.0;
    };
    if (spectrum.empty()) spectrum = product_.spectrum(value, odd, threads, watch);
    terms_.push_back({term.result, &spectrum, term.operand, term.sign, odd});
    fields_ = std::max(fields_, term.operand + 1);
    results_ = std::max(results_, term.result + 1);
  }
}

}  // namespace viscoroll::detail
