#include "contact/coating_operators.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "influence/patch.hpp"

namespace viscoroll::detail {
namespace {

using Components = std::array<Eigen::ArrayXd, 3>;

std::size_t components(const Formulation& formulation) { return formulation.compliance == Compliance::radial ? 1 : 3; }

int shapes(const Formulation& formulation) { return formulation.patch_load == PatchLoad::flat ? 1 : kPatchShapes; }

TableRequest displacement_request(Entry entry, int source) { return {.entry = entry, .source_shape = source}; }

/// Power between patch shapes whose degrees add up to 2 at most, as exact as the displacements.
std::vector<std::pair<int, int>> shape_pairs(const Formulation& formulation) {
  std::vector<std::pair<int, int>> pairs;
  for (int receiver = 0; receiver < shapes(formulation); ++receiver) {
    for (int source = 0; source + receiver < shapes(formulation); ++source) pairs.emplace_back(receiver, source);
  }
  return pairs;
}

/// Exchanging the degrees conjugates i^(receiver - source): one table serves both.
TableRequest power_request(Entry entry, int receiver, int source) {
  return {.entry = entry,
          .source_shape = std::max(receiver, source),
          .power = true,
          .receiver_shape = std::min(receiver, source)};
}

double power_sign(int receiver, int source) { return receiver > source && (receiver - source) % 2 == 1 ? -1.0 : 1.0; }

/// Adds terms for the products left_P C_PQ right_Q over all components.
class OperatorBuilder {
 public:
  OperatorBuilder(const Formulation& formulation, const SurfaceWindow& window,
                  std::shared_ptr<const std::vector<Table>> tables)
      : formulation_(formulation),
        window_(window),
        requests_(required_tables(formulation)),
        tables_(std::move(tables)) {
    const Eigen::Index count = window.shape().size();
    for (int shape = 0; shape < shapes(formulation); ++shape) {
      weights_.push_back(formulation.patch_load == PatchLoad::flat ? Eigen::ArrayXd::Ones(count)
                                                                   : spherical_weights(shape));
    }
    down_ = formulation.compliance == Compliance::radial ? Components{Eigen::ArrayXd::Ones(count)} : window.down();
  }

  [[nodiscard]] ScaledConvolution displacement(const Components& direction) const {
    Parts parts;
    for (std::size_t p = 0; p < components(formulation_); ++p) {
      const std::size_t left = parts.add(direction[p]);
      for (std::size_t q = 0; q < components(formulation_); ++q) {
        const auto [entry, sign] = entry_of(p, q);
        for (int source = 0; source < shapes(formulation_); ++source) {
          parts.terms.push_back({.left = left,
                                 .table = index_of(displacement_request(entry, source)),
                                 .right = parts.add(loaded(q, source)),
                                 .sign = sign});
        }
      }
    }
    return finish(std::move(parts));
  }

  [[nodiscard]] ScaledConvolution vertical() const { return displacement(down_); }

  [[nodiscard]] ScaledConvolution backward() const {
    if (formulation_.compliance == Compliance::radial) return finish({});
    return displacement(window_.backward());
  }

  [[nodiscard]] ScaledConvolution power() const {
    Parts parts;
    for (const auto& [receiver, source] : shape_pairs(formulation_)) {
      for (std::size_t p = 0; p < components(formulation_); ++p) {
        const std::size_t left = parts.add(loaded(p, receiver));
        for (std::size_t q = 0; q < components(formulation_); ++q) {
          const auto [entry, sign] = entry_of(p, q);
          parts.terms.push_back({.left = left,
                                 .table = index_of(power_request(entry, receiver, source)),
                                 .right = parts.add(loaded(q, source)),
                                 .sign = sign * power_sign(receiver, source)});
        }
      }
    }
    return finish(std::move(parts));
  }

 private:
  struct Parts {
    std::vector<Eigen::ArrayXd> scalings;
    std::vector<ScaledConvolution::Term> terms;

    /// Number of a scaling, which is stored once.
    std::size_t add(const Eigen::ArrayXd& scaling) {
      const auto same = std::find_if(scalings.begin(), scalings.end(),
                                     [&](const Eigen::ArrayXd& other) { return (other == scaling).all(); });
      if (same != scalings.end()) return static_cast<std::size_t>(same - scalings.begin());
      scalings.push_back(scaling);
      return scalings.size() - 1;
    }
  };

  [[nodiscard]] ScaledConvolution finish(Parts parts) const {
    return {window_.shape(), tables_, std::move(parts.scalings), std::move(parts.terms)};
  }

  /// Share of a unit vertical force at each node that goes into component q and patch shape `shape`.
  [[nodiscard]] Eigen::ArrayXd loaded(std::size_t q, int shape) const {
    return down_[q] * weights_[static_cast<std::size_t>(shape)];
  }

  [[nodiscard]] Eigen::ArrayXd spherical_weights(int shape) const {
    return window_.theta().unaryExpr([&](double theta) {
      return spherical_patch_weights(theta, window_.spacing())[static_cast<std::size_t>(shape)];
    });
  }

  [[nodiscard]] std::size_t index_of(const TableRequest& request) const {
    return static_cast<std::size_t>(std::find(requests_.begin(), requests_.end(), request) - requests_.begin());
  }

  Formulation formulation_;
  const SurfaceWindow& window_;
  std::vector<TableRequest> requests_;
  std::shared_ptr<const std::vector<Table>> tables_;
  std::vector<Eigen::ArrayXd> weights_;  // of the patch shapes
  Components down_;
};

}  // namespace

std::vector<TableRequest> required_tables(const Formulation& formulation) {
  std::vector<TableRequest> requests;
  for (std::size_t p = 0; p < components(formulation); ++p) {
    for (std::size_t q = p; q < components(formulation); ++q) {
      const Entry entry = entry_of(p, q).entry;
      for (int source = 0; source < shapes(formulation); ++source) {
        requests.push_back(displacement_request(entry, source));
      }
      for (const auto& [receiver, source] : shape_pairs(formulation)) {
        if (receiver <= source) requests.push_back(power_request(entry, receiver, source));
      }
    }
  }
  return requests;
}

CoatingOperators make_operators(const Formulation& formulation, const SurfaceWindow& window,
                                std::shared_ptr<const std::vector<Table>> tables) {
  const OperatorBuilder builder(formulation, window, std::move(tables));
  return {.vertical = builder.vertical(), .backward = builder.backward(), .power = builder.power()};
}

}  // namespace viscoroll::detail
