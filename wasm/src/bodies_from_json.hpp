/// @file
/// @brief Rolling body and counterbody from the tables of a case file.
#pragma once

#include "table.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll::wasm {

/// @brief Rolling body and counterbody.
struct Pair {
  RollingBody body;
  Counterbody on;  ///< rigid plane by default
};

/// @brief Take the tables of the bodies from a case.
/// @param[in,out] file all tables of a case
/// @throws InvalidInput for unknown and missing keys, values out of range, and unless exactly one rolling body
/// is given
[[nodiscard]] Pair pair_from_json(Table& file);

}  // namespace viscoroll::wasm
