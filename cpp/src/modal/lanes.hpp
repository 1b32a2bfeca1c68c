/// @file
/// @brief Numbers of several orders side by side, for loops that the compiler vectorizes.
///
/// A loop over lanes reads the number of one lane, computes with it, and stores the result. If everything is inlined,
/// the compiler turns the loop into a few vector instructions. std::complex prevents this, because its product checks
/// for infinities.
#pragma once

#include <array>
#include <complex>

#include "base/instruction_sets.hpp"

namespace viscoroll::detail {

constexpr std::size_t kLanes = 8;  ///< number of doubles in the widest vectors (AVX-512)

/// @brief Complex number of one lane.
struct LaneComplex {
  double re;
  double im;
};

VISCOROLL_PART_OF_CALLER LaneComplex operator+(LaneComplex a, LaneComplex b) { return {a.re + b.re, a.im + b.im}; }
VISCOROLL_PART_OF_CALLER LaneComplex operator-(LaneComplex a, LaneComplex b) { return {a.re - b.re, a.im - b.im}; }
VISCOROLL_PART_OF_CALLER LaneComplex operator*(double a, LaneComplex b) { return {a * b.re, a * b.im}; }
VISCOROLL_PART_OF_CALLER LaneComplex operator*(LaneComplex a, LaneComplex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
VISCOROLL_PART_OF_CALLER LaneComplex inverse(LaneComplex a) {
  const double scale = 1.0 / (a.re * a.re + a.im * a.im);
  return {scale * a.re, -scale * a.im};
}
VISCOROLL_PART_OF_CALLER double inverse(double a) { return 1.0 / a; }

/// Size of a number without a square root: the magnitude of its larger part.
VISCOROLL_PART_OF_CALLER double size(double a) { return a < 0.0 ? -a : a; }
VISCOROLL_PART_OF_CALLER double size(LaneComplex a) {
  const double re = size(a.re);
  const double im = size(a.im);
  return re > im ? re : im;
}

/// @brief One number for each lane. `Scalar` is double or std::complex<double>.
template <class Scalar>
class Lanes;

template <>
class Lanes<double> {
 public:
  using Number = double;

  VISCOROLL_PART_OF_CALLER double operator[](std::size_t lane) const { return values_[lane]; }
  VISCOROLL_PART_OF_CALLER void set(std::size_t lane, double value) { values_[lane] = value; }
  [[nodiscard]] double value(std::size_t lane) const { return values_[lane]; }

 private:
  alignas(64) std::array<double, kLanes> values_{};
};

template <>
class Lanes<std::complex<double>> {
 public:
  using Number = LaneComplex;

  VISCOROLL_PART_OF_CALLER LaneComplex operator[](std::size_t lane) const { return {real_[lane], imaginary_[lane]}; }
  VISCOROLL_PART_OF_CALLER void set(std::size_t lane, LaneComplex value) {
    real_[lane] = value.re;
    imaginary_[lane] = value.im;
  }
  void set(std::size_t lane, std::complex<double> value) { set(lane, LaneComplex{value.real(), value.imag()}); }
  void set(std::size_t lane, double value) { set(lane, LaneComplex{value, 0.0}); }
  [[nodiscard]] std::complex<double> value(std::size_t lane) const { return {real_[lane], imaginary_[lane]}; }

 private:
  alignas(64) std::array<double, kLanes> real_{};
  alignas(64) std::array<double, kLanes> imaginary_{};
};

}  // namespace viscoroll::detail
