#define VISCOROLL_EIGEN EigenAvx2
#include "base/dense_products_for.hpp"

namespace viscoroll::detail {

extern const DenseProducts kAvx2Products = kProducts;

}  // namespace viscoroll::detail
