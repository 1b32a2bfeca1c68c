/// @file
/// @brief Transforms by PocketFFT, a header under a three-clause BSD license.
#define POCKETFFT_NO_MULTITHREADING
#if __has_include(<pocketfft_hdronly.h>)
#include <pocketfft_hdronly.h>
#else
#include <pocketfft.hpp>
#endif

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "influence/fft.hpp"
#include "influence/fft_cost.hpp"
#include "instruction_sets.hpp"

namespace viscoroll::detail {
namespace {

using std::complex;
using Plan = pocketfft::detail::cfftp<double>;

/// Real and imaginary part, as PocketFFT has them: of one number, or of one of each line.
template <class Part>
using Pair = pocketfft::detail::cmplx<Part>;

void transform_line(const Plan& plan, bool forward, complex<double>* line) {
  plan.exec(reinterpret_cast<Pair<double>*>(line), 1.0, forward);
}

#ifdef __GNUC__

constexpr std::size_t kTogether = 4;  // lines
using Lanes = double __attribute__((vector_size(kTogether * sizeof(double))));

/// As many lines at once as an instruction takes numbers. Nothing is called that is not compiled for those
/// instructions.
VISCOROLL_BEST_INSTRUCTIONS __attribute__((flatten)) void transform_together(const Plan& plan, bool forward,
                                                                             complex<double>* lines, std::size_t length,
                                                                             std::size_t stride,
                                                                             Pair<Lanes>* together) {
  for (std::size_t i = 0; i < length; ++i) {
    for (std::size_t l = 0; l < kTogether; ++l) {
      together[i].r[l] = lines[l * stride + i].real();
      together[i].i[l] = lines[l * stride + i].imag();
    }
  }
  plan.exec(together, 1.0, forward);
  for (std::size_t i = 0; i < length; ++i) {
    for (std::size_t l = 0; l < kTogether; ++l) lines[l * stride + i] = {together[i].r[l], together[i].i[l]};
  }
}
#endif

}  // namespace

// Four lines at a time, and one, on an Intel Xeon with AVX-512, even lengths from 96 to 4200; 10 and 8 % from what was
// measured.
const FftCost kComplexFftCost{.least = -1.18, .factor_2 = 0.65, .factor_3 = 1.35, .factor_5 = 1.71, .factor_7 = 1.91};
const FftCost kRealFftCost{.least = 3.33, .factor_2 = 0.26, .factor_3 = 0.92, .factor_5 = 1.14, .factor_7 = 2.80};

struct ComplexFft::Impl {
  Plan plan;
  std::size_t length;

  void transform(bool forward, complex<double>* lines, std::size_t count, std::size_t stride) const {
#ifdef __GNUC__
    if (count >= kTogether) {
      // Kept: the system clears memory that is given back and taken again, which takes longer than the transform.
      thread_local std::vector<Pair<Lanes>, CacheLineAllocator<Pair<Lanes>>> together;
      if (together.size() < length) together.resize(length);
      for (; count >= kTogether; count -= kTogether, lines += kTogether * stride) {
        transform_together(plan, forward, lines, length, stride, together.data());
      }
    }
#endif
    for (; count > 0; --count, lines += stride) transform_line(plan, forward, lines);
  }
};

ComplexFft::ComplexFft(int length) {
  const auto numbers = static_cast<std::size_t>(length);
  impl_ = std::make_unique<Impl>(Impl{.plan = Plan(numbers), .length = numbers});
}

ComplexFft::~ComplexFft() = default;
ComplexFft::ComplexFft(ComplexFft&&) noexcept = default;
ComplexFft& ComplexFft::operator=(ComplexFft&&) noexcept = default;

void ComplexFft::forward(complex<double>* lines, std::size_t count, std::size_t stride) const {
  impl_->transform(true, lines, count, stride);
}

void ComplexFft::backward(complex<double>* lines, std::size_t count, std::size_t stride) const {
  impl_->transform(false, lines, count, stride);
}

struct RealFft::Impl {
  pocketfft::detail::pocketfft_r<double> plan;
};

RealFft::RealFft(int length)
    : impl_(std::make_unique<Impl>(
          Impl{.plan = pocketfft::detail::pocketfft_r<double>(static_cast<std::size_t>(length))})) {}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

// PocketFFT has the half spectrum in as many numbers as the line: real part 0, real and imaginary part 1, ..., and for
// an even length the real part of the last.

void RealFft::forward(double* real, complex<double>* spectrum) const {
  const std::size_t length = impl_->plan.length();
  impl_->plan.exec(real, 1.0, true);
  spectrum[0] = real[0];
  for (std::size_t i = 1; 2 * i < length; ++i) spectrum[i] = {real[2 * i - 1], real[2 * i]};
  if (length % 2 == 0) spectrum[length / 2] = real[length - 1];
}

void RealFft::backward(complex<double>* spectrum, double* real) const {
  const std::size_t length = impl_->plan.length();
  real[0] = spectrum[0].real();
  for (std::size_t i = 1; 2 * i < length; ++i) {
    real[2 * i - 1] = spectrum[i].real();
    real[2 * i] = spectrum[i].imag();
  }
  if (length % 2 == 0) real[length - 1] = spectrum[length / 2].real();
  impl_->plan.exec(real, 1.0, false);
}

}  // namespace viscoroll::detail
