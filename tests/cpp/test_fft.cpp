#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "influence/fft.hpp"
#include "joined_thread.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

ComplexBuffer ramp(std::size_t length) {
  ComplexBuffer data(length);
  for (std::size_t i = 0; i < length; ++i) data[i] = cplx(static_cast<double>(i), 1.0 / (1.0 + static_cast<double>(i)));
  return data;
}

/// Sum of a_q exp(2 pi i q j / n) over q, term by term.
cplx direct_sum(const ComplexBuffer& a, std::size_t j) {
  cplx sum = 0.0;
  for (std::size_t q = 0; q < a.size(); ++q) {
    const double turn = static_cast<double>(q * j % a.size()) / static_cast<double>(a.size());
    sum += a[q] * std::polar(1.0, 2.0 * std::numbers::pi * turn);
  }
  return sum;
}

TEST(ComplexFft, SumsWithPositiveExponentBackwardAndNoScale) {
  for (const int length : {16, 25, 37}) {
    const ComplexBuffer input = ramp(static_cast<std::size_t>(length));
    ComplexBuffer output = input;
    const ComplexFft fft(length);
    fft.backward(output.data());
    // 37 terms of size 37 have a round-off of about 1e-16 * 37^2.
    for (std::size_t j = 0; j < input.size(); ++j) EXPECT_LT(std::abs(output[j] - direct_sum(input, j)), 1e-12);
    fft.forward(output.data());
    for (std::size_t j = 0; j < input.size(); ++j) {
      EXPECT_LT(std::abs(output[j] - static_cast<double>(length) * input[j]), 1e-11);
    }
  }
}

TEST(RealFft, BackwardUndoesForwardTimesTheLength) {
  for (const int length : {14, 15}) {
    const RealFft fft(length);
    RealBuffer real(static_cast<std::size_t>(length));
    for (std::size_t i = 0; i < real.size(); ++i) real[i] = std::sin(static_cast<double>(i * i));
    const RealBuffer original = real;
    ComplexBuffer spectrum(static_cast<std::size_t>(length / 2 + 1));
    fft.forward(real.data(), spectrum.data());
    fft.backward(spectrum.data(), real.data());
    for (std::size_t i = 0; i < real.size(); ++i) EXPECT_NEAR(real[i], length * original[i], 1e-12);
  }
}

TEST(RealFft, TransformsSeveralLinesLikeSingleOnes) {
  for (const int length : {30, 25}) {
    const auto points = static_cast<std::size_t>(length);
    RealBuffer scratch(RealFft::scratch_size(length));
    const RealFft::Lines lines{.count = 7, .real_stride = 32, .spectrum_stride = 16};
    RealBuffer real(lines.count * lines.real_stride);
    for (std::size_t i = 0; i < real.size(); ++i) real[i] = std::sin(static_cast<double>(i * i));
    const RealBuffer input = real;
    ComplexBuffer spectra(lines.count * lines.spectrum_stride);
    const RealFft fft(length);
    fft.forward(real.data(), spectra.data(), lines, scratch.data());
    for (std::size_t l = 0; l < lines.count; ++l) {
      const auto first = input.begin() + static_cast<std::ptrdiff_t>(l * lines.real_stride);
      const ComplexBuffer line(first, first + length);
      for (std::size_t j = 0; j <= points / 2; ++j) {
        EXPECT_LT(std::abs(spectra[l * lines.spectrum_stride + j] - std::conj(direct_sum(line, j))), 1e-12);
      }
    }
    fft.backward(spectra.data(), real.data(), lines, scratch.data());
    for (std::size_t i = 0; i < real.size(); ++i) {
      if (i % lines.real_stride >= points) continue;
      EXPECT_NEAR(real[i], length * input[i], 1e-12);
    }
  }
}

TEST(Fft, PlansCanBeMoved) {
  ComplexFft first(25);
  ComplexFft second(std::move(first));
  first = ComplexFft(16);
  second = std::move(first);
  ComplexBuffer data = ramp(16);
  const ComplexBuffer input = data;
  second.backward(data.data());
  EXPECT_LT(std::abs(data[5] - direct_sum(input, 5)), 1e-12);
}

TEST(Fft, ThreadsPlanAndExecuteConcurrently) {
  const ComplexFft shared(64);
  const ComplexBuffer input = ramp(64);
  ComplexBuffer expected = input;
  shared.backward(expected.data());
  constexpr int kThreads = 8;
  std::vector<JoinedThread> threads;
  threads.reserve(kThreads);
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 50; ++i) {
        const ComplexFft own(64);
        ComplexBuffer a = input;
        ComplexBuffer b = input;
        own.backward(a.data());
        shared.backward(b.data());
        EXPECT_EQ(a, expected);
        EXPECT_EQ(b, expected);
      }
    });
  }
}

TEST(FastLength, HasSmallFactorsAndIsLessThanTwiceTheLength) {
  for (int length = 1; length < 5000; ++length) {
    for (const int fast : {ComplexFft::fast_length(length), RealFft::fast_length(length)}) {
      EXPECT_GE(fast, length);
      EXPECT_LE(fast, 2 * length);
      int rest = fast;
      for (const int factor : {2, 3, 5, 7}) {
        while (rest % factor == 0) rest /= factor;
      }
      EXPECT_EQ(rest, 1) << "for " << length;
    }
  }
}

// With FFTW, each of 1000 numbers took 1.57 times as long as each of 1024.
TEST(FastLength, PrefersAPowerOfTwoToManyOddFactors) {
  EXPECT_EQ(ComplexFft::fast_length(1000), 1024);
  for (int power = 2; power <= 4096; power *= 2) EXPECT_EQ(ComplexFft::fast_length(power), power);
}

}  // namespace
}  // namespace viscoroll::detail
