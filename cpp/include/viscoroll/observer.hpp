/// @file
/// @brief Progress reports and cancellation of a long computation.
#pragma once

#include <functional>
#include <string_view>

namespace viscoroll {

/// @brief Progress of a running computation.
struct Progress {
  std::string_view stage;  ///< description of the current stage
  double fraction = 0.0;   ///< completed fraction of this stage, in [0, 1]
};

/// @brief Callbacks of a long computation. Both are called on the thread that called the library, about every 20 ms.
struct Observer {
  std::function<bool()> cancelled;                ///< return true to stop the computation with `Canceled`
  std::function<void(const Progress&)> progress;  ///< receives the progress
};

}  // namespace viscoroll
