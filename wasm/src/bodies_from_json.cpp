#include "bodies_from_json.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "modulus_from_json.hpp"

namespace viscoroll::wasm {

template <>
inline constexpr auto kNames<InnerBoundary> = std::to_array<Name<InnerBoundary>>({
#define VISCOROLL_INNER_BOUNDARY(name, NAME, details, is_core, is_free) {#name, InnerBoundary::name},
#include "viscoroll/inner_boundaries.def"
#undef VISCOROLL_INNER_BOUNDARY
});
template <>
inline constexpr auto kNames<Hub> = std::to_array<Name<Hub>>({{"straight", Hub::straight}, {"crowned", Hub::crowned}});
template <>
inline constexpr auto kNames<Sides> =
    std::to_array<Name<Sides>>({{"free", Sides::free}, {"unbounded", Sides::unbounded}});

namespace {

ShearModulus take_modulus(Table& table, const char* key) {
  const Json& given = table.require(key);
  return given.is_null() ? ShearModulus{} : modulus_from_json(given, table.path_of(key));
}

std::vector<Layer> take_layers(Table& table, const char* key);
std::optional<HalfSpace> take_half_space(Table& table, const char* key);

/// Reader of the parameters of bodies, layers and half-spaces.
struct Reader {
  Table& table;

  template <class Value>
  Value operator()(const char* key, Value otherwise, bool is_optional) const {
    if constexpr (std::is_same_v<Value, ShearModulus>) {
      return take_modulus(table, key);
    } else if constexpr (std::is_same_v<Value, std::vector<Layer>>) {
      return take_layers(table, key);
    } else if constexpr (std::is_same_v<Value, std::optional<HalfSpace>>) {
      return take_half_space(table, key);
    } else if constexpr (std::is_same_v<Value, CoatedPlane>) {
      return read_fields<CoatedPlane>(*this);  // a groove has the keys of its surface
    } else {
      return table.value(key, std::move(otherwise), is_optional);
    }
  }
};

Layer layer_from_json(const Json& json, const std::string& path) {
  Table table(json, path);
  Layer layer = read_fields<Layer>(Reader{table});
  // Case files may contain the conductivity for temperatures, which this module does not compute.
  (void)table.maybe_number("conductivity");
  table.close();
  at_path(path, [&] { validate(layer, ""); });
  return layer;
}

std::vector<Layer> take_layers(Table& table, const char* key) {
  const Json* given = table.take(key);
  if (given == nullptr) return {};
  const std::string path = table.path_of(key);
  if (!given->is_array()) {
    throw InvalidInput(path, "must be a valid list", shown(*given));
  }
  std::vector<Layer> layers;
  layers.reserve(given->size());
  for (const Json& layer : *given) {
    layers.push_back(layer_from_json(layer, path + "[" + std::to_string(layers.size()) + "]"));
  }
  return layers;
}

std::optional<HalfSpace> take_half_space(Table& table, const char* key) {
  const Json* given = table.take(key);
  if (given == nullptr) return std::nullopt;
  Table content(*given, table.path_of(key));
  HalfSpace half_space = read_fields<HalfSpace>(Reader{content});
  content.close();
  at_path(content.path(), [&] { validate(CoatedPlane{.layers = {}, .base = half_space}); });
  return half_space;
}

template <class Kind, class Body>
Kind body_from_json(Table& table) {
  Body body = read_fields<Body>(Reader{table});
  table.close();
  at_path(table.path(), [&] { validate(body); });
  return body;
}

constexpr auto kBodies = std::to_array<Name<RollingBody (*)(Table&)>>({
    {"ball", body_from_json<RollingBody, CoatedSphere>},
    {"cylinder", body_from_json<RollingBody, CoatedCylinder>},
    {"wheel", body_from_json<RollingBody, CoatedWheel>},
});
constexpr auto kCounterbodies = std::to_array<Name<Counterbody (*)(Table&)>>({
    {"plane", body_from_json<Counterbody, CoatedPlane>},
    {"groove", body_from_json<Counterbody, Groove>},
    {"other_ball", body_from_json<Counterbody, CoatedSphere>},
    {"other_cylinder", body_from_json<Counterbody, CoatedCylinder>},
    {"other_wheel", body_from_json<Counterbody, CoatedWheel>},
});

template <class Kind, std::size_t kCount>
std::vector<Name<Kind>> take_given(Table& file, const std::array<Name<Kind (*)(Table&)>, kCount>& kinds) {
  std::vector<Name<Kind>> given;
  for (const auto& [name, from_json] : kinds) {
    const Json* content = file.take(name);
    if (content == nullptr) continue;
    Table table(*content, file.path_of(name));
    given.push_back({name, from_json(table)});
  }
  return given;
}

}  // namespace

Pair pair_from_json(Table& file) {
  auto bodies = take_given(file, kBodies);
  auto counterbodies = take_given(file, kCounterbodies);
  if (bodies.size() != 1) {
    throw std::invalid_argument("exactly one of " + names_of(kBodies) + " must be given, got " +
                                (bodies.empty() ? "none" : names_of(bodies, " and ")));
  }
  if (counterbodies.size() > 1) {
    throw std::invalid_argument("at most one of " + names_of(kCounterbodies) + " may be given, got " +
                                names_of(counterbodies, " and "));
  }
  Pair pair{.body = std::move(bodies.front().value), .on = CoatedPlane{}};
  if (!counterbodies.empty()) pair.on = std::move(counterbodies.front().value);
  return pair;
}

}  // namespace viscoroll::wasm
