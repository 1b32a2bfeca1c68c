#include "influence/fft.hpp"

#include <fftw3.h>

#include <cassert>
#include <mutex>
#include <stdexcept>
#include <type_traits>

namespace viscoroll::detail {
namespace {

std::mutex& planner_mutex() {
  static std::mutex mutex;
  return mutex;
}

struct PlanDeleter {
  void operator()(fftw_plan plan) const {
    const std::scoped_lock lock(planner_mutex());
    fftw_destroy_plan(plan);
  }
};

using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, PlanDeleter>;

fftw_complex* as_fftw(ComplexBuffer& buffer) { return reinterpret_cast<fftw_complex*>(buffer.data()); }

/// Calls a planner function of FFTW under the mutex.
template <class MakePlan>
Plan plan(const MakePlan& make) {
  fftw_plan made = nullptr;
  {
    const std::scoped_lock lock(planner_mutex());
    made = make();
  }
  if (made == nullptr) throw std::runtime_error("FFTW could not plan a transform");
  return Plan(made);
}

}  // namespace

struct ComplexBackwardFft::Impl {
  Plan plan;
};

ComplexBackwardFft::ComplexBackwardFft(int length) {
  ComplexBuffer buffer(static_cast<std::size_t>(length));
  impl_ = std::make_unique<Impl>(
      plan([&] { return fftw_plan_dft_1d(length, as_fftw(buffer), as_fftw(buffer), FFTW_BACKWARD, FFTW_ESTIMATE); }));
}

ComplexBackwardFft::~ComplexBackwardFft() = default;
ComplexBackwardFft::ComplexBackwardFft(ComplexBackwardFft&&) noexcept = default;
ComplexBackwardFft& ComplexBackwardFft::operator=(ComplexBackwardFft&&) noexcept = default;

void ComplexBackwardFft::execute(ComplexBuffer& data) const {
  fftw_execute_dft(impl_->plan.get(), as_fftw(data), as_fftw(data));
}

struct RealFft::Impl {
  std::size_t real_size;
  std::size_t spectrum_size;
  Plan forward;
  Plan backward;
};

RealFft::RealFft(int rows, int columns) {
  const auto real_size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  const auto spectrum_size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns / 2 + 1);
  RealBuffer real(real_size);
  ComplexBuffer spectrum(spectrum_size);
  // Rank 2 with one row would still overwrite the spectrum; rank 1 keeps FFTW's faster codelets.
  const auto forward = [&] {
    return rows == 1 ? fftw_plan_dft_r2c_1d(columns, real.data(), as_fftw(spectrum), FFTW_ESTIMATE)
                     : fftw_plan_dft_r2c_2d(rows, columns, real.data(), as_fftw(spectrum), FFTW_ESTIMATE);
  };
  const auto backward = [&] {
    return rows == 1 ? fftw_plan_dft_c2r_1d(columns, as_fftw(spectrum), real.data(), FFTW_ESTIMATE)
                     : fftw_plan_dft_c2r_2d(rows, columns, as_fftw(spectrum), real.data(), FFTW_ESTIMATE);
  };
  impl_ = std::make_unique<Impl>(Impl{real_size, spectrum_size, plan(forward), plan(backward)});
}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

std::size_t RealFft::real_size() const { return impl_->real_size; }
std::size_t RealFft::spectrum_size() const { return impl_->spectrum_size; }

void RealFft::forward(RealBuffer& real, ComplexBuffer& spectrum) const {
  assert(real.size() == real_size() && spectrum.size() == spectrum_size());
  fftw_execute_dft_r2c(impl_->forward.get(), real.data(), as_fftw(spectrum));
}

void RealFft::backward(ComplexBuffer& spectrum, RealBuffer& real) const {
  assert(real.size() == real_size() && spectrum.size() == spectrum_size());
  fftw_execute_dft_c2r(impl_->backward.get(), as_fftw(spectrum), real.data());
}

int fast_length(int length) {
  for (;; ++length) {
    int rest = length;
    for (const int factor : {2, 3, 5, 7}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return length;
  }
}

}  // namespace viscoroll::detail
