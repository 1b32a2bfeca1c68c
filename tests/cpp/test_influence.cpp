#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <ostream>
#include <utility>
#include <vector>

#include "cases.hpp"
#include "influence/interpolated_orders.hpp"
#include "influence/table_sums.hpp"
#include "influence/waves.hpp"
#include "surface/table_operator.hpp"
#include "viscoroll/influence.hpp"

namespace viscoroll::detail {
namespace {

/// Integral of f over [-1, 1] by 64 midpoint panels with Richardson extrapolation.
template <class Function>
double integral(const Function& f) {
  const auto midpoints = [&](int panels) {
    double sum = 0.0;
    for (int i = 0; i < panels; ++i) sum += f(-1.0 + (2.0 * i + 1.0) / panels) * 2.0 / panels;
    return sum;
  };
  const double coarse = (4.0 * midpoints(128) - midpoints(64)) / 3.0;
  const double fine = (4.0 * midpoints(256) - midpoints(128)) / 3.0;
  return (16.0 * fine - coarse) / 15.0;
}

TEST(Patch, SphericalBesselIsTheTransformOfLegendre) {
  for (const double x : {1e-5, 0.05, 0.099, 0.101, 0.199, 0.201, 1.0, 3.0}) {
    EXPECT_NEAR(spherical_bessel(0, x), 0.5 * integral([x](double t) { return std::cos(x * t); }), 1e-12);
    EXPECT_NEAR(spherical_bessel(1, x), 0.5 * integral([x](double t) { return t * std::sin(x * t); }), 1e-12);
    const auto second = [x](double t) { return (0.5 - 1.5 * t * t) * std::cos(x * t); };
    EXPECT_NEAR(spherical_bessel(2, x), 0.5 * integral(second), 1e-12);
  }
}

TEST(Patch, SphericalWeightsGiveTheInverseSine) {
  const double spacing = 0.02;
  const double theta = 1.3;
  const auto w = spherical_patch_weights(theta, spacing);
  for (const double x : {-1.0, -0.3, 0.0, 0.8}) {
    const double series = w[0] + w[1] * x + w[2] * (1.5 * x * x - 0.5);
    // The neglected third Legendre coefficient is about (spacing / 2)^3.
    EXPECT_NEAR(series, 1.0 / std::sin(theta + 0.5 * spacing * x), 1e-6);
  }
}

class CoatingTest : public testing::TestWithParam<std::tuple<Compliance, PatchLoad, bool>> {
 protected:
  CoatingTest() {
    const CoatingSum orders(layered_body(cases::dissimilar_layers()), 2.5, mesh_, 2, watch_);
    const auto tables = [&](const std::vector<TableRequest>& requests) {
      return std::make_shared<const std::vector<Table>>(orders.tables(requests, 8, 10, 2, watch_));
    };
    tables_ = tables(displacement_tables(formulation_));
    surface_ = std::make_unique<TableOperator>(
        formulation_, nodes_.grid(), nodes_.window(), tables_,
        [dissipation = tables(dissipation_tables(formulation_))](int, int) { return dissipation; }, execution_);
  }

  /// Directions r, phi and theta in x, y and z, if they are components of loads.
  [[nodiscard]] Eigen::Matrix3d directions(Eigen::Index node) const {
    Eigen::Matrix3d directions;
    const auto axes = nodes_.points().axes();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (Eigen::Index p = 0; p < 3; ++p) {
        directions(p, axis) = axes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(p)].values()[node];
      }
    }
    if (formulation_.compliance == Compliance::radial) {
      const double share = formulation_.tangential ? 1.0 : 0.0;
      const double angle_ahead = 0.5 * std::numbers::pi - nodes_.phi()[node];
      directions << share * angle_ahead, 1, share * nodes_.z()[node] / grid_.radius, -1, 0, 0, 0, 0, -1;
    }
    return directions;
  }

  /// Displacements summed node by node from the tables.
  [[nodiscard]] VectorField direct_sum(const VectorField& force) const {
    const auto requests = displacement_tables(formulation_);
    const std::size_t components = formulation_.tangential || formulation_.compliance == Compliance::vertical ? 3 : 1;
    const Window& window = nodes_.window();
    const int columns = window.theta.count();
    const Eigen::ArrayXd theta = nodes_.theta();
    VectorField result = VectorField::Zero(force.rows(), 3);
    for (Eigen::Index source = 0; source < force.rows(); ++source) {
      const Eigen::Vector3d load = directions(source) * force.row(source).matrix().transpose();
      const auto weights = spherical_patch_weights(theta[source], theta_spacing(mesh_));
      for (Eigen::Index target = 0; target < force.rows(); ++target) {
        const int j = static_cast<int>(target) / columns - static_cast<int>(source) / columns;
        const int l = static_cast<int>(target) % columns - static_cast<int>(source) % columns;
        Eigen::Vector3d moved = Eigen::Vector3d::Zero();
        for (std::size_t t = 0; t < requests.size(); ++t) {
          const auto shape = static_cast<std::size_t>(requests[t].source_shape);
          const double weight = formulation_.patch_load == PatchLoad::flat ? 1.0 : weights[shape];
          for (std::size_t p = 0; p < components; ++p) {
            for (std::size_t q = 0; q < components; ++q) {
              const SignedEntry entry = entry_of(p, q);
              if (entry.entry != requests[t].entry) continue;
              moved[static_cast<Eigen::Index>(p)] +=
                  entry.sign * weight * (*tables_)[t](j, l) * load[static_cast<Eigen::Index>(q)];
            }
          }
        }
        result.row(target) += (directions(target).transpose() * moved).transpose().array();
      }
    }
    return result;
  }

  /// Forces that vary from node to node; only normal ones for a formulation without tangential forces.
  [[nodiscard]] VectorField forces(double frequency) const {
    VectorField force = VectorField::Zero(nodes_.shape().size(), 3);
    force.col(kDown) = Eigen::ArrayXd::LinSpaced(force.rows(), 0.0, frequency).sin();
    if (formulation_.tangential) {
      force.col(kForward) = Eigen::ArrayXd::LinSpaced(force.rows(), 1.0, 2.0 * frequency).sin();
      force.col(kSideways) = Eigen::ArrayXd::LinSpaced(force.rows(), 2.0, 0.7 * frequency).cos();
    }
    return force;
  }

  Formulation formulation_{std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
  Mesh mesh_{.nodes_per_revolution = 101, .max_order = 130};
  SurfaceGrid grid_{23e-3, phi_spacing(mesh_), theta_spacing(mesh_)};
  SurfaceWindow nodes_{grid_, {{-4, 4}, {-5, 5}}};
  std::shared_ptr<const std::vector<Table>> tables_;
  std::unique_ptr<TableOperator> surface_;
  Observer observer_;
  Watch watch_{observer_};
  Execution execution_{2, watch_};
};

TEST_P(CoatingTest, FftProductEqualsTheDirectSum) {
  const VectorField force = forces(1.0);
  const VectorField fast = surface_->displacement(force);
  const VectorField expected = direct_sum(force);
  EXPECT_LT((fast - expected).abs().maxCoeff(), 1e-13 * expected.abs().maxCoeff());

  VectorField pressing = VectorField::Zero(force.rows(), 3);
  pressing.col(kDown) = force.col(kDown);
  const Eigen::ArrayXd rise = surface_->normal_displacement(Eigen::ArrayXd(-pressing.col(kDown)));
  EXPECT_LT((rise + direct_sum(pressing).col(kDown)).abs().maxCoeff(), 1e-13 * rise.abs().maxCoeff());
}

TEST_P(CoatingTest, ProductOfMirrorImagesEqualsTheDirectSum) {
  // Forces that are mirror images are determined by half of the nodes; lateral forces change their sign.
  VectorField force = forces(1.0);
  const Eigen::Index columns = nodes_.shape().theta_nodes;
  for (Eigen::Index node = 0; node < force.rows(); ++node) {
    const Eigen::Index image = node + columns - 1 - 2 * (node % columns);
    if (image > node) force.row(node) = force.row(image) * Eigen::Array3d(1.0, 1.0, -1.0).transpose();
    if (image == node) force(node, kSideways) = 0.0;
  }
  const VectorField expected = direct_sum(force);
  EXPECT_LT((surface_->displacement(force) - expected).abs().maxCoeff(), 1e-13 * expected.abs().maxCoeff());
  const double lost = surface_->dissipation(force).rolling;
  force(0, kDown) = std::nextafter(force(0, kDown), 2.0);  // no longer symmetric
  EXPECT_NEAR(surface_->dissipation(force).rolling, lost, 1e-12 * lost);

  if (!surface_->takes_mirrored()) return;
  VectorField pressing = VectorField::Zero(force.rows(), 3);
  pressing.col(kDown) = force.col(kDown);
  const Eigen::ArrayXd rise = surface_->normal_displacement(Eigen::ArrayXd(-pressing.col(kDown)), true);
  EXPECT_LT((rise + direct_sum(pressing).col(kDown)).abs().maxCoeff(), 1e-13 * rise.abs().maxCoeff());
}

TEST_P(CoatingTest, ProductOfForcesOnAPartEqualsTheDirectSum) {
  // If only a part of the window is loaded, also away from its middle, the period of the transforms is shorter.
  VectorField force = forces(1.0);
  const Eigen::Index columns = nodes_.shape().theta_nodes;
  for (Eigen::Index node = 0; node < force.rows(); ++node) {
    const Eigen::Index row = node / columns;
    const Eigen::Index column = node % columns;
    if (row < 5 || row > 7 || column < 4 || column > 5) force.row(node) = 0.0;
  }
  const VectorField expected = direct_sum(force);
  EXPECT_LT((surface_->displacement(force) - expected).abs().maxCoeff(), 1e-13 * expected.abs().maxCoeff());
}

TEST_P(CoatingTest, IsPassive) {
  // Passivity: the compliance has a positive symmetric part, and the dissipated work is never negative.
  for (int k = 1; k < 40; ++k) {
    const VectorField force = forces(3.7 * k);
    EXPECT_GT((force * surface_->displacement(force)).sum(), 0.0);
    EXPECT_GT(surface_->dissipation(force).rolling, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Formulations, CoatingTest,
                         testing::Combine(testing::Values(Compliance::vertical, Compliance::radial),
                                          testing::Values(PatchLoad::flat, PatchLoad::spherical), testing::Bool()));

TEST(Synthesis, DoesNotDependOnTheNumberOfThreads) {
  // The sums of these tables are not kept: the first body has dissimilar layers, and the other tables are too large.
  const auto expect_equal = [](const CoatedSphere& sphere, const Mesh& mesh, int phi_reach, int theta_reach) {
    const auto sum = [&](int threads) {
      return influence_tables(sphere, 2.5, mesh, phi_reach, theta_reach, threads).values;
    };
    EXPECT_EQ(sum(1), sum(2));
    EXPECT_EQ(sum(1), sum(5));
  };
  expect_equal(cases::dissimilar_layers(), {.nodes_per_revolution = 64, .max_order = 100}, 10, 12);
  expect_equal(cases::paper_sphere(), {.nodes_per_revolution = 640, .max_order = 400}, 4, 60);
}

/// Spectrum without shared terms, so that every speed computes its own sums.
class WithoutTerms final : public Spectrum {
 public:
  explicit WithoutTerms(std::unique_ptr<Spectrum> spectrum) : spectrum_(std::move(spectrum)) {}
  void series(std::size_t i, OrderSeries& series) const override { spectrum_->series(i, series); }

 private:
  std::unique_ptr<Spectrum> spectrum_;
};

TEST(Synthesis, SumsOfTermsThatSpeedsShareGiveTheSameTables) {
  const Observer observer;
  Watch watch(observer);
  const LayeredBody body = layered_body(cases::paper_sphere());
  const Mesh mesh{.nodes_per_revolution = 64, .max_order = 100};
  const std::vector<TableRequest> requests{{.entry = Entry::rr},
                                           {.entry = Entry::rphi, .phi_shift = 0.5},
                                           {.entry = Entry::phitheta, .source_shape = 1},
                                           {.entry = Entry::thetatheta, .power = true}};
  constexpr int kReach = 12;
  // The sums of the first speed serve the second one; the third has more inertia.
  for (const double speed : {2.5, 2.7, 25.0}) {
    const auto bands = phi_bands(body, speed, mesh);
    const HarmonicBody harmonics(body, speed, all_orders(bands), measured_order(mesh));
    const auto tables = [&](auto wrap) {
      return OrderSum(mesh, harmonics.radius(), bands, bands, wrap(make_spectrum(harmonics, 100.0, 3, watch)))
          .tables(requests, kReach, kReach, 3, watch);
    };
    const auto shared = tables([](std::unique_ptr<Spectrum> spectrum) {
      EXPECT_FALSE(spectrum->terms_key().empty());
      return spectrum;
    });
    const auto alone =
        tables([](std::unique_ptr<Spectrum> spectrum) { return std::make_unique<WithoutTerms>(std::move(spectrum)); });
    for (std::size_t k = 0; k < requests.size(); ++k) {
      double largest = 0.0;
      double difference = 0.0;
      for (int j = -kReach; j <= kReach; ++j) {
        for (int l = 0; l <= kReach; ++l) {
          largest = std::max(largest, std::abs(alone[k](j, l)));
          difference = std::max(difference, std::abs(shared[k](j, l) - alone[k](j, l)));
        }
      }
      EXPECT_GT(largest, 0.0);
      EXPECT_LT(difference, 1e-12 * largest) << "table " << k << " at " << speed << " rad/s";
    }
  }
}

/// All single orders in the range that `octaves` samples.
std::vector<OrderBand> one_by_one(const std::vector<OrderBand>& octaves, int nodes_per_revolution) {
  const auto& last = octaves.back().orders;
  const auto count = static_cast<Eigen::Index>(last[last.size() - 1]);
  // The weights of all octaves sum to one smooth cutoff, around this order.
  const double middle = 16.0 * nodes_per_revolution;
  const Eigen::ArrayXd orders = Eigen::ArrayXd::LinSpaced(count + 1, 0.0, static_cast<double>(count));
  Eigen::ArrayXd weights =
      2.0 * orders.unaryExpr([&](double order) { return 0.5 * std::erfc((order - middle) * 4.8 / middle); });
  weights[0] *= 0.5;
  return {{.orders = orders, .weights = weights, .reach = nodes_per_revolution / 2}};
}

struct OctaveCase {
  const char* name;
  CoatedSphere sphere;
  double angular_speed;
  int phi_nodes;
  int theta_nodes;
};

void PrintTo(const OctaveCase& c, std::ostream* out) { *out << c.name; }

/// A measured modulus with two frequencies per decade and a steep rise; linear interpolation gives it kinks.
CoatedSphere measured_sphere() {
  MasterCurve curve{.frequency = {0.0, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 150.0, 300.0, 1000.0},
                    .storage = {1e6, 1e6, 1.1e6, 1.2e6, 1.4e6, 1.7e6, 2e6, 2.2e6, 7e6, 8e6, 8e6},
                    .loss = {0.0, 1e4, 5e4, 2e5, 3e5, 4e5, 5e5, 6e5, 3e6, 4e5, 1e5},
                    .extrapolation = Extrapolation::hold};
  return {.core_radius = 20e-3,
          .layers = {{.thickness = 1e-3, .shear_modulus = std::move(curve), .poisson_ratio = 0.5}}};
}

/// A smooth function that is not declared as smooth: a spring parallel to a springpot.
CoatedSphere springpot_sphere() {
  const CustomModulus modulus{[](std::span<const double> omega, std::span<std::complex<double>> values) {
    std::ranges::transform(omega, values.begin(),
                           [](double w) { return 1e6 + 3e6 * std::pow(std::complex<double>(0.0, w), 0.3); });
  }};
  return {.core_radius = 20e-3, .layers = {{.thickness = 1e-3, .shear_modulus = modulus, .poisson_ratio = 0.5}}};
}

class OctavesTest : public testing::TestWithParam<OctaveCase> {};

TEST_P(OctavesTest, AgreeWithTheSumOfAllOrders) {
  const OctaveCase& c = GetParam();
  const Mesh mesh{.nodes_per_revolution = c.phi_nodes, .theta_nodes_per_revolution = c.theta_nodes};
  const Observer observer;
  Watch watch(observer);
  std::vector<TableRequest> requests;
  for (const Entry entry : {Entry::rr, Entry::rphi, Entry::rtheta, Entry::phiphi, Entry::phitheta, Entry::thetatheta}) {
    requests.push_back({.entry = entry});
    requests.push_back({.entry = entry, .power = true});
  }
  requests.push_back({.entry = Entry::rr, .source_shape = 2});
  const int reach = c.phi_nodes / 3;
  const auto tables =
      CoatingSum(layered_body(c.sphere), c.angular_speed, mesh, 2, watch).tables(requests, reach, reach, 2, watch);
  const CoatingSum full(layered_body(c.sphere), c.angular_speed, mesh, one_by_one(octaves(c.phi_nodes), c.phi_nodes),
                        one_by_one(octaves(c.theta_nodes), c.theta_nodes), 2, watch);
  const auto expected = full.tables(requests, reach, reach, 2, watch);
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const bool power = requests[k].power;
    double center = 0.0;
    double error = 0.0;
    for (int j = -reach; j <= reach; ++j) {
      for (int l = 0; l <= reach; ++l) {
        center = std::max(center, std::abs(expected[power ? 1 : 0](j, l)));  // the r-r entry
        error = std::max(error, std::abs(tables[k](j, l) - expected[k](j, l)));
      }
    }
    EXPECT_LT(error, 1e-9 * center) << "table " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Coatings, OctavesTest,
                         testing::Values(OctaveCase{"Measured", measured_sphere(), 2.5, 32, 32},
                                         OctaveCase{"SmoothFunction", springpot_sphere(), 2.5, 32, 32},
                                         OctaveCase{"Paper", cases::paper_sphere(), 2.5, 32, 32},
                                         OctaveCase{"DifferentSpacings", cases::paper_sphere(), 2.5, 40, 24},
                                         OctaveCase{"LongMemory", cases::paper_sphere(), 200.0, 32, 32},
                                         OctaveCase{"ShortMemory", cases::paper_sphere(), 0.01, 32, 32},
                                         OctaveCase{"DissimilarLayers", cases::dissimilar_layers(), 2.5, 24, 24}),
                         [](const auto& info) { return info.param.name; });

TEST(MeshOnBody, AgreesWithAMeshOfItsOwn) {
  const Mesh own{.nodes_per_revolution = 32, .theta_nodes_per_revolution = 24};
  // The mesh has 40 by 30 nodes around the rolling body.
  const double turns = 1.25;
  const MeshOnBody of_other({.nodes_per_revolution = 40, .theta_nodes_per_revolution = 30}, turns);
  const Observer observer;
  Watch watch(observer);
  const std::vector<TableRequest> requests{
      {.entry = Entry::rr}, {.entry = Entry::rphi}, {.entry = Entry::rr, .power = true}};
  const LayeredBody body = layered_body(cases::dissimilar_layers());
  const auto expected = CoatingSum(body, 2.5, own, 1, watch).tables(requests, 8, 8, 1, watch);
  const auto tables = CoatingSum(body, 2.5, of_other, 1, watch).tables(requests, 8, 8, 1, watch);
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const double per_radian = requests[k].power ? turns : 1.0;
    for (int j = -8; j <= 8; ++j) {
      for (int l = 0; l <= 8; ++l) {
        EXPECT_NEAR(tables[k](j, l), per_radian * expected[k](j, l), 1e-12 * std::abs(expected[k](0, 1)));
      }
    }
  }
}

/// A function that decays like the compliance of a half-space, with branch cuts from n = +-im: the sampled orders give
/// the same sum as all orders.
TEST(InterpolatedOrders, SumSmoothFunctionsAsAllOrdersDo) {
  for (const auto& bands : {whole_orders(500, 500), whole_orders(1500, 800), octaves(500), octaves(20000)}) {
    const InterpolatedOrders interpolated(bands);
    const Eigen::ArrayXd& sampled = interpolated.sampled();
    EXPECT_LT(static_cast<double>(sampled.size()), 0.4 * static_cast<double>(all_orders(bands).size()));
    for (const double m : {0.5, 30.0, 400.0}) {
      const auto compliance = [m](const Eigen::ArrayXd& n) -> Eigen::RowVectorXd {
        return (m * m + n.square()).sqrt().inverse().matrix().transpose();
      };
      Eigen::RowVectorXd direct = Eigen::RowVectorXd::Zero(3);
      RowMajorMatrix sums = RowMajorMatrix::Zero(sampled.size(), 3);
      double size = 0.0;
      for (std::size_t b = 0; b < bands.size(); ++b) {
        RowMajorMatrix terms(bands[b].orders.size(), 3);
        for (int offset = 0; offset < 3; ++offset) {
          terms.col(offset) = (bands[b].weights * (0.4 * offset * bands[b].orders).cos()).matrix();
        }
        direct += compliance(bands[b].orders) * terms;
        size += (compliance(bands[b].orders) * bands[b].weights.abs().matrix()).value();
        interpolated.add_sums(b, terms, sums);
      }
      const Eigen::RowVectorXd by_few = compliance(sampled) * sums;
      // The tolerance is the round-off of some thousand terms.
      EXPECT_LT((by_few - direct).cwiseAbs().maxCoeff(), 1e-14 * size) << m;
    }
  }
}

}  // namespace
}  // namespace viscoroll::detail
