// How far estimates of the deck's forms are to be trusted, on frames that are
// drawn as the forms' priors say and measured with noise.
#include "acquisition/foundation/seeded_random.hpp"
#include "tests/updating/support/based_frame.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/corrections/deck_forms.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/damped_line.hpp"
#include "updating/properties/line_mass.hpp"
#include "updating/properties/section_shear.hpp"
#include "updating/residual/mesh_error.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/mesh/stiff_corners.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

using acquisition::SeededRandom;
using Eigen::Index;
using structure::Deck;

constexpr double noise = 0.02;  // of each line's mean
constexpr double sd_of_E = 0.03;
constexpr double typical_zeta = 0.008;
constexpr double zeta_spread = 0.3;
constexpr std::array<double, 2> widths = {0.06, 0.03};  // sigma / omega

// E, the mesh, section shear, corners, masses on lines: the factors of the
// frame's base.
constexpr std::size_t shear_factor = 2;
constexpr std::size_t corner_factor = 3;
constexpr std::size_t mass_factor = 4;

double draw(const Correction& prior, SeededRandom& random) {
  for (;;) {
    const double t = prior.mean + prior.sd * random.normal();
    if (t > prior.lower && t < prior.upper) return t;
  }
}

std::vector<double> draw_factors(const support::BasedFrame& base,
                                 SeededRandom& random) {
  std::vector<double> factor = {std::exp(sd_of_E * random.normal())};
  for (const Correction& c : base.corrections) {
    factor.push_back(std::exp(draw(c, random)));
  }
  return factor;
}

// White noise on lines s = sigma + j omega: an exponential window leaves lines
// alike that are near each other,
//   C_lm = 2 sqrt(sigma_l sigma_m) / (s_l + conj(s_m)).
// @return L, C = L L'
Eigen::MatrixXcd noise_between(const Eigen::VectorXcd& s) {
  Eigen::MatrixXcd C(s.size(), s.size());
  for (Index l = 0; l < s.size(); ++l) {
    for (Index m = 0; m < s.size(); ++m) {
      C(l, m) =
          2.0 * std::sqrt(s(l).real() * s(m).real()) / (s(l) + std::conj(s(m)));
    }
  }
  return C.llt().matrixL();
}

void add_noise(const Eigen::MatrixXcd& H,
               SeededRandom& random,
               signal::FrfSet& set) {
  const Eigen::VectorXd level =
      noise * H.cwiseAbs2().rowwise().mean().cwiseSqrt();
  const Eigen::MatrixXcd L = noise_between(set.s);
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    Eigen::VectorXcd white(set.s.size());
    for (auto& value : white) value = {random.normal(), random.normal()};
    signal::Frf& frf = set.frfs[f];
    frf.H = H.col(static_cast<Index>(f));
    frf.H += (level.array() * (L * white).array()).matrix();
    frf.variance = 2.0 * level.cwiseAbs2();
  }
}

// What a hammer test of a model with these factors measures.
std::vector<signal::FrfSet> measure(const BaseBuilder& builder,
                                    FitProblem problem,
                                    const std::vector<double>& factor,
                                    SeededRandom& random) {
  Eigen::VectorXd zeta(40);  // more than modes that are measured
  for (double& ratio : zeta) ratio = typical_zeta * random.scatter(zeta_spread);
  std::vector<signal::FrfSet> sets;
  for (const double width : widths) {
    signal::FrfSet set = support::plate_pairs(
        *problem.context.bundle,
        damped_line(support::frame_band_hz, 1.0, {width, 120}));
    problem.measured = set;
    problem.targets = {make_target(set)};
    const Fitter truth(builder, problem);
    const auto model = truth.model_for({});
    ModelState state = truth.first_state(*model, {});
    state.factor = factor;
    state.zeta = zeta.head(state.zeta.size());
    add_noise(model->respond(state, set.s, false).H, random, set);
    sets.push_back(std::move(set));
  }
  return sets;
}

FitProblem problem_of(const support::BasedFrame& base) {
  FitProblem problem;
  problem.context = base.context();
  problem.uncertain_sd = {sd_of_E};
  for (const Correction& c : base.corrections) {
    problem.uncertain_sd.push_back(c.sd);
  }
  problem.corrections = base.corrections;
  problem.damping_ratio = typical_zeta;
  return problem;
}

// Without effects, as every diagnosis begins.
Fit fit_frame(const support::BasedFrame& base,
              const std::vector<signal::FrfSet>& measured) {
  FitProblem problem = problem_of(base);
  for (const signal::FrfSet& set : measured) {
    problem.targets.push_back(make_target(set));
  }
  problem.measured = measured.back();
  Fitter fitter(base.builder, problem);
  fitter.set_mesh(base.coarse);
  return fitter.fit({}, fitter.model_for({}));
}

TEST(FormCoverage, IntervalsHold) {
  constexpr std::uint64_t draws = 20;
  const support::BasedFrame base;
  ASSERT_EQ(base.corrections.size(), 4U);
  std::vector<int> inside(1 + base.corrections.size(), 0);  // E first
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    SeededRandom random(seed, "frame");
    const std::vector<double> truth = draw_factors(base, random);
    const Fit fit =
        fit_frame(base, measure(base.builder, problem_of(base), truth, random));
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const auto at = static_cast<Index>(k);
      const double sd = std::sqrt(fit.result.covariance(at, at));
      const double off = std::log(fit.result.state.factor.at(k) / truth[k]);
      inside[k] += std::abs(off) < 1.96 * sd ? 1 : 0;
      if (k != shear_factor && k != mass_factor) continue;
      // The data say more of these forms than the prior does.
      EXPECT_LT(sd, 0.5 * base.corrections[k - 1].sd) << k << ' ' << seed;
    }
  }
  // 95 % of 20 is 19; fewer than 16 come out once in 400 times.
  for (std::size_t k = 0; k < inside.size(); ++k) EXPECT_GE(inside[k], 16) << k;
}

// Stiffer by a share of what whole corners add:
// 1 / (1 - s') = 1 + share s / (1 - s).
std::map<int, double> part_of_corners(const Deck& deck, double share) {
  std::map<int, double> inside = structure::inside_corners(deck);
  for (auto& [id, s] : inside) s = 1.0 - 1.0 / (1.0 + share * s / (1.0 - s));
  return inside;
}

// Of cards that say what the factors stand for. Sections turn or do not.
Deck built(const Deck& deck, const std::vector<double>& factor) {
  Deck truth = with_section_shear(without_line_mass(deck),
                                  shearless_sections(deck),
                                  factor[shear_factor] - 1.0);
  for (auto& [id, material] : truth.materials) {
    material.E *= factor[0];
    material.G *= factor[0];
  }
  return structure::with_stiff_corners(
      truth, part_of_corners(deck, factor[corner_factor] - 1.0));
}

// Forms are taken as linear in their shares. What shear and corners do together
// and what shear does beyond a share of 1 is not: up to a seventh of the
// factor, of corners, which do least, a third. The fit leaves hardly more than
// the noise all the same.
TEST(FormCoverage, FramesBuiltThatWayAreFitted) {
  const support::BasedFrame base;
  ASSERT_EQ(base.corrections.size(), 4U);
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SeededRandom random(seed, "frame");
    std::vector<double> truth = draw_factors(base, random);
    truth[mass_factor] = 2.0;
    const Deck deck = built(structure::refine_mesh(base.deck).deck, truth);
    acquisition::TestBundle bundle = base.bundle;
    bundle.uncertain.clear();
    FitProblem plain;
    plain.context = base.context();
    plain.context.deck = &deck;
    plain.context.bundle = &bundle;
    plain.damping_ratio = typical_zeta;
    const BaseBuilder builder = support::frame_builder(deck, bundle, false);
    const Fit fit = fit_frame(base, measure(builder, plain, {}, random));
    // Noise is in both parts of a value.
    EXPECT_LT(fit.result.error, 1.2 * std::sqrt(2.0) * noise) << seed;
    const std::vector<double>& found = fit.result.state.factor;
    EXPECT_NEAR(std::log(found[shear_factor] / truth[shear_factor]), 0.0, 0.2)
        << seed;
    EXPECT_NEAR(
        std::log(found[corner_factor] / truth[corner_factor]), 0.0, 0.35)
        << seed;
    EXPECT_NEAR(std::log(found[mass_factor] / truth[mass_factor]), 0.0, 0.05)
        << seed;
  }
}

}  // namespace
}  // namespace tapfit::updating
