/// @file
/// @brief Starts of the load cases of a model with friction, by all that they depend on.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "contact/shared_start.hpp"
#include "surface/window.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/options.hpp"

namespace viscoroll::detail {

/// @brief The last few starts of a model. Threads may share it.
class SharedStarts {
 public:
  /// @param[in] load_case whose coefficient of friction is not looked at
  /// @param[in] options how it is solved
  /// @param[in] window in which
  [[nodiscard]] std::shared_ptr<SharedStart> of(const LoadCase& load_case, const Options& options,
                                                const Window& window);

 private:
  using Key = std::vector<double>;

  std::mutex mutex_;
  std::deque<std::pair<Key, std::shared_ptr<SharedStart>>> starts_;  // the latest first
};

}  // namespace viscoroll::detail
