#include "updating/studies/truss_study.hpp"

#include "updating/fit/updater.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using acquisition::SeededRandom;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double high_hz = 500.0;
constexpr double step_hz = 1.0;
constexpr double cases_hz = 400.0;  // the band of section 4.1.3
constexpr Index modes = 7;          // below high_hz
constexpr int steps = 15;           // of Figure 5
// As the session's fits: wide peaks first.
constexpr std::array<double, 2> deltas = {0.06, 0.03};

signal::FrfSet noisy(signal::FrfSet set, SeededRandom& random) {
  add_noise(set, paper_noise, random);
  return set;
}

std::vector<Dof> points() { return {{4, 2, 1}, {10, 2, 1}}; }

Prior wide_prior(const PropertyStudy& study) {
  const auto n = static_cast<Index>(study.nominal().size());
  Prior prior;
  prior.mean = VectorXd::Zero(n);
  prior.sd.resize(n);
  for (Index k = 0; k < n; ++k) {
    prior.sd(k) =
        study.bundle().uncertain[static_cast<std::size_t>(k)].sd_percent /
        100.0;
  }
  prior.lower = VectorXd::Constant(n, -1.0);
  prior.upper = VectorXd::Constant(n, 1.0);
  return prior;
}

// The program's own method: update() on wide, then on narrow lines.
UpdateResult on_damped_lines(const PropertyStudy& study,
                             const FrfModel& model,
                             const std::array<signal::FrfSet, 2>& measured) {
  UpdateResult result;
  ModelState state = study.state(model, study.nominal());
  for (const signal::FrfSet& set : measured) {
    result = update(model, make_target(set), state, wide_prior(study), {});
    state = result.state;
  }
  return result;
}

}  // namespace

double largest_error(const std::vector<double>& identified,
                     const std::vector<double>& truth) {
  double largest = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    largest = std::max(largest, std::abs(identified[k] / truth[k] - 1.0));
  }
  return largest;
}

TrussStudy::TrussStudy(const std::filesystem::path& folder)
    : study_(folder, points(), 1e4),  // every mode
      model_(study_.model_at(study_.nominal())),
      true_hz_(study_.frequencies_hz(truth(), modes)),
      nominal_hz_(study_.frequencies_hz(study_.nominal(), modes)) {
  const VectorXd f = even_lines(high_hz, step_hz);
  exact_ = study_.exact(truth(), lines_at(f));
  for (std::size_t k = 0; k < deltas.size(); ++k) {
    exact_damped_.at(k) = study_.exact(truth(), lines_at(f, deltas.at(k)));
  }
}

signal::FrfSet TrussStudy::measured(std::uint64_t seed) const {
  SeededRandom random(seed, "noise");
  return noisy(exact_, random);
}

TrussSensitivity TrussStudy::sensitivity() const {
  const VectorXd f = even_lines(cases_hz, step_hz);
  const std::vector<bool> use =
      off_peaks(f, nominal_hz_, nominal_hz_, PeakRule{});
  std::vector<Index> kept;
  for (std::size_t l = 0; l < use.size(); ++l) {
    if (use[l]) kept.push_back(static_cast<Index>(l));
  }
  return {study_, points().back(), lines_at(f(kept))};
}

PlainResult TrussStudy::plain(std::uint64_t seed) const {
  PlainOptions options;
  options.max_iterations = steps;
  options.by_scatter = true;
  options.rule = PeakRule{};
  options.measured_hz = true_hz_;
  return plain_update(model_,
                      make_target(measured(seed)),
                      study_.state(model_, study_.nominal()),
                      options);
}

std::array<LineCase, 3> TrussStudy::cases(std::uint64_t seed) const {
  SeededRandom choice(seed, "lines");
  SeededRandom random(seed, "noise of the cases");
  // Peaks of the model to be updated: it is the softer one, so that these
  // lines are to the left of both.
  const std::array<VectorXd, 3> lines = {
      even_lines(cases_hz, 10.0),
      random_lines(cases_hz, 40, choice),
      lines_before_peaks(nominal_hz_.head(5))};
  std::array<LineCase, 3> result;
  result[0].lines = "every 10 Hz";
  result[1].lines = "40 at random";
  result[2].lines = "8 to the left of each resonance";
  PlainOptions options;
  options.max_iterations = steps;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](double delta) {
      return noisy(study_.exact(truth(), lines_at(lines.at(k), delta)), random);
    };
    LineCase& c = result.at(k);
    c.plain = plain_update(model_,
                           make_target(at(0.0)),
                           study_.state(model_, study_.nominal()),
                           options);
    c.plain_error = largest_error(c.plain.state.factor, truth());
    const UpdateResult damped =
        on_damped_lines(study_, model_, {at(deltas[0]), at(deltas[1])});
    c.damped_converged = damped.converged;
    c.damped_error = largest_error(damped.state.factor, truth());
  }
  return result;
}

SeedCount TrussStudy::count_seeds(int seeds, const Progress& progress) const {
  SeedCount count;
  count.seeds = seeds;
  for (int k = 1; k <= seeds; ++k) {
    progress("noise seeds", static_cast<double>(k - 1) / seeds);
    const auto seed = static_cast<std::uint64_t>(k);
    const double by_plain = largest_error(plain(seed).state.factor, truth());
    SeededRandom random(seed, "noise on damped lines");
    const UpdateResult fit = on_damped_lines(
        study_,
        model_,
        {noisy(exact_damped_[0], random), noisy(exact_damped_[1], random)});
    const double by_damped = largest_error(fit.state.factor, truth());
    count.plain += by_plain <= count.within ? 1 : 0;
    count.damped += by_damped <= count.within ? 1 : 0;
    count.plain_worst = std::max(count.plain_worst, by_plain);
    count.damped_worst = std::max(count.damped_worst, by_damped);
  }
  return count;
}

}  // namespace tapfit::updating
