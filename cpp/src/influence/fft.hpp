/// @file
/// @brief Transforms of lines. What does them is chosen when configuring: fft_fftw.cpp or fft_pocketfft.cpp.
///
/// No transform is normalized: backward after forward multiplies by the number of points. Forward has exp(-i ...),
/// backward exp(+i ...). The same length gives the same bits in every run; plans may be made and executed on several
/// threads at once.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace viscoroll::detail {

/// @brief Allocates on cache lines, as the plans expect.
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

/// @brief Storage for transforms, which expect their operands on cache lines.
using RealBuffer = std::vector<double, CacheLineAllocator<double>>;
using ComplexBuffer = std::vector<std::complex<double>, CacheLineAllocator<std::complex<double>>>;

/// @return the least multiple of a cache line that holds so many numbers: the stride of lines to transform
template <class Number>
[[nodiscard]] constexpr std::size_t cache_line_stride(std::size_t numbers) {
  constexpr std::size_t kLine = 64 / sizeof(Number);
  return (numbers + kLine - 1) / kLine * kLine;
}

/// @brief Transforms of a line of complex numbers, in place.
class ComplexFft {
 public:
  explicit ComplexFft(int length);
  ~ComplexFft();
  ComplexFft(ComplexFft&&) noexcept;
  ComplexFft& operator=(ComplexFft&&) noexcept;
  ComplexFft(const ComplexFft&) = delete;
  ComplexFft& operator=(const ComplexFft&) = delete;

  /// @param[in,out] line `length` numbers on a cache line
  void forward(std::complex<double>* line) const;
  void backward(std::complex<double>* line) const;

  /// @return the length >= `length`, even and of factors 2, 3, 5 and 7, at which a product with a spectrum takes the
  /// least time
  [[nodiscard]] static int fast_length(int length);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @brief Transforms between lines of real numbers and their half spectra. Several lines at a time may take less time
/// for each.
class RealFft {
 public:
  explicit RealFft(int length);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;
  RealFft(const RealFft&) = delete;
  RealFft& operator=(const RealFft&) = delete;

  /// @brief So many lines, and numbers from line to line of either kind.
  struct Lines {
    std::size_t count = 1;
    std::size_t real_stride = 0;
    std::size_t spectrum_stride = 0;
  };

  /// @return size of the scratch memory for several lines of `length` numbers. The caller keeps this memory from call
  /// to call: allocating it in each call takes longer than the transforms.
  [[nodiscard]] static std::size_t scratch_size(int length);

  /// @param[in,out] real `length` numbers each, on cache lines, overwritten
  /// @param[out] spectrum `length / 2 + 1` numbers each, on cache lines
  /// @param[in] lines how many
  /// @param scratch `scratch_size` numbers on a cache line; none are needed for a single line
  void forward(double* real, std::complex<double>* spectrum, const Lines& lines, double* scratch) const;
  void forward(double* real, std::complex<double>* spectrum) const { forward(real, spectrum, Lines{}, nullptr); }

  /// @param[in,out] spectrum `length / 2 + 1` numbers each, on cache lines, overwritten
  /// @param[out] real `length` numbers each, on cache lines
  /// @param[in] lines how many
  /// @param scratch as for `forward`
  void backward(std::complex<double>* spectrum, double* real, const Lines& lines, double* scratch) const;
  void backward(std::complex<double>* spectrum, double* real) const { backward(spectrum, real, Lines{}, nullptr); }

  /// @return as `ComplexFft::fast_length`
  [[nodiscard]] static int fast_length(int length);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace viscoroll::detail
