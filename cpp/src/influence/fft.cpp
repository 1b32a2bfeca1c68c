#include "influence/fft.hpp"

#include <fftw3.h>

#include <cassert>
#include <cstdint>
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

fftw_complex* as_fftw(std::complex<double>* line) { return reinterpret_cast<fftw_complex*>(line); }

[[maybe_unused]] bool is_aligned(const void* line) { return reinterpret_cast<std::uintptr_t>(line) % 64 == 0; }

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

struct ComplexFft::Impl {
  Plan forward;
  Plan backward;
};

ComplexFft::ComplexFft(int length) {
  ComplexBuffer buffer(static_cast<std::size_t>(length));
  fftw_complex* line = as_fftw(buffer.data());
  const auto make = [&](int sign) {
    return plan([&] { return fftw_plan_dft_1d(length, line, line, sign, FFTW_ESTIMATE); });
  };
  impl_ = std::make_unique<Impl>(Impl{make(FFTW_FORWARD), make(FFTW_BACKWARD)});
}

ComplexFft::~ComplexFft() = default;
ComplexFft::ComplexFft(ComplexFft&&) noexcept = default;
ComplexFft& ComplexFft::operator=(ComplexFft&&) noexcept = default;

void ComplexFft::forward(std::complex<double>* line) const {
  assert(is_aligned(line));
  fftw_execute_dft(impl_->forward.get(), as_fftw(line), as_fftw(line));
}

void ComplexFft::backward(std::complex<double>* line) const {
  assert(is_aligned(line));
  fftw_execute_dft(impl_->backward.get(), as_fftw(line), as_fftw(line));
}

struct RealFft::Impl {
  Plan forward;
  Plan backward;
};

RealFft::RealFft(int length) {
  RealBuffer real(static_cast<std::size_t>(length));
  ComplexBuffer spectrum(static_cast<std::size_t>(length / 2 + 1));
  fftw_complex* half = as_fftw(spectrum.data());
  impl_ = std::make_unique<Impl>(
      Impl{plan([&] { return fftw_plan_dft_r2c_1d(length, real.data(), half, FFTW_ESTIMATE); }),
           plan([&] { return fftw_plan_dft_c2r_1d(length, half, real.data(), FFTW_ESTIMATE); })});
}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

void RealFft::forward(double* real, std::complex<double>* spectrum) const {
  assert(is_aligned(real) && is_aligned(spectrum));
  fftw_execute_dft_r2c(impl_->forward.get(), real, as_fftw(spectrum));
}

void RealFft::backward(std::complex<double>* spectrum, double* real) const {
  assert(is_aligned(real) && is_aligned(spectrum));
  fftw_execute_dft_c2r(impl_->backward.get(), as_fftw(spectrum), real);
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
