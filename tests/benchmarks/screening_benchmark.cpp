// What a look at every effect at every place costs, against places, FRFs and
// lines. `hypotheses` are effects at places; each is scanned over its sizes
// with everything that is fitted readjusting.
#include "tests/benchmarks/plate_case.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/search/screening.hpp"

#include <benchmark/benchmark.h>

namespace tapfit::benchmarks {
namespace {

using updating::Fit;
using updating::Fitter;

// A plate of nx x ny shells, two sensors, with 7 g beside a hit point that are
// not in its model.
class ScreeningCase {
 public:
  ScreeningCase(int nx, int ny, int frfs, Eigen::Index lines)
      : plate_(plate_case(nx, ny)), bundle_(plate_.bundle) {
    // Hits along the free edge and the middle.
    bundle_.runs.resize(1);
    for (int k = 1; k < frfs / 2; ++k) {
      bundle_.runs.push_back(bundle_.runs.front());
      const int column = 1 + (k * (nx - 1)) / (frfs / 2);
      bundle_.runs.back().hammer.dof.node =
          1 + column * (ny + 1) + (k % 2 == 0 ? ny : ny / 3);
    }
    updating::FitProblem problem;
    problem.context = plate_.context;
    problem.context.bundle = &bundle_;
    problem.measured = measured_pairs(bundle_, band_lines(lines));
    problem.uncertain_sd = {0.1};
    problem.targets = {updating::make_target(problem.measured)};
    updating::BaseOptions options;
    options.high_hz = plate_.context.high_hz;
    options.split = false;
    options.points = updating::measured_points(plate_.deck, bundle_).all;
    builder_.emplace(
        plate_.deck,
        std::vector<acquisition::UncertainProperty>{{"material", 1, "E", 3.0}},
        options,
        Progress{});
    hide_mass(1 + (nx - 1) * (ny + 1), problem);
    fitter_.emplace(*builder_, std::move(problem));
    base_.model = fitter_->model_for({});
    base_.result.state = fitter_->first_state(*base_.model, {});
  }

  [[nodiscard]] std::vector<updating::Screened> screened() const {
    return updating::screen(base_, *fitter_, Progress{});
  }

 private:
  void hide_mass(int node, updating::FitProblem& problem) const {
    const Fitter blank(*builder_, problem);
    updating::EffectInstance mass{&effects::find("added-mass"), {}, {0.007}};
    mass.where.node = node;
    const auto truth = blank.model_for({mass});
    const Eigen::MatrixXcd H =
        truth
            ->respond(
                blank.first_state(*truth, {mass}), problem.measured.s, false)
            .H;
    for (Eigen::Index f = 0; f < H.cols(); ++f) {
      signal::Frf& frf = problem.measured.frfs[static_cast<std::size_t>(f)];
      frf.H = H.col(f);
      frf.variance = (0.01 * H.col(f)).cwiseAbs2();
    }
    problem.targets = {updating::make_target(problem.measured)};
  }

  const PlateCase& plate_;
  acquisition::TestBundle bundle_;
  std::optional<updating::BaseBuilder> builder_;
  std::optional<Fitter> fitter_;
  Fit base_;
};

void screening(benchmark::State& state) {
  const ScreeningCase test(static_cast<int>(state.range(0)),
                           static_cast<int>(state.range(1)),
                           static_cast<int>(state.range(2)),
                           state.range(3));
  std::size_t hypotheses = 0;
  for (auto _ : state) {
    const auto all = test.screened();
    hypotheses = all.size();
    benchmark::DoNotOptimize(all.front().error);
  }
  state.counters["hypotheses"] = static_cast<double>(hypotheses);
}
BENCHMARK(screening)
    ->ArgNames({"nx", "ny", "frfs", "lines"})
    ->Args({41, 40, 24, 300})  // the size to go by
    ->Args({20, 20, 24, 300})
    ->Args({10, 10, 24, 300})
    ->Args({41, 40, 12, 300})
    ->Args({41, 40, 48, 300})
    ->Args({41, 40, 24, 150})
    ->Args({41, 40, 24, 600})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace tapfit::benchmarks
