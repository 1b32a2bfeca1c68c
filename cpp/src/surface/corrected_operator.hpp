/// @file
/// @brief Base class of operators that differ little from another operator.
#pragma once

#include <memory>
#include <utility>

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Operator with its own products, whose window, body and local compliance are those of the operator that it
/// corrects.
class CorrectedOperator : public SurfaceOperator {
 public:
  [[nodiscard]] const Window& window() const override { return nearby_->window(); }
  [[nodiscard]] const Execution& execution() const override { return nearby_->execution(); }
  [[nodiscard]] double collocation() const override { return nearby_->collocation(); }
  [[nodiscard]] const LocalCompliance& local() const override { return nearby_->local(); }
  [[nodiscard]] Deforming deforming() const override { return nearby_->deforming(); }
  [[nodiscard]] double row_distance() const override { return nearby_->row_distance(); }

 protected:
  /// @param[in] nearby operator on the same window that this one corrects
  explicit CorrectedOperator(std::shared_ptr<const SurfaceOperator> nearby) : nearby_(std::move(nearby)) {}
  [[nodiscard]] const SurfaceOperator& nearby() const { return *nearby_; }

 private:
  std::shared_ptr<const SurfaceOperator> nearby_;
};

}  // namespace viscoroll::detail
