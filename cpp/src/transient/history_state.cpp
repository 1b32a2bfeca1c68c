// Saved states of a history.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "materials/creep_spectrum.hpp"
#include "transient/history_impl.hpp"
#include "transient/history_input.hpp"
#include "transient/numbers.hpp"

namespace viscoroll {
namespace {

using detail::CreepSpectrum;
using detail::NumberReader;
using detail::NumberWriter;

/// Write a spectrum, so that the history continues with the retardation times with which it began.
void write_spectrum(const CreepSpectrum& spectrum, NumberWriter& numbers) {
  const auto vector = [&](const std::vector<double>& values) {
    numbers.put(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  numbers.put(spectrum.instantaneous);
  vector(spectrum.weights);
  vector(spectrum.retardation_times);
  numbers.put(spectrum.error);
}

/// Read a spectrum that `write_spectrum` has written.
CreepSpectrum read_spectrum(NumberReader& numbers) {
  const auto vector = [&] {
    const Eigen::MatrixXd values = numbers.matrix();
    return std::vector<double>(values.data(), values.data() + values.size());
  };
  CreepSpectrum spectrum;
  spectrum.instantaneous = numbers.get();
  spectrum.weights = vector();
  spectrum.retardation_times = vector();
  spectrum.error = numbers.get();
  NumberReader::require(spectrum.weights.size() == spectrum.retardation_times.size());
  NumberReader::require(std::ranges::all_of(spectrum.retardation_times, [](double time) { return time > 0.0; }));
  return spectrum;
}

}  // namespace

using detail::reject;
using detail::ShiftedMesh;
using Eigen::Index;

RollingState RollingHistory::Impl::state() const {
  RollingState state;
  detail::NumberWriter numbers(state.numbers);
  numbers.put(static_cast<double>(pair->half_nodes()));
  numbers.put(static_cast<double>(pair->track_reach));
  numbers.put(static_cast<double>(meshes.size()));
  pair->heights.write(numbers);
  for (const detail::ViscoelasticBody& body : pair->bodies) {
    numbers.put(body.tables.diagonal_compliance());
    write_spectrum(body.spectrum, numbers);
  }
  for (const double number : {current.time, contact_stiffness, last_step, static_cast<double>(steps)})
    numbers.put(number);
  detail::write(started, numbers);
  for (const ShiftedMesh& mesh : meshes) mesh.write(numbers);
  return state;
}

void RollingHistory::Impl::restore(const RollingState& state, detail::Watch& watch) {
  constexpr double kSame = 1e-9;
  detail::NumberReader numbers(state.numbers);
  const Index half_nodes = numbers.count(options.mesh->nodes_per_revolution);
  const Index track_reach = numbers.count(static_cast<double>(pair->max_track_reach()));
  if (numbers.count(detail::kMaxAveragedMeshes) != static_cast<Index>(meshes.size())) {
    reject("start", "a state with the same number of averaged meshes (" + std::to_string(meshes.size()) + ")",
           "a state with another number");
  }
  pair->heights.require_same(numbers);
  Impl next(*this);
  for (std::size_t b = 0; b < spectra.size(); ++b) {
    const double compliance = numbers.get();
    if (!(std::abs(compliance / pair->bodies[b].tables.diagonal_compliance() - 1.0) < kSame)) {
      reject("start", "a state of the same bodies and mesh", "a state with another compliance");
    }
    next.spectra[b].spectrum = read_spectrum(numbers);
    if (!(detail::difference(next.spectra[b].spectrum, spectra[b].spectrum) <=
          std::max(kSame, 2.0 * options.spectrum_tolerance))) {
      reject("start", "a state of the same materials", "a state with another creep function");
    }
  }
  next.pair = next.with({.half_nodes = half_nodes, .track_reach = track_reach}, watch);
  next.current.time = numbers.get();
  next.contact_stiffness = numbers.get();
  next.last_step = numbers.get();
  next.steps = numbers.count(1e15);
  next.started = detail::read_started_segment(numbers);
  if (next.started) {
    const auto& [begin, end, last_step_before, taken] = *next.started;
    detail::NumberReader::require(begin.time <= next.current.time && next.current.time <= end.time &&
                                  std::abs(end.angle - begin.angle) <= max_turn());
  }
  std::vector<RollingInstant> instants;
  for (std::size_t l = 0; l < meshes.size(); ++l) {
    next.meshes[l] = ShiftedMesh(next.pair, static_cast<double>(l) / static_cast<double>(meshes.size()), 1);
    next.meshes[l].read(numbers, [&watch] { watch.poll("restoring", 0.0); });
    instants.push_back(next.meshes[l].current());
  }
  numbers.finish();
  next.current = next.mean(instants, next.current.time);
  *this = std::move(next);
}

}  // namespace viscoroll
