// Finite elements of the sections of treads.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include "base/dense_solvers.hpp"
#include "modal/compliance_recursion.hpp"
#include "section/section_compliance.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using Media = std::vector<SectionMedium<double>>;

/// Finer than the default, to separate errors of the elements from others.
constexpr SectionFineness kFine{.finest = 1.0 / 32.0, .growth = 0.5, .largest = 1.0 / 3.0};

/// Largest ratio of Lame's first parameter to the shear modulus that sections accept.
constexpr double kIncompressible = 1e6;

CoatedWheel tread(double core, double width, std::vector<Layer> layers, double crown = INFINITY) {
  return {.core_radius = core, .layers = std::move(layers), .width = width, .crown_radius = crown};
}

CoatedWheel plain_tread(double core, double width) {
  return tread(core, width, {{.thickness = 1.0, .shear_modulus = Elastic{1.0}, .poisson_ratio = 0.5}});
}

/// Order 1 contains a translation across the axis and a rotation about a line across it; order 0, a translation along
/// the axis and a rotation about it.
TEST(SectionElement, RigidMotionsStoreNoEnergy) {
  constexpr std::array<double, 9> kR{2.0, 2.02, 1.97, 2.3, 2.29, 2.31, 2.6, 2.61, 2.58};
  constexpr std::array<double, 9> kZ{0.0, 0.2, 0.4, 0.0, 0.21, 0.4, 0.01, 0.2, 0.41};
  const ElementStiffness stiffness = element_stiffness(kR, kZ);
  const auto largest_force = [&](double m, auto motion) {
    Eigen::Matrix<double, kElementUnknowns, 1> moved;
    for (Index n = 0; n < kElementNodes; ++n) {
      const auto node = static_cast<std::size_t>(n);
      moved.segment<3>(3 * n) = motion(kR[node], kZ[node]);
    }
    return std::max((at_order(stiffness.shear, m) * moved).cwiseAbs().maxCoeff(),
                    (at_order(stiffness.volumetric, m) * moved).cwiseAbs().maxCoeff());
  };
  using Eigen::Vector3d;
  constexpr double kRoundOff = 1e-12;
  EXPECT_LT(largest_force(1.0, [](double, double) { return Vector3d(1.0, 1.0, 0.0); }), kRoundOff);
  EXPECT_LT(largest_force(1.0, [](double r, double z) { return Vector3d(z, z, -r); }), kRoundOff);
  EXPECT_LT(largest_force(0.0, [](double, double) { return Vector3d(0.0, 0.0, 1.0); }), kRoundOff);
  EXPECT_LT(largest_force(0.0, [](double r, double) { return Vector3d(0.0, r, 0.0); }), kRoundOff);
  EXPECT_GT(largest_force(2.0, [](double, double) { return Vector3d(1.0, 1.0, 0.0); }), 0.1);
}

/// Nodal loads of a uniform traction, whose product with the displacement is its mean over a meter.
Eigen::VectorXd uniform_load(const SectionMesh& mesh, double radius) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Index>(mesh.loaded_lines()));
  for (Index i = 0; i + 2 < load.size(); i += 2) {
    load.segment<3>(i) += (mesh.z()[i + 2] - mesh.z()[i]) * radius / 6.0 * Eigen::Vector3d(1.0, 4.0, 1.0);
  }
  return load;
}

/// Under a uniform load over a large width, the middle of a tread acts as a cylinder in plane strain. The compliances
/// of rollers come from the recursion through layers, which is tested against closed forms, for all entries that exist.
TEST(Section, MiddleOfAWideTreadAgreesWithARoller) {
  const CoatedWheel wheel = tread(3.0, 16.0,
                                  {{.thickness = 0.6, .shear_modulus = Elastic{1.0}, .poisson_ratio = 0.45},
                                   {.thickness = 0.4, .shear_modulus = Elastic{1.0}, .poisson_ratio = 0.5}});
  const SectionCompliance section(SectionMesh(wheel, SectionEnd::unbounded, kFine), true);
  const auto lines = static_cast<Index>(section.mesh().loaded_lines());
  const Eigen::VectorXd load = uniform_load(section.mesh(), 4.0);
  const std::array<cplx, 2> moduli{cplx(1.0, 0.3), cplx(0.5, 0.05)};
  const std::vector<SectionMedium<cplx>> media{{.shear = moduli[0], .lame = 9.0 * moduli[0]},
                                               {.shear = moduli[1], .lame = kIncompressible * moduli[1]}};
  const LayerStack<cplx> stack{.metric = {.radius = 4.0, .across = AxisKind::nothing},
                               .media = {{.inner = 3.0, .outer = 3.6, .mu = moduli[0], .b = 1.0 / 11.0, .inertia = 0.0},
                                         {.inner = 3.6, .outer = 4.0, .mu = moduli[1], .b = 0.0, .inertia = 0.0}}};
  for (const double m : {0.0, 1.0, 15.5}) {
    const Matrix3<cplx> y = surface_compliance(stack, m, 0.0);
    const Eigen::MatrixXcd even = section.at(m, media)[kEvenPart];
    const double size = std::abs(y(1, 1));
    // Error of elements with sizes of 1/32 to 1/3 of the thickness.
    constexpr double kElements = 2e-4;
    for (const Index p : {0, 1}) {
      for (const Index q : {0, 1}) {
        const cplx moved = even.row(p * lines).segment(q * lines, lines) * load;
        EXPECT_LT(std::abs(moved - y(p, q)), kElements * size) << "m = " << m << ", entry " << p << q;
      }
    }
  }
}

/// Stiffness p h/(G d) of a bonded strip under a flat punch, uniform along the axis, by
/// tests/reference/bonded_strip.py: with free sides from scikit-fem, extrapolated in the element size, and unbounded
/// from Fourier integrals.
struct Strip {
  double width;  ///< width / thickness
  double free, unbounded;
};

class StripUnderPunch : public testing::TestWithParam<Strip> {};

TEST_P(StripUnderPunch, StiffnessAgreesWithAnotherProgram) {
  // radius / thickness; the effect of curvature is of the order of its inverse
  constexpr double kStraight = 1e4;
  const auto [width, free, unbounded] = GetParam();
  const auto stiffness = [&](SectionEnd end, const SectionFineness& fineness) {
    const SectionCompliance section(SectionMesh(plain_tread(kStraight, width), end, fineness), false);
    const Eigen::MatrixXd moved = section.at(0.0, Media{{.shear = 1.0, .lame = kIncompressible}})[kEvenPart];
    const Eigen::VectorXd force = dense_inverse(moved) * Eigen::VectorXd::Ones(moved.rows());
    return 2.0 * force.sum() / (kStraight + 1.0) / width;
  };
  EXPECT_NEAR(stiffness(SectionEnd::face, kFine), free, 1e-3 * free);
  EXPECT_NEAR(stiffness(SectionEnd::face, {}), free, 2e-3 * free);
  // In an unbounded strip, the pressure is singular at the edge of the punch.
  EXPECT_NEAR(stiffness(SectionEnd::unbounded, kFine), unbounded, 4e-3 * unbounded);
}

INSTANTIATE_TEST_SUITE_P(Widths, StripUnderPunch,
                         testing::Values(Strip{1.0, 4.52167, 10.25165}, Strip{2.0, 5.24932, 12.43271},
                                         Strip{3.0, 6.38966, 15.64781}, Strip{4.0, 8.00852, 19.47515},
                                         Strip{6.0, 12.72475, 28.74107}));

/// Elements of half the size have less than half of the error, although the corners at the hub are singular.
TEST(Section, ConvergesWithSmallerElements) {
  const auto middle = [](double share) {
    const SectionFineness fineness{.finest = share / 16.0, .growth = 0.5 * share, .largest = share / 2.0};
    const SectionCompliance section(SectionMesh(plain_tread(4.0, 3.0), SectionEnd::face, fineness), false);
    const Eigen::VectorXd load = uniform_load(section.mesh(), 5.0);
    const Eigen::MatrixXd even = section.at(7.0, Media{{.shear = 1.0, .lame = kIncompressible}})[kEvenPart];
    return even.row(0).dot(load);
  };
  const double coarse = std::abs(middle(1.0) - middle(0.25));
  const double fine = std::abs(middle(0.5) - middle(0.25));
  EXPECT_LT(fine, 0.5 * coarse);
  EXPECT_LT(fine, 3e-4 * middle(0.25));
}

/// A crowned tread is meshed over its full width, because its thickness varies everywhere; but it varies only on the
/// length scale of the width.
TEST(Section, WideTreadsNeedNoMoreElements) {
  const SectionFineness everywhere{.widest = 0.0};
  const auto wheel = [](double width) {
    return tread(500.0, width, plain_tread(1.0, 1.0).layers, width * width / 6.0);
  };
  const auto compliance = [](const CoatedWheel& cut, SectionEnd end, const SectionFineness& fineness) {
    const SectionCompliance section(SectionMesh(cut, end, fineness), false);
    const Eigen::VectorXd load = uniform_load(section.mesh(), 501.0);
    const Eigen::MatrixXd even = section.at(100.0, Media{{.shear = 1.0, .lame = kIncompressible}})[kEvenPart];
    return load.dot(even * load);
  };
  const auto difference = [&](const SectionFineness& fineness) {
    CoatedWheel flat = wheel(36.0);
    flat.crown_radius = INFINITY;
    return compliance(wheel(36.0), SectionEnd::face, fineness) - compliance(flat, SectionEnd::unbounded, fineness);
  };
  const double fine = difference(everywhere);
  EXPECT_NEAR(difference({}), fine, 1e-3 * std::abs(fine));
  const auto lines = [&](double width, const SectionFineness& fineness) {
    return SectionMesh(wheel(width), SectionEnd::face, fineness).lines();
  };
  EXPECT_LT(lines(36.0, {}), 0.6 * static_cast<double>(lines(36.0, everywhere)));
  EXPECT_LT(lines(1000.0, {}), 1.3 * static_cast<double>(lines(36.0, {})));
}

TEST(Section, RadiiAtTheFaceFollowCrownAndHub) {
  CoatedWheel wheel = plain_tread(4.0, 3.0);
  wheel.crown_radius = 6.0;
  const double drop = crown_drop(wheel, 1.5);
  const auto at_face = [&](Hub hub) {
    wheel.hub = hub;
    const SectionMesh mesh(wheel, SectionEnd::face);
    return std::array{mesh.radius(mesh.lines() - 1, 0), mesh.radius(mesh.lines() - 1, mesh.rows() - 1)};
  };
  EXPECT_DOUBLE_EQ(at_face(Hub::straight)[0], 4.0);
  EXPECT_DOUBLE_EQ(at_face(Hub::straight)[1], 5.0 - drop);
  EXPECT_DOUBLE_EQ(at_face(Hub::crowned)[0], 4.0 - drop);
  EXPECT_DOUBLE_EQ(at_face(Hub::crowned)[1], 5.0 - drop);
}

}  // namespace
}  // namespace viscoroll::detail
