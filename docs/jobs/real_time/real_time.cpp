// What a loop that runs in real time can afford, on one thread: solves, steps of a history, and values of a fitted
// torque.
//
//     real_time [torque.json]
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <viscoroll/viscoroll.hpp>

namespace vr = viscoroll;

namespace {

constexpr double kRadius = 21e-3;  // [m]
constexpr double kLoad = 100.0;    // [N]
constexpr double kSpeed = 2.5;     // [rad/s]

/// How often a second of this thread's processor bears something, called with 0, 1, 2 ... until half a second is over.
template <class Work>
double rate(const Work& work) {
  const std::clock_t start = std::clock();
  int count = 0;
  while (std::clock() - start < CLOCKS_PER_SEC / 2) work(count++);
  return count * static_cast<double>(CLOCKS_PER_SEC) / static_cast<double>(std::clock() - start);
}

}  // namespace

int main(int argc, char** argv) try {
  const vr::CoatedSphere ball{
      .core_radius = kRadius - 1e-3,
      .layers = {
          {.thickness = 1e-3, .shear_modulus = vr::standard_linear_solid(6e6, 3e6, 0.125), .poisson_ratio = 0.5}}};

  // Steady rolling under a load that changes: tables of a speed are made once.
  const vr::RollingModel model(ball, kSpeed, vr::Mesh{.nodes_per_revolution = 150}, 1);
  double torque = 0.0;
  const double solves = rate([&](int i) {
    const vr::LoadCase now{.load = kLoad + i % 10, .angular_speed = kSpeed};
    torque = model.solve(now, {.threads = 1}).resisting_torque;
  });
  std::printf("%8.0f solves a second at 150 nodes a revolution, the last %.2f mN m\n", solves, torque * 1e3);

  // A ball on its way, a millisecond at a time, which remembers where it was.
  vr::RollingHistory history(
      ball, kLoad, vr::Start::relaxed,
      {.mesh = vr::Mesh{.nodes_per_revolution = 200}, .lattices = 1, .steps_per_spacing = std::nullopt, .threads = 1});
  const double steps = rate([&](int i) {
    const double time = 1e-3 * (i + 1);
    torque = history.advance(time, kSpeed * time, kLoad + i % 10).resisting_torque;
  });
  std::printf("%8.0f steps of a history a second at 200 nodes a revolution, the last %.2f mN m\n", steps, torque * 1e3);

  // The torque of steady rolling as a function, which Python fitted over load and speed.
  if (argc > 1) {
    std::ifstream file(argv[1]);
    if (!file) throw std::runtime_error(std::string(argv[1]) + " cannot be read");
    const auto surface = nlohmann::json::parse(file).get<vr::RollingResistance>();
    const double values =
        rate([&](int i) { torque = vr::resisting_torque(surface, kLoad - i % 10, kSpeed, vr::Extrapolation::hold); });
    std::printf("%8.1f million values of the surface a second, the last %.2f mN m to %.1f %%\n", values * 1e-6,
                torque * 1e3, surface.largest_error * 100.0);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
