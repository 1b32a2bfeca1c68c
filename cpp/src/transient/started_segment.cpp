#include "transient/started_segment.hpp"

#include <vector>

namespace viscoroll::detail {
namespace {

void write_end(const StepEnd& end, NumberWriter& numbers) {
  std::vector<double> values{end.time, end.angle, end.load};
  if (end.center_displacement) values.push_back(*end.center_displacement);
  numbers.put(values);
}

StepEnd read_end(NumberReader& numbers) {
  const std::vector<double> values = numbers.values();
  NumberReader::require(values.size() == 3 || values.size() == 4);
  StepEnd end{.time = values[0], .angle = values[1], .load = values[2], .center_displacement = {}};
  if (values.size() == 4) end.center_displacement = values[3];
  return end;
}

}  // namespace

StepEnd StartedSegment::at(double share) const {
  StepEnd at{.time = begin.time + share * (end.time - begin.time),
             .angle = begin.angle + share * (end.angle - begin.angle),
             .load = begin.load + share * (end.load - begin.load),
             .center_displacement = {}};
  if (end.center_displacement) {
    at.center_displacement =
        *begin.center_displacement + share * (*end.center_displacement - *begin.center_displacement);
  }
  return at;
}

void write(const std::optional<StartedSegment>& started, NumberWriter& numbers) {
  numbers.put(started ? 1.0 : 0.0);
  if (!started) return;
  write_end(started->begin, numbers);
  write_end(started->end, numbers);
  numbers.put(started->last_step);
  numbers.put(static_cast<double>(started->taken));
}

std::optional<StartedSegment> read_started_segment(NumberReader& numbers) {
  if (numbers.count(1.0) == 0) return std::nullopt;
  StartedSegment started{.begin = read_end(numbers), .end = read_end(numbers), .last_step = numbers.get(), .taken = 0};
  NumberReader::require(started.begin.center_displacement.has_value());
  started.taken = static_cast<std::size_t>(numbers.count());
  return started;
}

}  // namespace viscoroll::detail
