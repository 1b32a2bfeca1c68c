#include "influence/convolution.hpp"

#include <algorithm>
#include <cstdlib>

namespace viscoroll::detail {
namespace {

/// Offset of a place on a circle, at most half of it.
int offset(int place, int length) { return place <= length / 2 ? place : place - length; }

}  // namespace

Convolution::Convolution(WindowShape shape, const std::vector<Table>& tables, const std::vector<ConvolutionTerm>& terms,
                         int threads, Watch& watch)
    : product_(shape, doubled(shape)), spectra_(tables.size()) {
  const WindowShape period = product_.period();
  for (const ConvolutionTerm& term : terms) {
    ComplexBuffer& spectrum = spectra_[term.table];
    const Table& table = tables[term.table];
    const auto value = [&](int row, int column) {
      const int j = offset(row, period.phi_nodes);
      const int l = offset(column, period.theta_nodes);
      return std::abs(j) < shape.phi_nodes && std::abs(l) < shape.theta_nodes ? table(j, l) : 0.0;
    };
    if (spectrum.empty()) spectrum = product_.spectrum(value, threads, watch);
    terms_.push_back({term.result, &spectrum, term.operand, term.sign});
    fields_ = std::max(fields_, term.operand + 1);
    results_ = std::max(results_, term.result + 1);
  }
}

}  // namespace viscoroll::detail
