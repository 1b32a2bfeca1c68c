/// @file
/// @brief Shear moduli from the tables of a case file.
#pragma once

#include <string>

#include "table.hpp"
#include "viscoroll/materials.hpp"

namespace viscoroll::wasm {

/// @param[in] json table with the key `type`, or a number, which is an elastic modulus [Pa]
/// @param[in] path path of the table in the case
/// @throws InvalidInput for unknown and missing keys and values out of range
[[nodiscard]] ShearModulus modulus_from_json(const Json& json, const std::string& path);

}  // namespace viscoroll::wasm
