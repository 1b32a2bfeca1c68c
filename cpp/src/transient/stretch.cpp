#include "transient/stretch.hpp"

#include <vector>

namespace viscoroll::detail {
namespace {

void write_end(const StepEnd& end, NumberWriter& numbers) {
  std::vector<double> values{end.time, end.angle, end.load};
  if (end.center_way) values.push_back(*end.center_way);
  numbers.put(values);
}

StepEnd read_end(NumberReader& numbers) {
  const std::vector<double> values = numbers.values();
  NumberReader::require(values.size() == 3 || values.size() == 4);
  StepEnd end{.time = values[0], .angle = values[1], .load = values[2], .center_way = {}};
  if (values.size() == 4) end.center_way = values[3];
  return end;
}

}  // namespace

void write(const std::optional<Stretch>& stretch, NumberWriter& numbers) {
  numbers.put(stretch ? 1.0 : 0.0);
  if (!stretch) return;
  write_end(stretch->begin, numbers);
  write_end(stretch->end, numbers);
  numbers.put(stretch->last_step);
  numbers.put(static_cast<double>(stretch->taken));
}

std::optional<Stretch> read_stretch(NumberReader& numbers) {
  if (numbers.count(1.0) == 0) return std::nullopt;
  Stretch stretch{.begin = read_end(numbers), .end = read_end(numbers), .last_step = numbers.get(), .taken = 0};
  NumberReader::require(stretch.begin.center_way.has_value());
  stretch.taken = static_cast<std::size_t>(numbers.count());
  return stretch;
}

}  // namespace viscoroll::detail
