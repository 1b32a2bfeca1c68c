#include "materials/long_tests.hpp"

#include <Eigen/Eigenvalues>
#include <cstddef>

namespace viscoroll::detail {

LongTest::LongTest(const RelaxingTerms& terms, double shortest) : total_(terms.relaxed) {
  constexpr double kFast = 1e-6;
  std::vector<double> moduli;
  std::vector<double> times;
  for (std::size_t k = 0; k < terms.times.size(); ++k) {
    if (terms.times[k] < kFast * shortest) continue;
    moduli.push_back(terms.moduli[k]);
    times.push_back(terms.times[k]);
    total_ += terms.moduli[k];
  }
  const auto size = static_cast<Eigen::Index>(moduli.size());
  moduli_ = Eigen::Map<const Eigen::ArrayXd>(moduli.data(), size);
  times_ = Eigen::Map<const Eigen::ArrayXd>(times.data(), size);
  coupling_ = (moduli_ / times_).sqrt().matrix();
  Eigen::MatrixXd matrix = -coupling_ * coupling_.transpose() / total_;
  matrix.diagonal().array() += 1.0 / times_;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  rates_ = solver.eigenvalues().array().max(0.0);
  modes_ = solver.eigenvectors();
}

double LongTest::compression_set(double duration, double recovery) const {
  const Eigen::VectorXd held = (-(-duration / times_).expm1() * (moduli_ * times_).sqrt()).matrix();
  const Eigen::VectorXd decay = (-rates_ * recovery).exp().matrix();
  return coupling_.dot(modes_ * decay.cwiseProduct(modes_.transpose() * held)) / total_;
}

double LongTest::creep(double time) const {
  const Eigen::ArrayXd amplitude = (modes_.transpose() * coupling_).array();
  const Eigen::ArrayXd growth = (rates_ * time > 1e-12).select(-(-rates_ * time).expm1() / rates_, time);
  return (1.0 + (amplitude.square() * growth).sum() / total_) / total_;
}

}  // namespace viscoroll::detail
