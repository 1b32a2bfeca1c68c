#include "influence/band_waves.hpp"

#include <algorithm>

namespace viscoroll::detail {
namespace {

double end_of(const OrderBand& band) { return band.orders[band.orders.size() - 1]; }

/// Number of long bands that saves most multiplications. The last band, which may be truncated, and bands that do not
/// reach all offsets are excluded: their sums are not smooth over all offsets.
std::size_t count_long(const std::vector<OrderBand>& bands, double spacing, int reach) {
  std::size_t best = 0;
  double max_saved = 0.0;
  double orders = 0.0;
  for (std::size_t i = 0; i + 1 < bands.size() && bands[i].reach >= reach; ++i) {
    orders += static_cast<double>(bands[i].orders.size());
    const double few = SampledOffsets::count(reach, spacing, end_of(bands[i]));
    const double saved = orders * (reach + 1.0 - few) - few * (reach + 1.0);
    if (saved <= max_saved) continue;
    max_saved = saved;
    best = i + 1;
  }
  return best;
}

}  // namespace

BandWaves::BandWaves(const std::vector<OrderBand>& bands, double spacing, int reach)
    : long_(count_long(bands, spacing, reach)) {
  if (long_ > 0) offsets_.emplace(reach, spacing, end_of(bands[long_ - 1]));
  for (const OrderBand& band : bands) {
    const bool is_long = waves_.size() < long_;
    waves_.push_back(is_long ? make_waves(band.orders, offsets_->sampled)
                             : make_waves(band.orders, spacing, std::min(band.reach, reach)));
  }
}

}  // namespace viscoroll::detail
