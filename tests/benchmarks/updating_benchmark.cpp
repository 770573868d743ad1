// What a changed model costs: solved anew, by Woodbury, with derivatives, in a
// step of the updater; and what the base costs, once. `line` is the time for
// one spectral line.
#include "tests/benchmarks/plate_case.hpp"
#include "updating/fit/updater.hpp"
#include "updating/residual/residual.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace tapfit::benchmarks {
namespace {

constexpr Eigen::Index line_count = 300;

// 24, 264, 10,086 and 99,072 degrees of freedom.
void sizes(benchmark::internal::Benchmark* b) {
  b->Args({2, 1})->Args({4, 10})->Args({41, 40})->Args({128, 128});
}

void count_lines(benchmark::State& state,
                 const PlateCase& plate,
                 Eigen::Index lines) {
  state.counters["dofs"] = static_cast<double>(plate.free.size());
  state.counters["base"] = static_cast<double>(plate.base.size());
  state.counters["line"] =
      benchmark::Counter(static_cast<double>(lines),
                         benchmark::Counter::kIsIterationInvariantRate |
                             benchmark::Counter::kInvert);
}

// A mass is added and one line solved again. Without damping the matrix is real
// and, below the first mode, definite: the cheapest case there is.
void solve_anew(benchmark::State& state) {
  const PlateCase& plate = plate_case(static_cast<int>(state.range(0)),
                                      static_cast<int>(state.range(1)));
  const double s = 2.0 * std::numbers::pi * 10.0;
  structure::SparseMatrix Z = plate.K + s * s * plate.M;
  Z.coeffRef(Z.rows() - 4, Z.rows() - 4) += s * s * 0.01;
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(Z.rows(), 6);
  for (Eigen::Index k = 0; k < 6; ++k) forces(Z.rows() - 1 - k, k) = 1.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(structure::Factor(Z).solve(forces));
  }
  count_lines(state, plate, 1);
}
BENCHMARK(solve_anew)->Apply(sizes)->Unit(benchmark::kMillisecond);

void respond(benchmark::State& state,
             const PlateCase& plate,
             std::size_t masses,
             Eigen::Index lines,
             bool derivatives) {
  const Eigen::VectorXcd s = band_lines(lines);
  const updating::FrfModel model = frf_model(plate, s);
  double mass = 0.01;
  for (auto _ : state) {
    mass *= 1.0001;  // another state each time: nothing can be kept
    benchmark::DoNotOptimize(
        model.respond(with_masses(plate, masses, mass), s, derivatives));
  }
  count_lines(state, plate, lines);
}

// (H* - H) / dP needs one of these per parameter.
void woodbury(benchmark::State& state) {
  respond(state,
          plate_case(static_cast<int>(state.range(0)),
                     static_cast<int>(state.range(1))),
          1,
          line_count,
          false);
}
BENCHMARK(woodbury)->Apply(sizes)->Unit(benchmark::kMillisecond);

// -H dZ/dP H for every parameter at once: the mass and five damping ratios.
void analytic(benchmark::State& state) {
  respond(state,
          plate_case(static_cast<int>(state.range(0)),
                     static_cast<int>(state.range(1))),
          1,
          line_count,
          true);
}
BENCHMARK(analytic)->Apply(sizes)->Unit(benchmark::kMillisecond);

// One step of the updater: FRFs with derivatives, the step, FRFs of where it
// goes. The masses' sizes are off by a half.
void iterate(benchmark::State& state,
             const PlateCase& plate,
             std::size_t masses,
             Eigen::Index lines) {
  const Eigen::VectorXcd s = band_lines(lines);
  const updating::FrfModel model = frf_model(plate, s);
  const updating::ModelState truth = with_masses(plate, masses, 0.01);
  signal::FrfSet measured = measured_pairs(plate.bundle, s);
  const Eigen::MatrixXcd H = model.respond(truth, s, false).H;
  for (Eigen::Index f = 0; f < H.cols(); ++f) {
    measured.frfs[static_cast<std::size_t>(f)].H = H.col(f);
  }
  const updating::Target target = updating::make_target(measured);
  const updating::ModelState start = with_masses(plate, masses, 0.015);
  const auto count = static_cast<Eigen::Index>(masses) + start.zeta.size();
  const updating::Prior prior{Eigen::VectorXd::Zero(count),
                              Eigen::VectorXd::Constant(count, 1e6),
                              Eigen::VectorXd::Constant(count, -1e3),
                              Eigen::VectorXd::Constant(count, 1e3)};
  updating::MinimiseOptions options;
  options.most_steps = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        updating::update(model, target, start, prior, options));
  }
  count_lines(state, plate, lines);
  state.counters["parameters"] = static_cast<double>(count);
}

void iteration_size(benchmark::State& state) {
  iterate(state,
          plate_case(static_cast<int>(state.range(0)),
                     static_cast<int>(state.range(1))),
          1,
          line_count);
}
BENCHMARK(iteration_size)->Apply(sizes)->Unit(benchmark::kMillisecond);

void iteration_parameters(benchmark::State& state) {
  iterate(state,
          plate_case(41, 40),
          static_cast<std::size_t>(state.range(0)),
          line_count);
}
BENCHMARK(iteration_parameters)
    ->DenseRange(0, 6, 2)
    ->Unit(benchmark::kMillisecond);

void iteration_lines(benchmark::State& state) {
  iterate(state, plate_case(41, 40), 1, state.range(0));
}
BENCHMARK(iteration_lines)
    ->RangeMultiplier(4)
    ->Range(16, 4096)
    ->Unit(benchmark::kMillisecond);

void eigenmodes(benchmark::State& state) {
  const PlateCase& plate = plate_case(static_cast<int>(state.range(0)),
                                      static_cast<int>(state.range(1)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(structure::eigenmodes(plate.K, plate.M, 20));
  }
  count_lines(state, plate, 1);
}
BENCHMARK(eigenmodes)->Apply(sizes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tapfit::benchmarks
