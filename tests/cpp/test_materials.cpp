#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/materials.hpp"

namespace viscoroll {
namespace {

using cplx = std::complex<double>;

TEST(ComplexModulus, RejectsMissingValuesOfACustomFunction) {
  const CustomModulus lazy{[](std::span<const double>, std::span<cplx> mu) { mu[0] = 1e6; }};
  const std::array omega{0.0, 1.0};
  EXPECT_THROW(std::ignore = complex_modulus(lazy, omega), std::invalid_argument);
}

TEST(ComplexModulus, IgnoresALossAtRest) {
  const CustomModulus hysteretic{[](std::span<const double>, std::span<cplx> mu) {
    for (cplx& value : mu) value = cplx(1e6, 1e5);
  }};
  const std::array omega{0.0, 1.0};
  const auto mu = complex_modulus(hysteretic, omega);
  EXPECT_EQ(mu[0], cplx(1e6));
  EXPECT_EQ(mu[1], cplx(1e6, 1e5));
}

TEST(ComplexModulus, StaysFiniteAtAnyFrequency) {
  const std::array omega{1e300};
  EXPECT_DOUBLE_EQ(complex_modulus(cases::rubber(), omega)[0].real(), 6e6);
  EXPECT_DOUBLE_EQ(complex_modulus(FractionalZener{6e6, 3e6, 0.125, 0.7}, omega)[0].real(), 6e6);
}

TEST(ComplexModulus, AcceptsWeightsThatSumToOneExceptForRoundOff) {
  const Prony fluid{1e6, {0.7, 0.0, 0.3 + 4e-16}, {1.0, 2.0, 3.0}};
  const std::array omega{1e-3, 1e9};
  const auto mu = complex_modulus(fluid, omega);
  EXPECT_GT(mu[0].real(), 0.0);
  EXPECT_LT(mu[0].real(), 10.0);  // 1e6 sum g (w tau)^2
  EXPECT_DOUBLE_EQ(mu[1].real(), 1e6);
  EXPECT_THROW(validate(Prony{1e6, {0.7, 0.301}, {1.0, 2.0}}), std::invalid_argument);
  EXPECT_THROW(validate(Prony{1e6, {-0.1}, {1.0}}), std::invalid_argument);
}

TEST(InvalidInput, NamesTheParameterByItsPathInATable) {
  try {
    validate(Prony{1e6, {-0.1}, {1.0}}, "");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.parameter(), "weights[0]");
    EXPECT_EQ(error.rule(), "must be in [0, 1]");
    EXPECT_EQ(error.value(), "-0.1");
    EXPECT_STREQ(error.what(), "weights[0] must be in [0, 1], got -0.1");
    EXPECT_STREQ(error.inside("ball.shear_modulus").what(),
                 "ball.shear_modulus.weights[0] must be in [0, 1], got -0.1");
    EXPECT_EQ(error.inside("ball.weights").parameter(), "ball.weights[0]");
    EXPECT_EQ(error.inside("ball.weights").allowed()->maximum, 1.0);
  }
}

TEST(ShortTimeModulus, IsTheLimitOfTheStorageModulus) {
  EXPECT_EQ(short_time_modulus(cases::rubber(), 1.0), 6e6);
  EXPECT_EQ(short_time_modulus(FractionalZener{6e6, 3e6, 0.125, 0.7}, 1.0), 6e6);
  EXPECT_EQ(short_time_modulus(HavriliakNegami{6e6, 3e6, 0.125, 0.7, 0.5}, 1.0), 6e6);
  EXPECT_EQ(short_time_modulus(Elastic{2e6}, 1.0), 2e6);
  EXPECT_EQ(short_time_modulus(KelvinVoigt{2e6, 1.0}, 1.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(short_time_modulus(KelvinVoigt{2e6, 0.0}, 1.0), 2e6);
  EXPECT_EQ(short_time_modulus(MasterCurve{{1.0, 2.0}, {1e6, 2e6}, {0.0, 0.0}}, 1.0), 2e6);
}

}  // namespace
}  // namespace viscoroll
