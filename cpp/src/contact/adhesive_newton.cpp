#include "contact/adhesive_newton.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "contact/krylov.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr int kMostSteps = 200;   // three to ten are usual; more if slow edges meet moduli of 10:1
constexpr int kMostInVain = 80;   // steps that do not reduce the violation
constexpr int kMostHalvings = 6;  // of a step
// Factor by which a step may increase the violation. Edges move by about a spacing in each step; if every step had to
// reduce the violation, nodes at the edges would stop them.
constexpr double kMostIncrease = 10.0;
constexpr double kSystemTolerance = 1e-5;  // residual of a linear system, relative to that of its guess
constexpr double kSettled = 1e-11;         // violation relative to the forces; loads then agree to 1e-9 on all paths
constexpr double kAcceptable = 1e-8;       // the same if steps no longer reduce it
// Number of nodes of the window times operator applications on one mesh, some seconds, beyond which Newton's method
// ends after one step. Twelve of 300 random cases would need more, two of them more than five minutes.
constexpr double kMostEffort = 2e8;
constexpr double kUsualProducts = 500.0;  // operator applications allowed on every mesh, however large
constexpr Index kSmallSystem = 1300;      // `small_system` of GMRES, same as without adhesion

/// Stiffness of a node for forces that alternate from row to row [N/m]. It contains differences of table entries only,
/// since entries of a half-plane contain an arbitrary constant. The triangular weights keep the sum positive (Fejér).
double alternating_stiffness(const SurfaceOperator& surface) {
  constexpr int kRows = 8;
  const Table& table = surface.local().table(Entry::rr);
  const int reach = std::min(kRows, table.phi_reach());
  double compliance = 0.0;
  double weights = 0.0;
  for (int j = -reach; j <= reach; ++j) {
    const double weight = (j % 2 == 0 ? 1.0 : -1.0) * (1.0 - std::abs(j) / (reach + 1.0));
    compliance += weight * table(j, 0);
    weights += weight;
  }
  compliance -= weights * 0.5 * (table(reach, 0) + table(-reach, 0));
  return 1.0 / std::abs(compliance);
}

}  // namespace

AdhesiveNewton::AdhesiveNewton(const ContactProblem& problem, const ContactOptions& options)
    : attraction_(*problem.attraction),
      options_(options),
      mirrored_(problem.surface->takes_mirrored() && is_mirror_symmetric(problem)),
      stiffness_(alternating_stiffness(*problem.surface)),
      inverse_(normal_inverse(*problem.surface)) {}

double AdhesiveNewton::wall_force(const TractionLaw& law, const AdhesiveState& state, Index node) const {
  return state.pressing[node] + attraction_.area[node] * law.attraction(node, state.gap[node]);
}

/// A node leaves the contact if its hard wall would pull, and joins it if it overlaps. At the start, where the states
/// of the nodes are not known, the sign of wall force - stiffness * gap decides.
bool AdhesiveNewton::touches(const TractionLaw& law, const AdhesiveState& state, Index node) const {
  if (state.touches.empty()) return wall_force(law, state, node) > stiffness_ * state.gap[node];
  if (state.touches[static_cast<std::size_t>(node)] != 0) return wall_force(law, state, node) > 0.0;
  return state.gap[node] < 0.0;
}

std::vector<Index> AdhesiveNewton::touching(const TractionLaw& law, const AdhesiveState& state) const {
  std::vector<Index> nodes;
  for (Index node = 0; node < state.gap.size(); ++node) {
    if (touches(law, state, node)) nodes.push_back(node);
  }
  return nodes;
}

std::vector<Index> AdhesiveNewton::zone(const TractionLaw& law, const AdhesiveState& state) const {
  std::vector<Index> nodes;
  for (Index node = 0; node < state.gap.size(); ++node) {
    if (!touches(law, state, node) && state.gap[node] < law.range(node)) nodes.push_back(node);
  }
  return nodes;
}

/// Norm of min(wall force, stiffness * gap), which vanishes where N >= 0, g >= 0 and N g = 0.
double AdhesiveNewton::violation(const TractionLaw& law, const AdhesiveState& state) const {
  double sum = 0.0;
  for (Index node = 0; node < state.gap.size(); ++node) {
    const double least = std::min(wall_force(law, state, node), stiffness_ * state.gap[node]);
    sum += least * least;
  }
  return std::sqrt(sum);
}

/// Rows of Newton's method. In the zone, F - A q [(C F) - d] = -A sigma - A q (g - g0), divided by 1 + A q / k.
LawRows AdhesiveNewton::rows_of(const ContactProblem& problem, const TractionLaw& law,
                                const AdhesiveState& state) const {
  const Index size = state.gap.size();
  LawRows rows{
      .displacement = ArrayXd::Ones(size), .force = ArrayXd::Zero(size), .right = -stiffness_ * problem.initial_gap};
  for (Index node = 0; node < size; ++node) {
    if (touches(law, state, node)) continue;
    const double area = attraction_.area[node];
    const double gap = state.gap[node];
    const double softening = area * law.slope(node, gap);
    const double share = 1.0 / (1.0 + softening / stiffness_);
    rows.force[node] = share;
    rows.displacement[node] = share - 1.0;
    rows.right[node] = share * (-area * law.attraction(node, gap) - softening * (gap - problem.initial_gap[node]));
  }
  return rows;
}

void AdhesiveNewton::find_gap(const ContactProblem& problem, AdhesiveState& state) {
  ++products_;
  state.gap = problem.initial_gap + problem.surface->normal_displacement(state.pressing, mirrored_) - state.penetration;
}

/// Halve a step until it does not increase the violation much. Gaps are linear in the step.
AdhesiveState AdhesiveNewton::shorten(const TractionLaw& law, const AdhesiveState& from,
                                      const AdhesiveState& to) const {
  const double before = from.residual;
  AdhesiveState best = to;
  best.residual = violation(law, to);
  double step = 1.0;
  for (int i = 0; i < kMostHalvings && !(best.residual < kMostIncrease * before); ++i) {
    step *= 0.5;
    AdhesiveState tried{.pressing = from.pressing + step * (to.pressing - from.pressing),
                        .penetration = from.penetration + step * (to.penetration - from.penetration),
                        .gap = from.gap + step * (to.gap - from.gap),
                        .touches = to.touches};
    tried.residual = violation(law, tried);
    if (tried.residual < best.residual) best = std::move(tried);
  }
  return best;
}

AdhesiveState AdhesiveNewton::solve(const ContactProblem& problem, const TractionLaw& law, AdhesiveState state) {
  // The first step starts from the gaps of the given state, also if load, penetration or law have changed. It then
  // follows the tangent of the path. Gaps of the same forces at another penetration would open or close all nodes.
  if (state.gap.size() == 0) find_gap(problem, state);
  double scale = (law.peak * attraction_.area).maxCoeff();
  double least = std::numeric_limits<double>::infinity();
  int in_vain = 0;
  for (int step = 0; step < kMostSteps && systems_ < options_.max_iterations; ++step) {
    const LawRows rows = rows_of(problem, law, state);
    std::vector<Index> nodes;
    std::vector<char> touching;
    bool any_touches = false;
    for (Index node = 0; node < state.gap.size(); ++node) {
      const bool in_contact = rows.force[node] == 0.0;
      touching.push_back(in_contact ? 1 : 0);
      any_touches = any_touches || in_contact;
      if (in_contact || state.gap[node] < law.range(node)) nodes.push_back(node);
    }
    if (!any_touches) return state;
    const FlatEquations equations(problem, inverse_, nodes, mirrored_, stiffness_, nullptr, &rows);
    const KrylovSolution solution =
        solve_krylov([&](const VectorXd& vector) { return equations.times(vector); },
                     [&](const VectorXd& vector) { return equations.precondition(vector); }, equations.right_side(),
                     equations.corrected(equations.unknowns(state.pressing, state.penetration)),
                     {.absolute = 0.1 * kSettled * scale, .relative = kSystemTolerance, .small_system = kSmallSystem});
    ++systems_;
    products_ += solution.products;
    AdhesiveState next{.pressing = equations.pressing(solution.unknowns),
                       .penetration = equations.penetration(solution.unknowns)};
    if (!next.pressing.allFinite()) return state;
    find_gap(problem, next);
    next.touches = std::move(touching);
    if (step == 0) {
      state = std::move(next);
      state.residual = violation(law, state);
    } else {
      state = shorten(law, state, next);
    }
    scale = std::max(state.pressing.matrix().norm(), (law.peak * attraction_.area).maxCoeff());
    if (state.residual < kSettled * scale) {
      state.converged = true;
      break;
    }
    in_vain = state.residual < 0.9 * least ? 0 : in_vain + 1;
    least = std::min(least, state.residual);
    const double most_products = std::max(kMostEffort / static_cast<double>(state.gap.size()), kUsualProducts);
    if (in_vain >= kMostInVain || products_ > most_products) break;
  }
  state.residual /= scale;
  state.converged = state.converged || state.residual < kAcceptable;
  return state;
}

}  // namespace viscoroll::detail
