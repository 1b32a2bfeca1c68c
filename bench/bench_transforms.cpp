// Product of a field with a spectrum on a square domain and one core, which takes most of the time of solving a fine
// contact. The error is that of a field shifted by one node in both directions.
#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "influence/spectral_product.hpp"
#include "viscoroll/observer.hpp"

namespace {

using namespace viscoroll::detail;

void transforms(benchmark::State& state, int points) {
  const WindowShape window{points / 2, points / 2};
  const SpectralProduct product(window, {points, points});
  const viscoroll::Observer nobody;
  Watch watch(nobody);
  const ComplexBuffer spectrum =
      product.spectrum([](int row, int column) { return row == 1 && column == 0 ? 1.0 : 0.0; }, false, 1, watch);
  const Eigen::ArrayXXd field = Eigen::ArrayXXd::Random(window.size(), 1);
  const std::vector<SpectralTerm> terms{{.result = 0, .spectrum = &spectrum, .operand = 0, .sign = 1.0}};
  Eigen::ArrayXXd moved;
  for (auto _ : state) moved = product.apply(field, terms, 1, 1, watch);

  const Eigen::Index step = window.theta_nodes;
  double error = 0.0;
  for (Eigen::Index node = step; node < window.size(); ++node) {
    error = std::max(error, std::abs(moved(node, 0) - field(node - step, 0)));
  }
  state.counters["error"] = error;
}

}  // namespace

int main(int argc, char** argv) {
  for (const int points : {512, 1024, 2048}) {
    const std::string name = std::string("transforms/") + VISCOROLL_FFT + "_" + std::to_string(points);
    benchmark::RegisterBenchmark(name.c_str(), transforms, points)->Unit(benchmark::kMillisecond)->UseRealTime();
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
