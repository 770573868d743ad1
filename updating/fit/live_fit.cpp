#include "updating/fit/live_fit.hpp"

#include "updating/fit/estimates.hpp"
#include "updating/fit/updater.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/properties/uncertain_property.hpp"
#include "updating/residual/residual.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;

/// One of theta, which is a logarithm.
LiveParameter parameter(std::string name,
                        double value,
                        Index k,
                        const IterationSummary& summary) {
  // ln value - theta: the scale of a property's factor.
  const double scale = value / std::exp(summary.step.theta(k));
  return {std::move(name),
          value,
          value * std::sqrt(std::max(summary.covariance(k, k), 0.0)),
          scale * std::exp(summary.prior.lower(k)),
          scale * std::exp(summary.prior.upper(k))};
}

std::vector<LiveParameter> parameters(const IterationSummary& summary) {
  const effects::TestContext& context = summary.model.context();
  const ModelState& state = summary.state;
  std::vector<LiveParameter> result;
  const auto& uncertain = context.bundle->uncertain;
  for (std::size_t k = 0; k < state.factor.size() && k < uncertain.size();
       ++k) {
    const PropertyLaw law =
        property_law(*context.deck, uncertain[k], "test.json: uncertain");
    result.push_back(parameter(law.name,
                               law.nominal * state.factor[k],
                               static_cast<Index>(k),
                               summary));
  }
  Index k = static_cast<Index>(state.factor.size()) + state.zeta.size();
  for (std::size_t e = 0; e < state.effects.size(); ++e) {
    const EffectInstance& placed = state.effects[e];
    const std::string label = label_of(state.effects, e);
    const auto specs = placed.effect->parameters(placed.where, context);
    for (std::size_t p = 0; p < specs.size(); ++p, ++k) {
      result.push_back(
          parameter(label + " " + specs[p].name, placed.p[p], k, summary));
    }
  }
  return result;
}

std::size_t worst_frf(const IterationSummary& summary) {
  Index worst = 0;
  double largest = -1.0;
  for (Index f = 0; f < summary.H.cols(); ++f) {
    const double error = frf_error(summary.target, summary.H, f);
    if (error <= largest) continue;
    largest = error;
    worst = f;
  }
  return static_cast<std::size_t>(worst);
}

}  // namespace

LiveFit live_fit(const IterationSummary& summary,
                 std::optional<std::size_t> frf) {
  LiveFit live;
  live.error = summary.step.error;
  live.parameters = parameters(summary);
  if (summary.target.is_modal()) return live;  // modes are no curve
  live.frf = frf.value_or(worst_frf(summary));
  const auto column = static_cast<Index>(live.frf);
  live.frequency_hz = summary.target.s.imag() / (2.0 * std::numbers::pi);
  live.measured = summary.target.H.col(column).cwiseAbs();
  live.model = summary.H.col(column).cwiseAbs();
  return live;
}

}  // namespace tapfit::updating
