// Coefficients of rolling friction and restitution of a coated sphere on a wall, for a particle code.
#include <cstdio>
#include <exception>
#include <viscoroll/viscoroll.hpp>

namespace vr = viscoroll;

namespace {

const vr::CoatedSphere kBall{
    .core_radius = 20e-3,
    .layers = {{.thickness = 1e-3, .shear_modulus = vr::standard_linear_solid(6e6, 3e6, 2e-3), .poisson_ratio = 0.5}}};
constexpr double kRadius = 21e-3;  // [m]

/// Return T / (P R) with the torque T = dissipated power / speed: the coefficient of laws such as mu P R.
double rolling_friction(double load, double angular_speed) {
  const vr::Result result = vr::solve(kBall, {.load = load, .angular_speed = angular_speed});
  return result.dissipated_power / (angular_speed * load * kRadius);
}

/// Return the ratio of the speeds after and before a normal impact, by the velocity Verlet method.
double restitution(double mass, double speed) {
  constexpr double kStep = 1e-5;       // [s]: some hundred steps in an impact
  constexpr double kFirstLoad = 1e-6;  // [N]: the ball has just touched
  vr::RollingHistory history(
      kBall, vr::CoatedPlane{}, kFirstLoad, vr::Start::undeformed,
      {.mesh = vr::Mesh{.nodes_per_revolution = 400}, .averaged_meshes = 1, .steps_per_spacing = std::nullopt});
  double approach = history.current().penetration;
  double velocity = speed;
  double force = kFirstLoad;
  for (int step = 1; force > 0.0 || velocity > 0.0; ++step) {
    approach += (velocity - 0.5 * kStep * force / mass) * kStep;
    const vr::RollingInstant now = history.advance(kStep * step, 0.0, 0.0, std::nullopt, {}, kRadius - approach);
    velocity -= 0.5 * kStep * (force + now.load) / mass;
    force = now.load;
  }
  return -velocity / speed;
}

}  // namespace

int main() try {
  std::printf("rolling friction %.5f at 10 N and 10 rad/s\n", rolling_friction(10.0, 10.0));
  std::printf("restitution %.4f at 0.2 m/s with 0.3 kg\n", restitution(0.3, 0.2));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
