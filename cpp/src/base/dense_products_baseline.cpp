#define VISCOROLL_EIGEN EigenBaseline
#include "base/dense_products_for.hpp"

namespace viscoroll::detail {

extern const DenseProducts kBaselineProducts = kProducts;

}  // namespace viscoroll::detail
