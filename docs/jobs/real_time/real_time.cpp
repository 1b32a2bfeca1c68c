// Measure how many steady solves, history steps and values of a fitted torque one thread computes per second.
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

/// Return the number of calls work(0), work(1), ... per second of processor time, measured over half a second.
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

  // Steady rolling under a changing load: the tables for this speed are computed once.
  const vr::RollingModel model(ball, kSpeed, vr::Mesh{.nodes_per_revolution = 150}, 1);
  double torque = 0.0;
  const double solves = rate([&](int i) {
    const vr::LoadCase now{.load = kLoad + i % 10, .angular_speed = kSpeed};
    torque = model.solve(now, {.threads = 1}).resisting_torque;
  });
  std::printf("%8.0f steady solves per second at 150 nodes per revolution, last torque %.2f mN m\n", solves,
              torque * 1e3);

  // A transient motion in steps of a millisecond, which includes the whole history.
  vr::RollingHistory history(ball, kLoad, vr::Start::relaxed,
                             {.mesh = vr::Mesh{.nodes_per_revolution = 200},
                              .averaged_meshes = 1,
                              .steps_per_spacing = std::nullopt,
                              .threads = 1});
  const double steps = rate([&](int i) {
    const double time = 1e-3 * (i + 1);
    torque = history.advance(time, kSpeed * time, kLoad + i % 10).resisting_torque;
  });
  std::printf("%8.0f history steps per second at 200 nodes per revolution, last torque %.2f mN m\n", steps,
              torque * 1e3);

  // The torque of steady rolling as a function of load and speed, fitted in Python.
  if (argc > 1) {
    std::ifstream file(argv[1]);
    if (!file) throw std::runtime_error(std::string(argv[1]) + " cannot be read");
    const auto surface = nlohmann::json::parse(file).get<vr::RollingResistance>();
    const double values =
        rate([&](int i) { torque = vr::resisting_torque(surface, kLoad - i % 10, kSpeed, vr::Extrapolation::hold); });
    std::printf("%8.1f million surface values per second, last torque %.2f mN m (fit error %.1f %%)\n", values * 1e-6,
                torque * 1e3, surface.largest_error * 100.0);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
