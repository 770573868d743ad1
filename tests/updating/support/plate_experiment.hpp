// A hammer test of the sample plate with something in it that the model lacks.
#pragma once

#include "tests/updating/support/sample_plate.hpp"
#include "updating/diagnosis/diagnose.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/damped_line.hpp"

#include <cmath>
#include <complex>
#include <optional>
#include <random>
#include <vector>

namespace tapfit::updating {

/// A test whose "measurement" is the model with an effect, its modulus off by
/// 2 %, its damping scattered about 0.8 %, and noise on every line.
class PlateExperiment : private support::BasedPlate {
 public:
  PlateExperiment(const std::vector<EffectInstance>& hidden,
                  double noise,
                  unsigned seed,
                  double identified_damping = 0.008,
                  bool clamped = true)
      : BasedPlate(clamped) {
    FitProblem fit;
    fit.context = context_;
    fit.uncertain_sd = {0.03};
    fit.damping_ratio = 0.008;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (const double delta : {0.06, 0.03}) {
      const Eigen::VectorXcd s = damped_line({10.0, 400.0}, 3.0, {delta, 120});
      signal::FrfSet set = support::plate_pairs(bundle_, s);
      fit.measured = set;
      fit.targets = {make_target(set)};
      const Fitter truth(builder_, fit);
      const auto model = truth.model_for(hidden);
      ModelState state = truth.first_state(*model, hidden);
      state.factor = {1.02};
      for (Eigen::Index q = 0; q < state.zeta.size(); ++q) {
        state.zeta(q) = q % 2 == 0 ? 0.006 : 0.010;
      }
      const Eigen::MatrixXcd H = model->respond(state, s, false).H;
      // Noise in proportion to each line's mean, as the error counts it.
      const Eigen::VectorXd level =
          noise * H.cwiseAbs2().rowwise().mean().cwiseSqrt();
      for (std::size_t f = 0; f < set.frfs.size(); ++f) {
        signal::Frf& frf = set.frfs[f];
        frf.H = H.col(static_cast<Eigen::Index>(f));
        for (Eigen::Index l = 0; l < s.size(); ++l) {
          frf.H(l) +=
              level(l) * std::complex<double>(normal(random), normal(random));
        }
        frf.variance = 2.0 * level.cwiseAbs2();
      }
      measured_.push_back(set);
    }
    fit.measured = measured_.back();
    fit.targets = {make_target(measured_[0]), make_target(measured_[1])};
    for (Target& target : fit.targets) target.modes_in_band = 5;
    fit.damping_ratio = identified_damping;
    fitter_.emplace(builder_, fit);
  }

  [[nodiscard]] const Fitter& fitter() const { return *fitter_; }
  /// @param mesh_floor what a coarse mesh might explain
  [[nodiscard]] Diagnosis diagnose_it(const Progress& progress = {},
                                      double mesh_floor = 0.0) const {
    return diagnose(*fitter_, {}, options(mesh_floor), progress);
  }
  [[nodiscard]] DiagnoseOptions options(double mesh_floor = 0.0) const {
    DiagnoseOptions options;
    options.floor_noise = std::max(noise_error(fitter_->target()), 1e-3);
    options.floor = std::hypot(options.floor_noise, mesh_floor);
    options.properties = {{"E:1", "Pa", 70e9}};
    return options;
  }

 private:
  std::vector<signal::FrfSet> measured_;
  std::optional<Fitter> fitter_;
};

}  // namespace tapfit::updating
