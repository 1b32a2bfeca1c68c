#define VISCOROLL_EIGEN EigenAvx512
#include "dense_products_for.hpp"

namespace viscoroll::detail {

extern const DenseProducts kAvx512Products = kProducts;

}  // namespace viscoroll::detail
