/// @file
/// @brief Functions exported by the WebAssembly module. Arguments and results are JSON texts.

#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "answer_to_json.hpp"
#include "case_from_json.hpp"
#include "motion_from_json.hpp"
#include "table.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/solve.hpp"

extern "C" {

/// @brief Function of JavaScript that receives time series as a JSON text, which is valid during the call.
__attribute__((import_module("viscoroll"), import_name("receive"))) void viscoroll_receive(const char* series);
}

namespace viscoroll::wasm {
namespace {

/// Parse a request. Nesting is limited, because deep recursion would overflow the stack; cases have only a few levels.
Json parsed(const char* request) {
  constexpr int kDeepest = 100;
  return Json::parse(request, [](int depth, Json::parse_event_t, const Json&) {
    if (depth > kDeepest)
      throw InvalidInput("request", "must be nested at most " + std::to_string(kDeepest) + " levels deep", "");
    return true;
  });
}

Json solved(const Json& request) {
  Table table(request, "request");
  const Json& given = table.require("case");
  const Json* fields = table.take("fields");
  table.close();
  if (fields != nullptr && !fields->is_boolean()) {
    throw InvalidInput("request.fields", "must be true or false", shown(*fields));
  }
  const Case read = case_from_json(given);
  const Result result = solve(read.pair.body, read.pair.on, read.load_case, read.options);
  Json answer = result_to_json(result);
  if (fields != nullptr && fields->get<bool>()) {
    answer["fields"] = fields_to_json(result, read.load_case.friction > 0.0);
  }
  return answer;
}

RollingHistory start(const MotionCase& given) {
  const Motion& motion = given.motion;
  std::optional<double> axle_height;
  if (!motion.axle_height.empty()) axle_height = motion.axle_height.front();
  return {given.pair.body,      given.pair.on, motion.load.empty() ? 0.0 : motion.load.front(),
          given.start,          given.options, motion.time.front(),
          motion.angle.front(), Observer{},    axle_height};
}

/// Compute a history, and pass the instants to JavaScript as they are computed.
Json rolled(const Json& request) {
  Table table(request, "request");
  const Json& given = table.require("case");
  table.close();
  const MotionCase read = motion_from_json(given);
  const double radius = std::visit([](const auto& body) { return outer_radius(body); }, read.pair.body);
  const auto pass_on = [radius](std::span<const RollingInstant> instants) {
    viscoroll_receive(series_to_json(instants, radius).dump().c_str());
  };
  RollingHistory history = start(read);
  pass_on(std::span(&history.current(), 1));
  const auto instants = roll(history, read.motion, Observer{}, pass_on);
  return {{"steps", instants.size() - 1},
          {"nodes_per_revolution", history.mesh().nodes_per_revolution},
          {"spectrum_error", history.spectrum_error()}};
}

Json other_error(const char* message) {
  return {
      {"error",
       {{"message", message}, {"parameter", nullptr}, {"rule", nullptr}, {"value", nullptr}, {"allowed", nullptr}}}};
}

/// Return unit and ends of a range; an end that does not exist is null.
Json range_to_json(const std::optional<Range>& range) {
  if (!range) return nullptr;
  const auto end = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  return {{"unit", range->unit},
          {"minimum", end(range->minimum)},
          {"maximum", end(range->maximum)},
          {"excludes_minimum", range->excludes_minimum},
          {"excludes_maximum", range->excludes_maximum}};
}

/// Answer a request by a function of it.
Json answer_to(const char* request, Json (*result)(const Json&)) {
  try {
    return {{"result", result(parsed(request))}};
  } catch (const InvalidInput& error) {
    return {{"error",
             {{"message", error.what()},
              {"parameter", error.parameter()},
              {"rule", error.rule()},
              {"value", error.value()},
              {"allowed", range_to_json(error.allowed())}}}};
  } catch (const std::bad_alloc&) {
    return other_error("out of memory: use a coarser mesh or a larger accuracy");
  } catch (const std::exception& error) {
    return other_error(error.what());
  }
}

/// Return the text of an answer. The text is valid until the next call; JavaScript copies it before.
const char* kept(const Json& json) {
  static std::string text;
  text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.c_str();
}

}  // namespace
}  // namespace viscoroll::wasm

extern "C" {

/// @param[in] request {"case": tables of a case file, "fields": whether to return fields}
/// @return {"result": ...} or {"error": {"message", "parameter", "rule", "value"}}
const char* solve(const char* request) {
  return viscoroll::wasm::kept(viscoroll::wasm::answer_to(request, viscoroll::wasm::solved));
}

/// @brief Compute a history. The time series of new instants are passed to viscoroll_receive.
/// @param[in] request {"case": tables of a motion file}
/// @return {"result": {"steps", "nodes_per_revolution", "spectrum_error"}} or an error as `solve`
const char* roll(const char* request) {
  return viscoroll::wasm::kept(viscoroll::wasm::answer_to(request, viscoroll::wasm::rolled));
}

/// @return [{"name", "unit", "description"}] of the scalar results
const char* scalars() { return viscoroll::wasm::kept(viscoroll::wasm::scalars_to_json()); }

/// @return [{"name", "unit", "description"}] of the time series of a history
const char* history_scalars() { return viscoroll::wasm::kept(viscoroll::wasm::history_scalars_to_json()); }
}
