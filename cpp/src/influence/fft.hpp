/// @file
/// @brief Fourier transforms of lines, and lengths at which they are fast. The library is chosen at configuration:
/// fft_fftw.cpp or fft_pocketfft.cpp.
///
/// Transforms are not normalized: backward after forward multiplies by the number of points. Forward transforms have
/// exp(-i ...), backward ones exp(+i ...). The same length gives the same bits in every run. Plans may be made and
/// executed by several threads at once.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace viscoroll::detail {

/// @brief Allocator aligned to cache lines, as the plans require.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{64};

  CacheLineAllocator() = default;
  template <class U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), kAlignment)); }
  void deallocate(T* pointer, std::size_t) noexcept { ::operator delete(pointer, kAlignment); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

/// @brief Buffers for transforms, whose operands must be aligned to cache lines.
using RealBuffer = std::vector<double, CacheLineAllocator<double>>;
using ComplexBuffer = std::vector<std::complex<double>, CacheLineAllocator<std::complex<double>>>;

/// @return smallest multiple of a cache line that holds the given count of numbers: the stride of lines to be
/// transformed
template <class Number>
[[nodiscard]] constexpr std::size_t cache_line_stride(std::size_t numbers) {
  constexpr std::size_t kLine = 64 / sizeof(Number);
  return (numbers + kLine - 1) / kLine * kLine;
}

/// @brief In-place transforms of a line of complex numbers.
class ComplexFft {
 public:
  explicit ComplexFft(int length);
  ~ComplexFft();
  ComplexFft(ComplexFft&&) noexcept;
  ComplexFft& operator=(ComplexFft&&) noexcept;
  ComplexFft(const ComplexFft&) = delete;
  ComplexFft& operator=(const ComplexFft&) = delete;

  /// @param[in,out] line `length` numbers, aligned to a cache line
  void forward(std::complex<double>* line) const;
  void backward(std::complex<double>* line) const;

  /// @return length >= `length`, even and with factors 2, 3, 5 and 7, at which a product with a spectrum takes the
  /// least time
  [[nodiscard]] static int fast_length(int length);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @brief Transforms between lines of real numbers and their half spectra. Several lines at once may take less time per
/// line.
class RealFft {
 public:
  explicit RealFft(int length);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;
  RealFft(const RealFft&) = delete;
  RealFft& operator=(const RealFft&) = delete;

  /// @brief Number of lines, and strides between real lines and between spectra.
  struct Lines {
    std::size_t count = 1;
    std::size_t real_stride = 0;
    std::size_t spectrum_stride = 0;
  };

  /// @return number of doubles of scratch memory for several lines of `length` numbers. The caller keeps this memory
  /// between calls, because allocating it in each call takes longer than the transforms.
  [[nodiscard]] static std::size_t scratch_size(int length);

  /// @param[in,out] real lines of `length` numbers, aligned to cache lines, overwritten
  /// @param[out] spectrum lines of `length / 2 + 1` numbers, aligned to cache lines
  /// @param[in] lines number and strides of the lines
  /// @param scratch `scratch_size` numbers, aligned to a cache line; not used for a single line
  void forward(double* real, std::complex<double>* spectrum, const Lines& lines, double* scratch) const;
  void forward(double* real, std::complex<double>* spectrum) const { forward(real, spectrum, Lines{}, nullptr); }

  /// @param[in,out] spectrum lines of `length / 2 + 1` numbers, aligned to cache lines, overwritten
  /// @param[out] real lines of `length` numbers, aligned to cache lines
  /// @param[in] lines number and strides of the lines
  /// @param scratch same as in `forward`
  void backward(std::complex<double>* spectrum, double* real, const Lines& lines, double* scratch) const;
  void backward(std::complex<double>* spectrum, double* real) const { backward(spectrum, real, Lines{}, nullptr); }

  /// @return same as `ComplexFft::fast_length`
  [[nodiscard]] static int fast_length(int length);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @brief Time [ns] per number of a line for a forward and a backward transform: a constant plus a contribution of each
/// prime factor of the length.
///
/// Only ratios matter, since the cost is used to choose among lengths. Ratios differ less between machines than times
/// do.
struct FftCost {
  double least;  ///< the constant; may be negative in a fit
  double factor_2;
  double factor_3;
  double factor_5;
  double factor_7;
};

// Defined next to the transform that was measured.
extern const FftCost kComplexFftCost;
extern const FftCost kRealFftCost;

}  // namespace viscoroll::detail
