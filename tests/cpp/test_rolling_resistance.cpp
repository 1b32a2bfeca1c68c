#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <tuple>

#include "viscoroll/rolling_resistance.hpp"

namespace viscoroll {
namespace {

/// Surface ln T = -4 + x + y / 2 + x (2 y^2 - 1) / 4, where x and y are -1 at 10 N and 1 rad/s, 1 at 1000 N and 100
/// rad/s.
constexpr const char* kFile = R"({
 "what": "ln T = sum c_ij T_i(x) T_j(y), \"x\" [and] y",
 "load": [10.0, 1e3], "angular_speed": [1, 100.0], "radius": 2.1e-2,
 "coefficients": [[-4.0, 0.5, 0], [1.0, 0, 0.25]],
 "error": 0.001,
 "largest_error": 3e-3
})";

RollingResistance read(const std::string& text) { return nlohmann::json::parse(text).get<RollingResistance>(); }

std::string message(const std::string& text) {
  try {
    std::ignore = read(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(RollingResistance, IsReadFromItsFile) {
  const RollingResistance surface = read(kFile);
  EXPECT_EQ(surface.radius, 0.021);
  EXPECT_EQ(surface.largest_error, 3e-3);
  EXPECT_NEAR(resisting_torque(surface, 100.0, 10.0), std::exp(-4.0), 1e-15);
  EXPECT_NEAR(resisting_torque(surface, 1000.0, 1.0), std::exp(-4.0 + 1.0 - 0.5 + 0.25), 1e-15);
  EXPECT_NEAR(resisting_torque(surface, 10.0, 10.0 * std::sqrt(10.0)), std::exp(-4.0 - 1.0 + 0.25 + 0.125), 1e-15);
}

TEST(RollingResistance, IsOddAndProportionalToTheSpeedNearRest) {
  const RollingResistance surface = read(kFile);
  const double lowest = resisting_torque(surface, 100.0, 1.0);
  EXPECT_EQ(resisting_torque(surface, 100.0, 0.0), 0.0);
  EXPECT_NEAR(resisting_torque(surface, 100.0, 0.25), 0.25 * lowest, 1e-16);
  EXPECT_EQ(resisting_torque(surface, 100.0, -7.0), -resisting_torque(surface, 100.0, 7.0));
}

TEST(RollingResistance, HoldsTheTorquePerLoadOutsideTheFit) {
  const RollingResistance surface = read(kFile);
  EXPECT_THROW(std::ignore = resisting_torque(surface, 5.0, 10.0), std::invalid_argument);
  EXPECT_THROW(std::ignore = resisting_torque(surface, 100.0, -101.0), std::invalid_argument);
  EXPECT_THROW(std::ignore = resisting_torque(surface, -1.0, 1.0, Extrapolation::hold), std::invalid_argument);
  const double least = resisting_torque(surface, 10.0, 10.0);
  EXPECT_NEAR(resisting_torque(surface, 5.0, 10.0, Extrapolation::hold), 0.5 * least, 1e-16);
  EXPECT_EQ(resisting_torque(surface, 0.0, 10.0, Extrapolation::hold), 0.0);
  EXPECT_EQ(resisting_torque(surface, 100.0, 1e9, Extrapolation::hold), resisting_torque(surface, 100.0, 100.0));
}

TEST(RollingResistance, RejectsOtherFiles) {
  const std::string file = kFile;
  EXPECT_THROW(std::ignore = read("{}"), nlohmann::json::out_of_range);
  EXPECT_THROW(std::ignore = read(R"({"load": null})"), nlohmann::json::type_error);
  const auto changed = [&](const std::string& what, const std::string& to) {
    return std::string(file).replace(file.find(what), what.size(), to);
  };
  EXPECT_EQ(message(changed("[10.0, 1e3]", "[10.0, 1.0]")), "load[1] must be > load[0] = 10 N, got 1");
  EXPECT_EQ(message(changed("[1.0, 0, 0.25]", "[1.0]")),
            "coefficients must be a matrix with rows of equal length (3), got 1");
}

}  // namespace
}  // namespace viscoroll
