#include "base/dense_products.hpp"

namespace viscoroll::detail {

extern const DenseProducts kBaselineProducts;
#ifdef VISCOROLL_AVX
extern const DenseProducts kAvx2Products;
#endif

std::vector<DenseProducts> usable_products() {
  std::vector<DenseProducts> usable{kBaselineProducts};
#ifdef VISCOROLL_AVX
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) usable.push_back(kAvx2Products);
#endif
  return usable;
}

const DenseProducts& best_products() {
  static const DenseProducts best = usable_products().back();
  return best;
}

}  // namespace viscoroll::detail
