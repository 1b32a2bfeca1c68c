#include "influence/synthesis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "influence/fft.hpp"
#include "influence/patch.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// A request with its weights. A coefficient is even or odd in n, by its entry and by its patches.
struct Kernel {
  TableRequest request;
  bool odd;
  cplx phase;              // i^(receiver degree - source degree)
  Eigen::ArrayXd weights;  // along theta, for n >= 0
};

Kernel make_kernel(const TableRequest& request, const Mesh& mesh) {
  const double half_width = std::numbers::pi / mesh.nodes_per_revolution;
  const int receiver_shape = request.power ? request.receiver_shape : 0;
  constexpr std::array<cplx, 4> kPowersOfI{cplx(1, 0), cplx(0, 1), cplx(-1, 0), cplx(0, -1)};
  Kernel kernel{.request = request,
                .odd = is_odd(request.entry) != ((request.source_shape + receiver_shape) % 2 == 1),
                .phase = kPowersOfI[static_cast<std::size_t>(receiver_shape - request.source_shape + 4) % 4],
                .weights = Eigen::ArrayXd(mesh.max_order + 1)};
  for (int n = 0; n <= mesh.max_order; ++n) {
    kernel.weights[n] = spherical_bessel(request.source_shape, n * half_width);
    if (request.power) kernel.weights[n] *= spherical_bessel(receiver_shape, n * half_width);
  }
  return kernel;
}

/// Weight of order m of a kernel along phi, and the scale of the whole sum.
cplx phi_weight(const Kernel& kernel, int m, const Mesh& mesh, double outer_radius) {
  const double circumference = 2.0 * std::numbers::pi * outer_radius;
  const double patch = sinc(m * std::numbers::pi / mesh.nodes_per_revolution);
  const cplx weight = kernel.request.power ? cplx(0.0, m) * patch * patch : cplx(patch);
  return weight * kernel.phase / (circumference * circumference);
}

/// Sum of the coefficients of n >= 0 and their mirror images that a mesh of `length` nodes cannot tell from order q,
/// for q in [0, length / 2].
void fold(const Eigen::ArrayXcd& values, const Kernel& kernel, int length, Eigen::ArrayXcd& folded) {
  folded.setZero();
  const double mirror = kernel.odd ? -1.0 : 1.0;
  const int half = length / 2;
  int rest = 0;  // n modulo length
  for (Eigen::Index n = 0; n < values.size(); ++n) {
    if (rest <= half) {
      folded[rest] += kernel.weights[n] * values[n];
    } else {
      folded[length - rest] += mirror * kernel.weights[n] * values[n];
    }
    if (++rest == length) rest = 0;
  }
  // These orders are their own mirror images.
  const cplx center = kernel.weights[0] * values[0];
  folded[0] = center + (1.0 + mirror) * (folded[0] - center);
  if (length % 2 == 0) folded[half] *= 1.0 + mirror;
}

/// Buffers of one thread.
struct Workspace {
  OrderSeries series;
  std::array<Eigen::ArrayXcd, kEntries> values;
  std::vector<Eigen::ArrayXcd> sums;  // of each kernel, over the orders m that fold together
  Eigen::ArrayXcd folded;
  ComplexBuffer line;
};

class Synthesis {
 public:
  Synthesis(const Spectrum& spectrum, double outer_radius, const Mesh& mesh, const std::vector<TableRequest>& requests,
            int theta_reach)
      : spectrum_(spectrum),
        outer_radius_(outer_radius),
        mesh_(mesh),
        half_(mesh.nodes_per_revolution / 2),
        theta_reach_(theta_reach),
        theta_fft_(mesh.nodes_per_revolution) {
    for (const TableRequest& request : requests) kernels_.push_back(make_kernel(request, mesh));
    half_spectra_.resize(kernels_.size() * static_cast<std::size_t>(theta_reach + 1) *
                         static_cast<std::size_t>(half_ + 1));
  }

  [[nodiscard]] Workspace make_workspace() const {
    Workspace work;
    work.values.fill(Eigen::ArrayXcd(mesh_.max_order + 1));
    work.sums.assign(kernels_.size(), Eigen::ArrayXcd(half_ + 1));
    work.folded.resize(half_ + 1);
    work.line.resize(static_cast<std::size_t>(mesh_.nodes_per_revolution));
    return work;
  }

  /// Sum every order that the mesh cannot tell from m = p, along theta.
  void sum_along_theta(int p, Workspace& work, const Worker& worker) {
    for (auto& sum : work.sums) sum.setZero();
    const int length = mesh_.nodes_per_revolution;
    const bool own_mirror = 2 * p % length == 0;
    for (int m = p; m <= mesh_.max_order; m += length) {
      add_order(m, true, own_mirror && m > 0, work);
      worker.checkpoint();
    }
    for (int m = length - p; m <= mesh_.max_order && !own_mirror; m += length) {
      add_order(m, false, true, work);
      worker.checkpoint();
    }
    for (std::size_t k = 0; k < kernels_.size(); ++k) transform(k, p, work);
  }

  /// The table of kernel k, summed along phi.
  [[nodiscard]] Table table(std::size_t k, int phi_reach) const {
    const int length = mesh_.nodes_per_revolution;
    const RealFft phi_fft(1, length);
    ComplexBuffer spectrum(phi_fft.spectrum_size());
    RealBuffer line(phi_fft.real_size());
    Table table(phi_reach, theta_reach_);
    const double mirror = kernels_[k].odd ? -1.0 : 1.0;
    for (int l = 0; l <= theta_reach_; ++l) {
      std::copy_n(half_spectra_.begin() + static_cast<std::ptrdiff_t>(offset(k, l)), half_ + 1, spectrum.begin());
      phi_fft.backward(spectrum, line);
      for (int j = -phi_reach; j <= phi_reach; ++j) {
        const double value = line[static_cast<std::size_t>((j + length) % length)];
        table(j, -l) = mirror * value;
        table(j, l) = value;
      }
    }
    return table;
  }

 private:
  [[nodiscard]] std::size_t offset(std::size_t k, int l) const {
    const auto lines = static_cast<std::size_t>(theta_reach_ + 1);
    return (k * lines + static_cast<std::size_t>(l)) * static_cast<std::size_t>(half_ + 1);
  }

  /// Add order m, its mirror image -m, or both, to the sums. The coefficient of (-m, n) is the conjugate of (m, -n).
  void add_order(int m, bool itself, bool image, Workspace& work) const {
    spectrum_.series(m, work.series);
    std::array<bool, kEntries> evaluated{};
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      const auto entry = static_cast<std::size_t>(kernels_[k].request.entry);
      if (!evaluated[entry]) evaluate(m, kernels_[k].request.entry, work.series, work.values[entry]);
      evaluated[entry] = true;
      fold(work.values[entry], kernels_[k], mesh_.nodes_per_revolution, work.folded);
      work.folded *= phi_weight(kernels_[k], m, mesh_, outer_radius_);
      if (itself) work.sums[k] += work.folded;
      if (image) work.sums[k] += (kernels_[k].odd ? -1.0 : 1.0) * work.folded.conjugate();
    }
  }

  /// Transform the sum of kernel k along theta and keep the offsets that are wanted.
  void transform(std::size_t k, int p, Workspace& work) {
    const int length = mesh_.nodes_per_revolution;
    const double mirror = kernels_[k].odd ? -1.0 : 1.0;
    for (int q = 0; q <= half_; ++q) {
      work.line[static_cast<std::size_t>(q)] = work.sums[k][q];
      if (q > 0 && q < length - q) work.line[static_cast<std::size_t>(length - q)] = mirror * work.sums[k][q];
    }
    theta_fft_.execute(work.line);
    for (int l = 0; l <= theta_reach_; ++l) {
      half_spectra_[offset(k, l) + static_cast<std::size_t>(p)] = work.line[static_cast<std::size_t>(l)];
    }
  }

  const Spectrum& spectrum_;
  double outer_radius_;
  Mesh mesh_;
  int half_;
  int theta_reach_;
  ComplexBackwardFft theta_fft_;
  std::vector<Kernel> kernels_;
  std::vector<cplx> half_spectra_;  // [kernel][l][folded m]
};

}  // namespace

std::vector<Table> synthesize(const Spectrum& spectrum, double outer_radius, const Mesh& mesh,
                              const std::vector<TableRequest>& requests, int phi_reach, int theta_reach, int threads,
                              Watch& watch) {
  Synthesis synthesis(spectrum, outer_radius, mesh, requests, theta_reach);
  const auto folded_orders = static_cast<std::size_t>(mesh.nodes_per_revolution / 2 + 1);
  std::vector<Workspace> workspaces(worker_count(folded_orders, threads), synthesis.make_workspace());
  parallel_for(folded_orders, threads, watch, "summing orders", [&](std::size_t p, const Worker& worker) {
    synthesis.sum_along_theta(static_cast<int>(p), workspaces[worker.number], worker);
  });

  std::vector<Table> tables(requests.size(), Table(phi_reach, theta_reach));
  parallel_for(requests.size(), threads, watch, "transforming tables",
               [&](std::size_t k, const Worker&) { tables[k] = synthesis.table(k, phi_reach); });
  return tables;
}

}  // namespace viscoroll::detail
