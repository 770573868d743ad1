#include "updating/studies/wing_study.hpp"

#include "updating/studies/truss_study.hpp"

namespace tapfit::updating {
namespace {

constexpr double high_hz = 12.0;
constexpr double step_hz = 0.0125;
constexpr double reach_hz = 60.0;  // five times the band
constexpr Eigen::Index modes = 9;  // below high_hz
constexpr int rounds = 3;

std::vector<Dof> points() {
  std::vector<Dof> all;
  for (const int node : {13, 26}) {
    for (const int component : {1, 2, 3}) all.push_back({node, component, 1});
  }
  return all;
}

}  // namespace

WingStudy::WingStudy(const std::filesystem::path& folder)
    : study_(folder, points(), reach_hz, {0.2, 0.0005}),
      exact_(study_.exact(truth(), lines_at(even_lines(high_hz, step_hz)))) {}

signal::FrfSet WingStudy::measured(std::uint64_t seed) const {
  acquisition::SeededRandom random(seed, "noise");
  signal::FrfSet set = exact_;
  add_noise(set, paper_noise, random);
  return set;
}

WingResult WingStudy::identify(std::uint64_t seed) const {
  const Target target = make_target(measured(seed));
  PlainOptions options;
  options.by_scatter = true;
  // Peaks of 2 to 6 % damping are wide; the truss's 4 Hz would leave nothing.
  options.rule = PeakRule{0.2, 0.0};
  options.measured_hz = study_.frequencies_hz(truth(), modes);
  WingResult result;
  result.factor = study_.nominal();
  for (int round = 0; round < rounds; ++round) {
    const FrfModel model = study_.model_at(result.factor);
    result.last = plain_update(
        model, target, study_.state(model, study_.nominal()), options);
    const Eigen::Index done = result.history.rows();
    const Eigen::MatrixXd& steps = result.last.history;
    result.history.conservativeResize(done + steps.rows(), steps.cols());
    for (Eigen::Index k = 0; k < steps.cols(); ++k) {
      double& factor = result.factor[static_cast<std::size_t>(k)];
      result.history.col(k).tail(steps.rows()) = factor * steps.col(k);
      factor *= result.last.state.factor[static_cast<std::size_t>(k)];
    }
  }
  return result;
}

}  // namespace tapfit::updating
