/// @file
/// @brief Starting points shared by contacts that differ only in their coefficient of friction.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief Frictionless contact, and the state at the end of the steps towards full stick. The first contact computes
/// them and all others reuse them. Thread-safe.
class SharedStart {
 public:
  /// @brief A state, with the linear systems and operator applications that it took.
  struct StickingState {
    ContactSolution state;
    int systems;
    int products;
  };

  [[nodiscard]] std::shared_ptr<const ContactSolution> pressed() const { return found(pressed_); }
  [[nodiscard]] std::shared_ptr<const StickingState> stuck() const { return found(stuck_); }
  void keep(ContactSolution pressed) { keep(std::move(pressed), pressed_); }
  void keep(StickingState stuck) { keep(std::move(stuck), stuck_); }

 private:
  template <class Found>
  [[nodiscard]] std::shared_ptr<const Found> found(const std::shared_ptr<const Found>& kept) const {
    const std::scoped_lock lock(mutex_);
    return kept;
  }

  template <class Found>
  void keep(Found found, std::shared_ptr<const Found>& kept) {
    auto next = std::make_shared<const Found>(std::move(found));
    const std::scoped_lock lock(mutex_);
    kept = std::move(next);
  }

  mutable std::mutex mutex_;
  std::shared_ptr<const ContactSolution> pressed_;
  std::shared_ptr<const StickingState> stuck_;
};

}  // namespace viscoroll::detail
