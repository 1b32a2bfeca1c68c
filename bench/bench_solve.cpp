// Whole solves from input to result, including influence tables. Each case reports its error and its time.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>
#include <vector>

#include "cases.hpp"

namespace {

using namespace viscoroll;

double relative_error(double value, double reference) { return std::abs(value / reference - 1.0); }

/// Report the effort of a solve.
void count(const Result& result, benchmark::State& state) {
  state.counters["contact_nodes"] = result.refinements.back().contact_nodes;
  state.counters["iterations"] = result.iterations;
  state.counters["operator_applications"] = result.operator_applications;
  state.counters["window"] = result.phi_nodes;
}

/// Options with the curvature and the linear theory of the paper, to which all reference values belong.
Options options_for(const Mesh& mesh, Compliance compliance) {
  return {.mesh = mesh, .compliance = compliance, .curvature = Curvature::paper, .finite_strain = false};
}

/// The paper's example, compared with the independent computation of docs/theory/reference-values.md, which has five
/// digits [N m].
void paper_example(benchmark::State& state, int nodes, int order, Compliance compliance, double reference,
                   bool finite_strain = false) {
  const CoatedSphere sphere = cases::paper_sphere();
  Options options = options_for({nodes, order}, compliance);
  options.finite_strain = finite_strain;
  Result result;
  for (auto _ : state) result = solve(sphere, cases::kRolling, options);
  state.counters["error"] = relative_error(result.resisting_torque, reference);
  state.counters["energy_balance_error"] = result.energy_balance_error;
  state.counters["contact_nodes"] = result.refinements.back().contact_nodes;
}

/// All entries of the paper's table 2, one solve each. The error is the largest relative to the printed numbers; the
/// moment arm of the paper contributes 0.3 %.
void table_2(benchmark::State& state) {
  const CoatedSphere sphere = cases::paper_sphere();
  double error = 0.0;
  for (auto _ : state) {
    for (const cases::TableEntry& entry : cases::kTable2) {
      const Options options = options_for({entry.nodes_per_revolution, entry.max_order}, Compliance::radial);
      const Result result = solve(sphere, cases::kRolling, options);
      error = std::max(error, relative_error(result.resisting_torque * 1e3, entry.torque));
    }
  }
  state.counters["error"] = error;
}

/// Coatings whose compliance depends on both orders; the error is that of the power balance.
void order_by_order(benchmark::State& state, const CoatedSphere& sphere, std::optional<int> max_order) {
  const Options options{.mesh = Mesh{500, max_order}, .compliance = Compliance::vertical};
  Result result;
  for (auto _ : state) result = solve(sphere, cases::kRolling, options);
  state.counters["error"] = result.energy_balance_error;
  state.counters["contact_nodes"] = result.refinements.back().contact_nodes;
}

/// The same coatings with a prescribed accuracy in place of a mesh.
void order_by_order_to_accuracy(benchmark::State& state, const CoatedSphere& sphere, double angular_speed,
                                double accuracy) {
  Result result;
  for (auto _ : state) result = solve(sphere, {.load = 100.0, .angular_speed = angular_speed}, {.accuracy = accuracy});
  state.counters["error"] = result.energy_balance_error;
  count(result, state);
}

/// The paper's example on fine meshes from a cold start. `nodes` give a window of 512, 1024 or 2048 nodes per side, of
/// which the contact covers 0.58. The error is relative to the converged torque [N m].
void fine_rolling(benchmark::State& state, int nodes, Compliance compliance, double reference) {
  const CoatedSphere sphere = cases::paper_sphere();
  const Options options = options_for({.nodes_per_revolution = nodes}, compliance);
  Result result;
  for (auto _ : state) result = solve(sphere, cases::kRolling, options);
  state.counters["error"] = relative_error(result.resisting_torque, reference);
  count(result, state);
}

/// A rough surface on 1024 nodes per side slides on a half-space of rubber; the error is the difference of the friction
/// coefficients from tractions and power, relative to the rms slope.
void sliding(benchmark::State& state, double pressure, double speed) {
  const HeightMap map = cases::rough_surface(1024);
  const CoatedPlane block{.base =
                              HalfSpace{.shear_modulus = standard_linear_solid(10e6, 1e6, 0.01), .poisson_ratio = 0.5}};
  SlidingResult result;
  for (auto _ : state) result = slide(map, block, pressure, speed);
  state.counters["error"] = result.friction_error / 0.1;
  state.counters["contact_nodes"] = result.contact_share * static_cast<double>(map.heights.size());
  state.counters["iterations"] = result.iterations;
  state.counters["operator_applications"] = result.operator_applications;
}

/// Friction of 0.3 on a window of 256 nodes per side, from a cold start; the error is that of the power balance.
void fine_friction(benchmark::State& state, int nodes) {
  const CoatedSphere sphere = cases::paper_sphere();
  const Options options{.mesh = Mesh{.nodes_per_revolution = nodes}};
  Result result;
  for (auto _ : state) result = solve(sphere, {.load = 100.0, .angular_speed = 0.2, .friction = 0.3}, options);
  state.counters["error"] = result.energy_balance_error;
  count(result, state);
}

/// Prescribed accuracy; the error is relative to the converged torque [N m].
void to_accuracy(benchmark::State& state, double accuracy, Compliance compliance, double reference) {
  const CoatedSphere sphere = cases::paper_sphere();
  Result result;
  for (auto _ : state) {
    result =
        solve(sphere, cases::kRolling, {.accuracy = accuracy, .compliance = compliance, .curvature = Curvature::paper});
  }
  state.counters["error"] = relative_error(result.resisting_torque, reference);
  state.counters["energy_balance_error"] = result.energy_balance_error;
  state.counters["contact_nodes"] = result.refinements.back().contact_nodes;
}

/// A strong memory, refined to 0.1 %; the error is that of the power balance.
void kelvin_voigt(benchmark::State& state, double viscosity, const LoadCase& rolling, Compliance compliance) {
  const CoatedSphere sphere = cases::kelvin_voigt(viscosity);
  Result result;
  for (auto _ : state) result = solve(sphere, rolling, {.accuracy = 1e-3, .compliance = compliance});
  state.counters["error"] = result.energy_balance_error;
  count(result, state);
}

/// Friction from a cold start at Omega = 0.2 rad/s (section 14.3 of the paper), for one coefficient; the error is that
/// of the power balance.
void friction(benchmark::State& state, double coefficient, int nodes) {
  const CoatedSphere sphere = cases::paper_sphere();
  const Options options = options_for({nodes, nodes}, Compliance::vertical);
  Result result;
  for (auto _ : state) {
    result = solve(sphere, {.load = 100.0, .angular_speed = 0.2, .friction = coefficient}, options);
  }
  state.counters["error"] = result.energy_balance_error;
  count(result, state);
}

/// A ball whose coating takes up half of the radius, on the exact sphere or with an approximate curvature. The error is
/// relative to the torque of the exact sphere on meshes of up to 1600 nodes per revolution [N m].
void thick_coating(benchmark::State& state, Curvature curvature, int nodes, double coefficient, double reference) {
  const CoatedSphere sphere = cases::thick_coating();
  const Options options{
      .mesh = Mesh{.nodes_per_revolution = nodes}, .compliance = Compliance::radial, .curvature = curvature};
  Result result;
  for (auto _ : state) {
    result = solve(sphere, {.load = 100.0, .angular_speed = 2.5, .friction = coefficient}, options);
  }
  state.counters["error"] = relative_error(result.driving_torque, reference);
  state.counters["energy_balance_error"] = result.energy_balance_error;
  count(result, state);
}

/// Sixteen coefficients from 0.01 to 2 with one set of tables; the error is the largest of the power balance.
void friction_sweep(benchmark::State& state) {
  double error = 0.0;
  for (auto _ : state) {
    const RollingModel model(cases::paper_sphere(), 0.2, {500, 500});
    for (int i = 0; i < 16; ++i) {
      const double coefficient = 0.01 * std::pow(200.0, i / 15.0);
      const Result result = model.solve({.load = 100.0, .angular_speed = 0.2, .friction = coefficient});
      error = std::max(error, result.energy_balance_error);
    }
  }
  state.counters["error"] = error;
}

/// 200 speeds from 0.05 to 25 rad/s and ten loads from 10 to 100 N at pi/250, with one speed per thread; the error is
/// that of the paper's example, which is one of the cases.
void speed_sweep(benchmark::State& state) {
  constexpr int kExample = 125;  // number of the example's speed
  const CoatedSphere sphere = cases::paper_sphere();
  const Options options{.compliance = Compliance::radial, .threads = 1};
  std::atomic<int> next{0};
  std::atomic<int> contact_nodes{0};
  std::atomic<int> iterations{0};
  std::atomic<int> applications{0};
  double torque = 0.0;
  const auto work = [&] {
    for (int i = next++; i < 200; i = next++) {
      const double speed = 2.5 * std::pow(500.0, (i - kExample) / 199.0);
      const RollingModel model(sphere, speed, {500, 500}, 1, Curvature::paper);
      for (int load = 10; load <= 100; load += 10) {
        const Result result = model.solve({.load = 1.0 * load, .angular_speed = speed}, options);
        if (i == kExample && load == 100) torque = result.resisting_torque;
        contact_nodes += result.refinements.back().contact_nodes;
        iterations += result.iterations;
        applications += result.operator_applications;
      }
    }
  };
  for (auto _ : state) {
    next = 0;
    std::vector<std::jthread> threads;
    for (int i = 0; i < core_count(); ++i) threads.emplace_back(work);
  }
  state.counters["error"] = relative_error(torque, 11.348e-3);
  state.counters["contact_nodes"] = contact_nodes.load() / 2000.0;  // average
  state.counters["iterations"] = iterations.load();
  state.counters["operator_applications"] = applications.load();
}

/// A crowned wheel to 1 % with a new tread. The error is relative to the torque of fine meshes [N m], or without it
/// that of the power balance.
void wheel(benchmark::State& state, Sides sides, std::optional<double> reference) {
  Result result;
  int number = 0;
  for (auto _ : state) {
    result = solve(cases::crowned_wheel(sides, number++), cases::kWheelRolling, {.accuracy = 0.01});
  }
  state.counters["error"] =
      reference ? relative_error(result.resisting_torque, *reference) : result.energy_balance_error;
  state.counters["energy_balance_error"] = result.energy_balance_error;
  count(result, state);
}

/// The same wheel under loads from 400 to 600 N, with a tread that is in the store; the error is that of the power
/// balance.
void wheel_next_load(benchmark::State& state, Sides sides) {
  const CoatedWheel tread = cases::crowned_wheel(sides);
  LoadCase rolling = cases::kWheelRolling;
  Result result = solve(tread, rolling, {.accuracy = 0.01});
  int number = 0;
  for (auto _ : state) {
    rolling.load = 400.0 + 200.0 * std::fmod(0.618 * ++number, 1.0);
    result = solve(tread, rolling, {.accuracy = 0.01});
  }
  state.counters["error"] = result.energy_balance_error;
  count(result, state);
}

/// Twenty speeds from 0.25 to 25 rad/s with a new tread; the error is the largest of the power balance.
void wheel_speeds(benchmark::State& state, Sides sides) {
  double error = 0.0;
  int number = 1000;
  for (auto _ : state) {
    const CoatedWheel tread = cases::crowned_wheel(sides, number++);
    for (int i = 0; i < 20; ++i) {
      const LoadCase rolling{.load = 500.0, .angular_speed = 0.25 * std::pow(100.0, i / 19.0)};
      error = std::max(error, solve(tread, rolling, {.accuracy = 0.01}).energy_balance_error);
    }
  }
  state.counters["error"] = error;
}

/// The paper's example at pi/800, solved outside the timed region.
struct SolvedExample {
  CoatedSphere sphere = cases::paper_sphere();
  Options options{.mesh = Mesh{.nodes_per_revolution = 1600}};
  Result result = solve(sphere, cases::kRolling, options);
  Tractions tractions = tractions_of(sphere, result, cases::kRolling, options);
};

/// Fields at ten depths, 0.1 h to h, on all nodes of the window; the error is that of the largest pressure on the core
/// or the base, relative to an independent computation.
/// @param[in] surface,bottom positions of the faces of the layer [m]
void fields_at_depths(benchmark::State& state, const LayeredShape& shape, const Tractions& tractions, double surface,
                      double bottom, double angular_speed, double pressure_below) {
  std::vector<double> positions;
  for (int i = 1; i < 10; ++i) positions.push_back(surface + 0.1 * (bottom - surface) * i);
  positions.push_back(bottom);
  const auto places = places_at(shape, positions);
  const auto angles_of = [&](int count) {
    std::vector<double> angles;
    for (int i = -(count / 2); i <= count / 2; ++i) {
      angles.push_back(0.5 * std::numbers::pi + i * phi_spacing(tractions.mesh));
    }
    return angles;
  };
  const std::vector<double> phi = angles_of(tractions.phi_nodes);
  const std::vector<double> theta = angles_of(tractions.theta_nodes);
  InteriorFields fields;
  for (auto _ : state) fields = interior_fields(shape, angular_speed, tractions, places, phi, theta);
  const auto size = static_cast<std::ptrdiff_t>(phi.size() * theta.size());
  const auto deepest = fields.values.begin() + (9 * static_cast<std::ptrdiff_t>(kFieldComponents) + 3) * size;
  state.counters["error"] = relative_error(*std::min_element(deepest, deepest + size), pressure_below);
  state.counters["nodes"] = static_cast<double>(size);
}

/// Example of the paper, -7.41 MPa on the core (three digits).
void fields_inside(benchmark::State& state) {
  const SolvedExample example;
  fields_at_depths(state, example.sphere, example.tractions, 21e-3, example.sphere.core_radius, 2.5, -7.41e6);
}

/// A mat with the example's layer under a rigid ball of the same size, -7.40 MPa on the base (three digits).
void fields_inside_mat(benchmark::State& state) {
  const CoatedSphere ball{.core_radius = 21e-3};
  const CoatedPlane mat{.layers = cases::paper_sphere(0.0).layers};
  const Options options{.mesh = Mesh{.nodes_per_revolution = 1600}};
  const Result result = solve(ball, mat, cases::kRolling, options);
  Tractions tractions = tractions_of(ball, result, cases::kRolling, options);
  tractions.counterbody = true;
  fields_at_depths(state, mat, tractions, 0.0, -1e-3, 2.5, -7.40e6);
}

/// A roller of 50 + 10 mm of this material, -0.38140 MPa on the core (five digits).
void fields_inside_roller(benchmark::State& state) {
  const CoatedCylinder roller{.core_radius = 50e-3, .layers = cases::paper_sphere(0.0, 10e-3).layers};
  const LoadCase rolling{.load = 5e3, .angular_speed = 1.0};
  const Options options{.mesh = Mesh{.nodes_per_revolution = 24000}};
  const Result result = solve(roller, rolling, options);
  fields_at_depths(state, roller, tractions_of(roller, result, rolling, options), 60e-3, 50e-3, 1.0, -0.38140e6);
}

/// Loss density of all relevant orders; the error is the difference between its volume integral and the power input.
void loss_inside(benchmark::State& state) {
  const SolvedExample example;
  LossDensity loss;
  for (auto _ : state) loss = loss_density(example.sphere, 2.5, example.tractions, {}, 320);
  state.counters["error"] = relative_error(loss.volume_power, loss.surface_power);
}

/// A revolution at 2.5 rad/s from an undeformed start, without the time of the tables. The error is that of the steady
/// torque, `kRadialTorque`, averaged over the last spacing; with friction, it is relative to the limit of meshes of
/// 1600 and 3200 nodes per revolution.
void revolution(benchmark::State& state, int nodes, int averaged_meshes, int threads, double friction = 0.0,
                double steady_torque = 11.3867e-3) {
  constexpr double kSpeed = 2.5;
  constexpr double kTurn = 6.283185307179586;
  const RollingHistory undeformed(
      cases::paper_sphere(), 100.0, Start::undeformed,
      {.mesh = Mesh{nodes}, .friction = friction, .averaged_meshes = averaged_meshes, .threads = threads});
  double torque = 0.0;
  double steps = 0.0;
  for (auto _ : state) {
    RollingHistory history(undeformed);
    const auto instants = roll(history, {.time = {0.0, kTurn / kSpeed}, .angle = {0.0, kTurn}, .load = {100.0, 100.0}});
    steps = static_cast<double>(history.steps());
    torque = 0.0;
    for (std::size_t i = 0; i < 4; ++i) torque += instants[instants.size() - 1 - i].resisting_torque / 4.0;
  }
  state.counters["error"] = relative_error(torque, steady_torque);
  state.counters["steps"] = steps;
  state.counters["steps_per_second"] = benchmark::Counter(steps, benchmark::Counter::kIsIterationInvariantRate);
}

/// The first `turn` [rad] of a body that has supported its load permanently, on one mesh and one thread, without the
/// time of the tables. The error is that of the moment over the last spacing, relative to the steady moment of an
/// independent program.
void start_rolling(benchmark::State& state, const RollingBody& body, const Counterbody& on, const LoadCase& rolling,
                   int nodes, double turn, double steady_moment) {
  const double load = rolling.load.value();
  const RollingHistory still(body, on, load, Start::relaxed,
                             {.mesh = Mesh{nodes}, .friction = rolling.friction, .averaged_meshes = 1, .threads = 1});
  const Motion motion{.time = {0.0, turn / rolling.angular_speed}, .angle = {0.0, turn}, .load = {load, load}};
  double steps = 0.0;
  double moment = 0.0;
  for (auto _ : state) {
    RollingHistory history(still);
    const auto instants = roll(history, motion);
    steps = static_cast<double>(history.steps());
    moment = 0.0;
    for (std::size_t i = 0; i < 4; ++i) moment += instants[instants.size() - 1 - i].resisting_torque / 4.0;
  }
  state.counters["error"] = relative_error(moment, steady_moment);
  state.counters["steps"] = steps;
  state.counters["steps_per_second"] = benchmark::Counter(steps, benchmark::Counter::kIsIterationInvariantRate);
}

const CoatedSphere kSteel{.core_radius = 21e-3, .layers = {}};
const LoadCase kRubbing{.load = 100.0, .angular_speed = 2.5, .friction = 0.3};
constexpr double kFiftyMillimeters = 50.0 / 21.0;  // travel of the steel ball [rad]

constexpr auto kUnit = benchmark::kMillisecond;

BENCHMARK(fields_inside)->Unit(kUnit)->UseRealTime();
BENCHMARK(fields_inside_mat)->Unit(kUnit)->UseRealTime();
BENCHMARK(fields_inside_roller)->Unit(kUnit)->UseRealTime();
BENCHMARK(loss_inside)->Unit(kUnit)->UseRealTime();

BENCHMARK_CAPTURE(paper_example, pi_250_N_500, 500, 500, Compliance::radial, 11.348e-3)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(paper_example, pi_250_N_500_finite_strain, 500, 500, Compliance::radial, 11.348e-3, true)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(paper_example, pi_400_N_1500, 800, 1500, Compliance::radial, 11.412e-3)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(paper_example, pi_250_N_500_vertical, 500, 500, Compliance::vertical, 11.130e-3)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK(table_2)->Unit(kUnit)->UseRealTime()->Iterations(1);
BENCHMARK_CAPTURE(order_by_order, dissimilar_layers, cases::dissimilar_layers(), 500)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(order_by_order, dissimilar_layers_all_orders, cases::dissimilar_layers(), std::nullopt)
    ->Unit(kUnit)
    ->UseRealTime();
// The squared Mach number is 0.5 (docs/theory/inertia.md), where its series is not applicable.
BENCHMARK_CAPTURE(order_by_order, fast_rolling, cases::paper_sphere(0.45 * 6e6 / (2.5 * 2.5 * 20e-3 * 20e-3), 5e-3),
                  500)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(order_by_order_to_accuracy, dissimilar_layers, cases::dissimilar_layers(), 2.5, 1e-3)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(order_by_order_to_accuracy, stiff_skin, cases::stiff_skin(), 2.5, 1e-3)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(order_by_order_to_accuracy, measured, cases::measured_skin(), 2.5, 0.01)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(order_by_order_to_accuracy, without_inertia, cases::paper_sphere(0.0), 100.0, 0.01)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(order_by_order_to_accuracy, with_inertia, cases::paper_sphere(), 100.0, 0.01)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(friction, mu_03_pi_250, 0.3, 500)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(friction, mu_001_pi_250, 0.01, 500)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(friction, mu_03_pi_400, 0.3, 800)->Unit(kUnit)->UseRealTime();
BENCHMARK(friction_sweep)->Unit(kUnit)->UseRealTime()->Iterations(1);
BENCHMARK(speed_sweep)->Unit(kUnit)->UseRealTime()->Iterations(1);
// Result on meshes of 3200 nodes per revolution.
constexpr double kUnboundedWheelTorque = 247.82e-3;
BENCHMARK_CAPTURE(wheel, unbounded, Sides::unbounded, kUnboundedWheelTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(wheel, free, Sides::free, std::nullopt)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(wheel_next_load, unbounded, Sides::unbounded)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(wheel_next_load, free, Sides::free)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(wheel_speeds, unbounded, Sides::unbounded)->Unit(kUnit)->UseRealTime()->Iterations(1);
BENCHMARK_CAPTURE(wheel_speeds, free, Sides::free)->Unit(kUnit)->UseRealTime()->Iterations(1);
// Results on meshes of 1600 nodes per revolution without friction, and 800 with friction.
constexpr double kThickTorque = 52.74e-3;
constexpr double kThickFrictionTorque = 52.80e-3;
BENCHMARK_CAPTURE(thick_coating, paper, Curvature::paper, 800, 0.0, kThickTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(thick_coating, sphere, Curvature::sphere, 800, 0.0, kThickTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(thick_coating, exact_200, Curvature::exact, 200, 0.0, kThickTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(thick_coating, exact_400, Curvature::exact, 400, 0.0, kThickTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(thick_coating, exact_800, Curvature::exact, 800, 0.0, kThickTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(thick_coating, exact_200_friction, Curvature::exact, 200, 0.3, kThickFrictionTorque)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(thick_coating, exact_400_friction, Curvature::exact, 400, 0.3, kThickFrictionTorque)
    ->Unit(kUnit)
    ->UseRealTime();
constexpr double kRadialTorque = 11.3867e-3;    // meshes of pi/6600 and finer
constexpr double kVerticalTorque = 11.1854e-3;  // same meshes
BENCHMARK_CAPTURE(to_accuracy, one_percent, 0.01, Compliance::vertical, kVerticalTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(to_accuracy, one_thousandth, 1e-3, Compliance::vertical, kVerticalTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(to_accuracy, one_thousandth_radial, 1e-3, Compliance::radial, kRadialTorque)
    ->Unit(kUnit)
    ->UseRealTime();
const LoadCase kSlowRolling{.load = 50.0, .angular_speed = 1.0};
BENCHMARK_CAPTURE(kelvin_voigt, 50_ms_radial, 1.5e5, cases::kRolling, Compliance::radial)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(kelvin_voigt, 50_ms_vertical, 1.5e5, cases::kRolling, Compliance::vertical)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(kelvin_voigt, 10_ms_radial, 3e4, kSlowRolling, Compliance::radial)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(kelvin_voigt, 10_ms_vertical, 3e4, kSlowRolling, Compliance::vertical)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(fine_rolling, 512, 7332, Compliance::radial, kRadialTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(fine_rolling, 1024, 14684, Compliance::radial, kRadialTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(fine_rolling, 2048, 29460, Compliance::radial, kRadialTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(fine_rolling, 512_vertical, 7332, Compliance::vertical, kVerticalTorque)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(fine_rolling, 1024_vertical, 14684, Compliance::vertical, kVerticalTorque)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(fine_rolling, 2048_vertical, 29460, Compliance::vertical, kVerticalTorque)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(sliding, 1024_elastic, 8e3, 0.0)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(sliding, 1024_memory, 6e4, 1e-3)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(revolution, 300_one_lattice, 300, 1, 1)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(revolution, 500_one_lattice, 500, 1, 1)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(revolution, 1000_one_lattice, 1000, 1, 1)->Unit(kUnit)->UseRealTime()->Iterations(1);
BENCHMARK_CAPTURE(revolution, 300, 300, 4, 2)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(revolution, 500, 500, 4, 2)->Unit(kUnit)->UseRealTime();
BENCHMARK_CAPTURE(revolution, 300_friction_one_lattice, 300, 1, 1, 0.3, 10.099e-3)->Unit(kUnit)->UseRealTime();
// Q = M / r_o of 532.0 and M of 40.136 mN m are limits of three meshes, and 2.4563 N is that of meshes of 500 to 2000
// nodes.
BENCHMARK_CAPTURE(start_rolling, ball_on_mat_300, kSteel, cases::mat(false), cases::kRolling, 300, kFiftyMillimeters,
                  532.0e-3 * 21e-3)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(start_rolling, ball_on_dissimilar_layers_300, kSteel, cases::mat(true), cases::kRolling, 300,
                  kFiftyMillimeters, 40.136e-3)
    ->Unit(kUnit)
    ->UseRealTime();
// Limits of the steady solver with friction on 800 to 3200 nodes; a ball does not slip on an identical one.
BENCHMARK_CAPTURE(start_rolling, ball_on_mat_300_friction, kSteel, cases::mat(false), kRubbing, 300, kFiftyMillimeters,
                  9.340e-3)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(start_rolling, two_balls_300, cases::paper_sphere(0.0), cases::paper_sphere(0.0), cases::kRolling,
                  300, 1.0, 11.407e-3)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(start_rolling, two_balls_300_friction, cases::paper_sphere(0.0), cases::paper_sphere(0.0), kRubbing,
                  300, 1.0, 11.407e-3)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(start_rolling, roller_1000, cases::roller(), CoatedPlane{},
                  LoadCase{.load = 5e3, .angular_speed = 1.0}, 1000, 1.5, 2.4563)
    ->Unit(kUnit)
    ->UseRealTime();
BENCHMARK_CAPTURE(fine_friction, 256, 3650)->Unit(kUnit)->UseRealTime();

}  // namespace
