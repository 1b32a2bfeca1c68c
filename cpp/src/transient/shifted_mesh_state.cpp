// State of a phase-shifted mesh as numbers, and its contact field.
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "transient/shifted_mesh.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Order and signs of forces in saved states: pressing, forward, sideways.
constexpr std::array<std::pair<Axis, double>, 3> kSaved{{{kDown, -1.0}, {kForward, 1.0}, {kSideways, 1.0}}};

}  // namespace

void ShiftedMesh::write(NumberWriter& numbers) const {
  for (const auto member : kShiftedMeshScalars) numbers.put(now_.*member);
  numbers.put(center_acceleration_);
  numbers.put(power_.along_track);
  numbers.put(power_.creeping);
  numbers.put(static_cast<double>(half_rows_));
  numbers.put(lowest_);
  numbers.put(static_cast<double>(first_));
  numbers.put(static_cast<double>(count_));
  for (const auto& [axis, sign] : kSaved) numbers.put(as_field(sign * force_.col(axis), pair_->half_nodes()));
  for (const RowMemory& memory : memories_) memory.write(numbers);
  // Data of the last contact and the last step, so that the next step is identical to the last bit.
  for (std::size_t b = 0; b < memories_.size(); ++b)
    numbers.put(last_.empty() ? std::vector<double>{} : last_[b].parts);
  inverse_.write(numbers);
  stiffness_.write(numbers);
}

void ShiftedMesh::read(NumberReader& numbers, const Checkpoint& checkpoint) {
  for (const auto member : kShiftedMeshScalars) {
    // A line contact has no width.
    now_.*member = member == &RollingInstant::semi_axis_z ? numbers.get_if_any() : numbers.get();
  }
  const double spacing = pair_->nodes.grid.phi_spacing;
  NumberReader::require(std::abs(now_.angle) <= kMaxRows * spacing && now_.load >= 0.0);
  center_acceleration_ = numbers.get();
  power_ = {.along_track = numbers.get(), .creeping = numbers.get()};
  half_rows_ = numbers.count(static_cast<double>(pair_->nodes.widest.phi.last));
  lowest_ = numbers.get();
  first_ = numbers.row();
  count_ = numbers.count();
  const ContactPlace place = place_at(*pair_, shift_, half_rows_, now_.angle);
  NumberReader::require(first_ == place.first && count_ == place.count);
  force_ = VectorField::Zero(pair_->half_nodes() * count_, 3);
  for (const auto& [axis, sign] : kSaved) {
    const HalfField field = numbers.matrix();
    NumberReader::require(field.size() == force_.rows());
    force_.col(axis) = sign * field.reshaped();
  }
  memories_.clear();
  for (const ViscoelasticBody& body : pair_->bodies) {
    memories_.emplace_back(body);
    memories_.back().read(numbers, body.tables);
    NumberReader::require(memories_.back().keeps(first_) && memories_.back().keeps(first_ + count_ - 1));
  }
  last_.clear();
  for (const ViscoelasticBody& body : pair_->bodies) {
    std::vector<double> parts = numbers.values();
    if (parts.empty()) continue;
    NumberReader::require(parts.size() == body.tables.count());
    last_.push_back(body.tables.instantaneous(std::move(parts), checkpoint));
  }
  const Index last = pair_->half_nodes() * (2 * half_rows_ + 1) - 1;
  inverse_.read(numbers, last);
  stiffness_.read(numbers, last);
}

ContactField ShiftedMesh::field() const {
  const ContactPlace place = place_at(*pair_, shift_, half_rows_, now_.angle);
  const Index half_nodes = pair_->half_nodes();
  const Index sides = 2 * half_nodes - 1;
  const double patch = flat_patch(pair_->nodes.grid);
  const ArrayXd weights = half_weights(half_nodes);
  ContactField field{.phi_nodes = static_cast<int>(place.count), .theta_nodes = static_cast<int>(sides)};
  for (Index i = 0; i < place.count; ++i) {
    for (Index k = 1 - half_nodes; k < half_nodes; ++k) {
      const Index node = i * half_nodes + std::abs(k);
      field.x.push_back(place.nodes.x()[node]);
      field.z.push_back(k < 0 ? -place.nodes.z()[node] : place.nodes.z()[node]);
      field.pressure.push_back(-force_(node, kDown) / weights[std::abs(k)] / patch);
    }
  }
  return field;
}

}  // namespace viscoroll::detail
