#include "viscoroll/errors.hpp"

#include <algorithm>
#include <cstddef>

namespace viscoroll {
namespace {

std::string message(const std::string& parameter, const std::string& rule, const std::string& value,
                    const std::string& more) {
  return parameter + " " + rule + (value.empty() ? "" : ", got " + value) + (more.empty() ? "" : "; " + more);
}

}  // namespace

InvalidInput::InvalidInput(const std::string& parameter, const std::string& rule, const std::string& value,
                           const std::string& more)
    : std::invalid_argument(message(parameter, rule, value, more)),
      parameter_(parameter),
      rule_(rule),
      value_(value),
      more_(more) {}

InvalidInput InvalidInput::inside(std::string_view table) const {
  const std::size_t dot = table.rfind('.');
  const std::string_view last = dot == std::string_view::npos ? table : table.substr(dot + 1);
  const std::string_view rest = std::string_view(parameter_).substr(std::min(last.size(), parameter_.size()));
  const bool repeated = parameter_.starts_with(last) && (rest.empty() || rest.front() == '.' || rest.front() == '[');
  const std::string above(table.substr(0, repeated ? table.size() - last.size() : table.size()));
  return {above + (repeated ? "" : ".") + parameter_, rule_, value_, more_};
}

}  // namespace viscoroll
