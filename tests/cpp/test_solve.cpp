#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "cases.hpp"
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

TEST(Solve, ManyThreadsSolveAtOnce) {
  const auto torque = [] {
    return solve(cases::unlike_layers(), {.load = 50.0, .angular_speed = 2.5}, kCoarse).resisting_torque;
  };
  const double expected = torque();
  std::vector<std::jthread> threads;
  for (int t = 0; t < 8; ++t) threads.emplace_back([&] { EXPECT_EQ(torque(), expected); });
}

TEST(Solve, StopsOnRequest) {
  Options options;
  options.mesh = Mesh{.nodes_per_revolution = 2000, .max_order = 3000};
  options.observer.cancelled = [] { return true; };
  EXPECT_THROW(std::ignore = solve(cases::paper_sphere(), {.load = 100.0, .angular_speed = 2.5}, options), Cancelled);
}

TEST(Solve, NamesWhatIsWrong) {
  const auto message = [](const CoatedSphere& sphere, const LoadCase& load_case) -> std::string {
    try {
      std::ignore = solve(sphere, load_case, kCoarse);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(message(cases::paper_sphere(), {.load = -1.0, .angular_speed = 2.5}), "load must be > 0 N, got -1");
  CoatedSphere sphere = cases::paper_sphere();
  sphere.layers[0].thickness = -1e-3;
  EXPECT_EQ(message(sphere, {.load = 1.0, .angular_speed = 2.5}), "layers[0].thickness must be > 0 m, got -0.001");
  sphere.layers.clear();
  EXPECT_EQ(message(sphere, {.load = 1.0, .angular_speed = 2.5}),
            "layers must be a list of at least one layer, got none");
}

}  // namespace
}  // namespace viscoroll
