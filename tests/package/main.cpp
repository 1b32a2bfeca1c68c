// Rolling resistance in another program: the paper's example, compared with the printed number.
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <viscoroll/viscoroll.hpp>

static_assert(VISCOROLL_VERSION_MAJOR == 0 && VISCOROLL_VERSION_MINOR >= 1);

int main() {
  namespace vr = viscoroll;
  std::printf("viscoroll %s with %s\n", vr::kVersion, vr::kFft);
  const vr::CoatedSphere ball{.core_radius = 20e-3,
                              .layers = {{.thickness = 1e-3,
                                          .shear_modulus = vr::standard_linear_solid(6e6, 3e6, 0.125),
                                          .poisson_ratio = 0.5,
                                          .density = 1000.0}}};
  const vr::Options options{.mesh = vr::Mesh{.nodes_per_revolution = 500, .max_order = 500},
                            .compliance = vr::Compliance::radial,
                            .curvature = vr::Curvature::paper};
  const vr::Result result = vr::solve(ball, {.load = 100.0, .angular_speed = 2.5}, options);
  std::printf("resisting torque %.3f mN m\n", result.resisting_torque * 1e3);

  try {
    static_cast<void>(vr::solve(ball, {.load = -100.0, .angular_speed = 2.5}));
  } catch (const std::invalid_argument& error) {
    std::printf("refused: %s\n", error.what());
    // Table 2 of the paper: 11.38 mN m, with the arc as moment arm.
    return std::abs(result.resisting_torque - 11.38e-3) < 0.005 * 11.38e-3 ? 0 : 1;
  }
  return 1;
}
