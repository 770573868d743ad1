// What a complete stabilisation diagram costs, from FRFs to marked poles at
// every order, and how that grows with order, FRFs and lines.
#include "modal/poles/stabilisation.hpp"
#include "tests/modal/support/synthetic_frfs.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>

namespace tapfit::benchmarks {
namespace {

/// A roving hammer past fixed sensors on a structure of 12 modes, 1 % noise.
const signal::FrfSet& frfs_of(Eigen::Index frfs,
                              Eigen::Index lines,
                              Eigen::Index references) {
  static std::map<std::tuple<Eigen::Index, Eigen::Index, Eigen::Index>,
                  signal::FrfSet>
      made;
  const auto key = std::tuple(frfs, lines, references);
  if (const auto found = made.find(key); found != made.end()) {
    return found->second;
  }
  std::mt19937_64 random(7);
  test::SyntheticSystem system;
  system.frequency_hz = Eigen::VectorXd::LinSpaced(12, 20.0, 480.0);
  system.damping_ratio = Eigen::VectorXd::Constant(12, 0.005);
  system.phi = test::random_shapes(frfs / references, 12, random);
  std::vector<Eigen::Index> sensors;
  for (Eigen::Index k = 0; k < references; ++k) sensors.push_back(k);
  return made[key] = test::roving_hammer(system,
                                         sensors,
                                         test::line_points(5, 500, lines, 0.0),
                                         0.01,
                                         random);
}

void run(benchmark::State& state, const signal::FrfSet& frfs) {
  modal::IdentifyOptions options;
  options.max_order = static_cast<int>(state.range(0));
  std::size_t poles = 0;
  for (auto _ : state) {
    std::vector<std::string> warnings;
    const modal::WeightedFrfs curves = modal::prepare_frfs(frfs, warnings);
    const std::vector<modal::OrderPoles> orders = modal::plscf_poles(
        curves, modal::arrange_frfs(curves), options.max_order, {});
    const modal::Stabilisation found =
        modal::stabilise(orders,
                         curves.s(0).imag(),
                         curves.s(curves.lines() - 1).imag(),
                         options);
    poles = found.diagram.size();
    benchmark::DoNotOptimize(poles);
  }
  state.counters["poles"] = static_cast<double>(poles);
}

void diagram(benchmark::State& state) {
  run(state, frfs_of(state.range(1), state.range(2), state.range(3)));
}

void names(benchmark::internal::Benchmark* b) {
  b->ArgNames({"order", "frfs", "lines", "references"})
      ->Unit(benchmark::kMillisecond);
}

// FRFs of single hits, whose scatter has to be read off their roughness.
void diagram_of_single_hits(benchmark::State& state) {
  signal::FrfSet frfs = frfs_of(state.range(1), state.range(2), state.range(3));
  for (signal::Frf& frf : frfs.frfs) frf.hits = 1;
  run(state, frfs);
}

// The whole, with one to four references used together.
BENCHMARK(diagram)
    ->Apply(names)
    ->Args({100, 100, 4000, 1})
    ->Args({100, 100, 4000, 2})
    ->Args({100, 100, 4000, 4});

BENCHMARK(diagram_of_single_hits)->Apply(names)->Args({100, 100, 4000, 2});

// Growth with the order, the FRFs and the lines.
BENCHMARK(diagram)
    ->Apply(names)
    ->Args({25, 100, 4000, 2})
    ->Args({50, 100, 4000, 2})
    ->Args({100, 100, 4000, 2})
    ->Args({200, 100, 4000, 2})
    ->Args({100, 25, 4000, 2})
    ->Args({100, 50, 4000, 2})
    ->Args({100, 200, 4000, 2})
    ->Args({100, 400, 4000, 2})
    ->Args({100, 100, 1000, 2})
    ->Args({100, 100, 2000, 2})
    ->Args({100, 100, 8000, 2})
    ->Args({100, 100, 16000, 2});

}  // namespace
}  // namespace tapfit::benchmarks
