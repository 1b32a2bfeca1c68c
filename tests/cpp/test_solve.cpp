#include <gtest/gtest.h>

#include <stdexcept>
#include <tuple>
#include <vector>

#include "cases.hpp"
#include "joined_thread.hpp"
#include "viscoroll/viscoroll.hpp"

namespace viscoroll {
namespace {

const Options kCoarse{.mesh = Mesh{.nodes_per_revolution = 200, .max_order = 300}};

TEST(Solve, DoesNotDependOnTheNumberOfThreads) {
  Options options = kCoarse;
  options.threads = 1;
  const Result one = solve(cases::paper_sphere(), {.load = 100.0, .angular_speed = 2.5}, options);
  options.threads = 3;
  const Result three = solve(cases::paper_sphere(), {.load = 100.0, .angular_speed = 2.5}, options);
  EXPECT_EQ(one.pressure, three.pressure);
  EXPECT_EQ(one.resisting_torque, three.resisting_torque);
}

TEST(SolveKept, ReproducesTheState) {
  for (const double friction : {0.0, 0.3}) {
    const LoadCase load_case{.load = 100.0, .angular_speed = 2.5, .friction = friction};
    const Result result = solve(cases::paper_sphere(), load_case, kCoarse);
    const Result again = solve_frozen(cases::paper_sphere(), CoatedPlane{}, load_case, frozen_contact(result), kCoarse);
    EXPECT_NEAR(again.resisting_torque / result.resisting_torque, 1.0, 1e-9) << friction;
    EXPECT_EQ(again.contact, result.contact);
    EXPECT_EQ(again.stick, result.stick);
  }
}

TEST(Solve, FindsTheLoadOfAPenetration) {
  for (const double friction : {0.0, 0.3}) {
    const LoadCase loaded{.load = 100.0, .angular_speed = 2.5, .friction = friction};
    const Result result = solve(cases::paper_sphere(), loaded, kCoarse);
    EXPECT_EQ(result.load, 100.0);
    LoadCase lowered = loaded;
    lowered.load.reset();
    lowered.penetration = result.penetration;
    const Result again = solve(cases::paper_sphere(), lowered, kCoarse);
    EXPECT_EQ(again.penetration, result.penetration);
    EXPECT_NEAR(again.load, 100.0, 1e-7) << friction;
    EXPECT_NEAR(again.resisting_torque / result.resisting_torque, 1.0, 1e-9) << friction;
    const Result kept = solve_frozen(cases::paper_sphere(), CoatedPlane{}, lowered, frozen_contact(again), kCoarse);
    EXPECT_NEAR(kept.load, 100.0, 1e-7) << friction;
  }
}

TEST(SolveKept, RejectsAStateOfAnotherMesh) {
  const LoadCase load_case{.load = 100.0, .angular_speed = 2.5};
  const FrozenContact kept = frozen_contact(solve(cases::paper_sphere(), load_case, kCoarse));
  const auto refused = [&](auto change, const Options& options = kCoarse) {
    FrozenContact other = kept;
    change(other);
    EXPECT_THROW(std::ignore = solve_frozen(cases::paper_sphere(), CoatedPlane{}, load_case, other, options),
                 std::invalid_argument);
  };
  refused([](FrozenContact& other) { other.phi_nodes = 4; });
  refused([](FrozenContact& other) { other.theta_nodes = 1001; });
  refused([](FrozenContact& other) { other.pressure.pop_back(); });
  refused([](FrozenContact& other) { other.contact.assign(other.contact.size(), 0); });
  refused([](FrozenContact&) {}, Options{});
}

TEST(Solve, ManyThreadsSolveConcurrently) {
  const auto torque = [] {
    return solve(cases::dissimilar_layers(), {.load = 50.0, .angular_speed = 2.5}, kCoarse).resisting_torque;
  };
  const double expected = torque();
  constexpr int kThreads = 8;
  std::vector<detail::JoinedThread> threads;
  threads.reserve(kThreads);
  for (int t = 0; t < kThreads; ++t) threads.emplace_back([&] { EXPECT_EQ(torque(), expected); });
}

TEST(Solve, FrictionDoesNotDependOnTheNumberOfThreads) {
  const LoadCase sideways{.load = 100.0,
                          .angular_speed = 0.2,
                          .friction = 0.2,
                          .drive = DriveCreepage{.creepage = 0.02, .lateral_creepage = 0.01}};
  const LoadCase towed{.load = 100.0, .angular_speed = 0.2, .friction = 0.2, .drive = DriveTorque{0.0}};
  for (const LoadCase& load_case : {sideways, towed}) {
    Options options = kCoarse;
    options.threads = 1;
    const Result one = solve(cases::paper_sphere(), load_case, options);
    options.threads = 3;
    const Result three = solve(cases::paper_sphere(), load_case, options);
    EXPECT_EQ(one.pressure, three.pressure);
    EXPECT_EQ(one.shear_traction, three.shear_traction);
    EXPECT_LT(one.residual, 1e-8);
  }
}

TEST(RollingModel, CanBeSharedByThreads) {
  const RollingModel model(cases::dissimilar_layers(), 2.5, *kCoarse.mesh);
  // Each load needs wider tables than the previous one.
  const std::vector<double> loads{1.0, 10.0, 50.0, 100.0};
  std::vector<detail::JoinedThread> threads;
  threads.reserve(loads.size());
  for (const double load : loads) {
    threads.emplace_back([&model, load] {
      const LoadCase load_case{.load = load, .angular_speed = 2.5, .friction = 0.1};
      const Result alone = solve(cases::dissimilar_layers(), load_case, kCoarse);
      const Result shared = model.solve(load_case);
      EXPECT_NEAR(shared.resisting_torque, alone.resisting_torque, 1e-10 * alone.resisting_torque);
    });
  }
}

TEST(RollingModel, RejectsAnotherSpeed) {
  const CoatedSphere sphere = cases::paper_sphere();
  const RollingModel model(sphere, CoatedPlane{}, GroundSpeed{0.1}, *kCoarse.mesh);
  EXPECT_GT(model.solve({.load = 1.0, .speed = 0.1}).resisting_torque, 0.0);
  const auto message = [&](const LoadCase& load_case) -> std::string {
    try {
      std::ignore = model.solve(load_case);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_TRUE(message({.load = 1.0, .speed = 0.2}).starts_with("speed must be the speed of the model, 0.1"));
  EXPECT_TRUE(message({.load = 1.0, .speed = 0.2}).ends_with(" m/s, got 0.2 m/s"));
  EXPECT_TRUE(message({.load = 1.0, .angular_speed = 2.0}).starts_with("angular_speed must be the speed of the model"));
  EXPECT_TRUE(message({.load = 1.0, .angular_speed = 2.0}).ends_with(" rad/s, got 2 rad/s"));
}

TEST(Solve, NamesTheGivenSpeed) {
  CoatedSphere melt = cases::paper_sphere();
  melt.layers[0].shear_modulus = Prony{6e6, {0.5, 0.5}, {0.1, 1e5}};
  const double slowest = kSlowTerm / 1e5 * outer_radius(melt);  // [m/s]
  try {
    std::ignore = solve(melt, {.load = 1.0, .speed = 0.5 * slowest}, kCoarse);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.parameter(), "speed");
    EXPECT_NEAR(std::stod(error.value()), 0.5 * slowest, 1e-15);
    EXPECT_NEAR(std::stod(error.rule().substr(std::string("must be >= ").size())), slowest, 1e-15);
  }
}

TEST(Solve, StopsOnRequest) {
  Options options;
  options.mesh = Mesh{.nodes_per_revolution = 2000, .max_order = 3000};
  options.observer.cancelled = [] { return true; };
  EXPECT_THROW(std::ignore = solve(cases::paper_sphere(), {.load = 100.0, .angular_speed = 2.5}, options), Canceled);
}

TEST(Solve, NamesTheWrongParameter) {
  const auto message = [](const CoatedSphere& sphere, const LoadCase& load_case) -> std::string {
    try {
      std::ignore = solve(sphere, load_case, kCoarse);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(message(cases::paper_sphere(), {.load = -1.0, .angular_speed = 2.5}), "load must be > 0 N, got -1");
  EXPECT_EQ(message(cases::paper_sphere(), {.angular_speed = 2.5}),
            "load must be given, or penetration instead of it, got neither");
  CoatedSphere sphere = cases::paper_sphere();
  sphere.layers[0].thickness = -1e-3;
  EXPECT_EQ(message(sphere, {.load = 1.0, .angular_speed = 2.5}), "layers[0].thickness must be > 0 m, got -0.001");
  sphere.layers.clear();
  EXPECT_EQ(
      message(sphere, {.load = 1.0, .angular_speed = 2.5}),
      "layers must be a list of at least one layer unless on.layers or on.base of the counterbody is given, got two "
      "rigid bodies");
}

}  // namespace
}  // namespace viscoroll
