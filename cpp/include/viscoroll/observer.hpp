/// @file
/// @brief How a caller watches a long computation and stops it.
#pragma once

#include <functional>
#include <string_view>

namespace viscoroll {

/// @brief A report from a running computation.
struct Progress {
  std::string_view stage;  ///< what is being done, in words
  double fraction = 0.0;   ///< share of this stage that is done, in [0, 1]
};

/// @brief Callbacks of a long computation. Both run on the thread that called the library, about every 20 ms.
struct Observer {
  std::function<bool()> cancelled;                ///< true stops the computation with `Cancelled`
  std::function<void(const Progress&)> progress;  ///< sees how far it is
};

}  // namespace viscoroll
