/// @file
/// @brief Motions as JSON, with the tables and keys of a motion file.
#pragma once

#include "bodies_from_json.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::wasm {

/// @brief Arguments of a history and of `roll`.
struct MotionCase {
  Pair pair;
  Motion motion;
  Start start = Start::relaxed;
  HistoryOptions options;  ///< with one thread
};

/// @throws InvalidInput for unknown and missing keys and values out of range; its parameter is the path of the key
[[nodiscard]] MotionCase motion_from_json(const Json& json);

}  // namespace viscoroll::wasm
