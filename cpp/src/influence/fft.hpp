/// @file
/// @brief The owner of FFTW: no other file includes it, so that another library could take its place.
///
/// No transform is normalized: backward after forward multiplies by the number of points. Forward has exp(-i ...),
/// backward exp(+i ...). Plans are made with FFTW_ESTIMATE, so that the same grid gives the same plan and the same bits
/// in every run, under one process-wide mutex, since FFTW's planner is not thread-safe; executing a plan is.
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

/// @brief Storage for transforms: the plans require buffers of these types.
using RealBuffer = std::vector<double, CacheLineAllocator<double>>;
using ComplexBuffer = std::vector<std::complex<double>, CacheLineAllocator<std::complex<double>>>;

/// @brief Backward transform of `length` complex numbers, in place.
class ComplexBackwardFft {
 public:
  explicit ComplexBackwardFft(int length);
  ~ComplexBackwardFft();
  ComplexBackwardFft(ComplexBackwardFft&&) noexcept;
  ComplexBackwardFft& operator=(ComplexBackwardFft&&) noexcept;
  ComplexBackwardFft(const ComplexBackwardFft&) = delete;
  ComplexBackwardFft& operator=(const ComplexBackwardFft&) = delete;

  /// @param[in,out] data `length` numbers
  void execute(ComplexBuffer& data) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @brief Transforms between a real array and its half spectrum, in one or two dimensions (rows of `columns` numbers,
/// halved along the rows).
class RealFft {
 public:
  /// @param[in] rows 1 for a one-dimensional transform
  /// @param[in] columns length of a row
  RealFft(int rows, int columns);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;
  RealFft(const RealFft&) = delete;
  RealFft& operator=(const RealFft&) = delete;

  /// @return numbers in the real array
  [[nodiscard]] std::size_t real_size() const;
  /// @return numbers in the half spectrum: rows * (columns / 2 + 1)
  [[nodiscard]] std::size_t spectrum_size() const;

  /// @param[in] real `real_size()` numbers
  /// @param[out] spectrum `spectrum_size()` numbers
  void forward(RealBuffer& real, ComplexBuffer& spectrum) const;

  /// @param[in,out] spectrum `spectrum_size()` numbers, overwritten
  /// @param[out] real `real_size()` numbers
  void backward(ComplexBuffer& spectrum, RealBuffer& real) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @return the smallest length >= `length` whose only factors are 2, 3, 5 and 7, where transforms are fast
[[nodiscard]] int fast_length(int length);

}  // namespace viscoroll::detail
