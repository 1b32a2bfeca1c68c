#include "dense_products.hpp"

namespace viscoroll::detail {

extern const DenseProducts kBaselineProducts;
#ifdef VISCOROLL_AVX
extern const DenseProducts kAvx2Products;
extern const DenseProducts kAvx512Products;
#endif

std::vector<DenseProducts> usable_products() {
  std::vector<DenseProducts> usable{kBaselineProducts};
#ifdef VISCOROLL_AVX
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return usable;
  usable.push_back(kAvx2Products);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    usable.push_back(kAvx512Products);
  }
#endif
  return usable;
}

const DenseProducts& best_products() {
  static const DenseProducts best = usable_products().back();
  return best;
}

}  // namespace viscoroll::detail
