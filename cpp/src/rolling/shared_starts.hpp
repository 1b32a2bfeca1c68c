/// @file
/// @brief Starting points for the load cases of a model with friction, stored with the inputs that they depend on.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "contact/shared_start.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/options.hpp"

namespace viscoroll::detail {

/// @brief The last few starting points of a model. Threads may share it.
class SharedStarts {
 public:
  /// @return the starting point of load cases that differ by their coefficient of friction only
  /// @param[in] load_case load and drive; its coefficient of friction is ignored
  /// @param[in] options solver options
  /// @param[in] window window of nodes
  [[nodiscard]] std::shared_ptr<SharedStart> of(const LoadCase& load_case, const Options& options,
                                                const Window& window);

 private:
  using Key = std::vector<double>;

  std::mutex mutex_;
  std::deque<std::pair<Key, std::shared_ptr<SharedStart>>> starts_;  // the latest first
};

}  // namespace viscoroll::detail
