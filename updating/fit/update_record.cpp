#include "updating/fit/update_record.hpp"

#include "updating/fit/estimates.hpp"
#include "updating/fit/prior_l_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What pack() holds: names, and what its exponential is multiplied with.
struct Named {
  std::vector<std::string> name;
  std::vector<double> unit;
  std::vector<Index> shown;  // all but the damping
};

Named named_parameters(const Fit& fit,
                       const effects::TestContext& context,
                       const std::vector<PropertyName>& properties) {
  const ModelState& state = fit.result.state;
  const std::vector<Correction>& corrections = fit.model->base().corrections;
  Named all;
  const auto add = [&all](std::string name, double unit, bool shown) {
    if (shown) all.shown.push_back(static_cast<Index>(all.name.size()));
    all.name.push_back(std::move(name));
    all.unit.push_back(unit);
  };
  const std::size_t own = state.factor.size() - corrections.size();
  for (std::size_t k = 0; k < state.factor.size(); ++k) {
    if (k >= own) {
      add(corrections[k - own].name, 1.0, true);
    } else {
      add(properties.at(k).name, properties[k].nominal, true);
    }
  }
  for (Index q = 0; q < state.zeta.size(); ++q) {
    add(fmt::format("damping of mode {}", q + 1), 1.0, false);
  }
  for (std::size_t k = 0; k < state.effects.size(); ++k) {
    const EffectInstance& e = state.effects[k];
    const std::string label = label_of(state.effects, k);
    for (const effects::ParameterSpec& spec :
         e.effect->parameters(e.where, context)) {
      add(label + " " + spec.name, 1.0, true);
    }
  }
  return all;
}

MatrixXd correlation_of(const MatrixXd& covariance) {
  const VectorXd sd = covariance.diagonal().cwiseMax(1e-300).cwiseSqrt();
  return (sd.cwiseInverse().asDiagonal() * covariance *
          sd.cwiseInverse().asDiagonal());
}

void identify(const UpdateResult& result,
              const Named& named,
              UpdateRecord& record) {
  std::vector<Index> fitted;
  for (Index k = 0; k < result.covariance.rows(); ++k) {
    if (result.covariance(k, k) > 0.0) fitted.push_back(k);
  }
  if (fitted.empty()) return;
  record.identifiability =
      identifiability(MatrixXd(result.jacobian(Eigen::all, fitted)));
  for (const std::vector<Index>& group : record.identifiability.confounded) {
    std::vector<std::string> names;
    bool counts = false;  // a damping that shows nowhere is nobody's concern
    for (const Index k : group) {
      const Index at = fitted[static_cast<std::size_t>(k)];
      counts =
          counts || std::ranges::find(named.shown, at) != named.shown.end();
      names.push_back(named.name[static_cast<std::size_t>(at)]);
    }
    if (counts) record.confounded.push_back(std::move(names));
  }
  record.correlation =
      correlation_of(MatrixXd(result.covariance(named.shown, named.shown)));
}

RecordedStep recorded(const UpdateStep& step, const Named& named) {
  RecordedStep result{
      step.stage, step.error, step.length, step.lambda, VectorXd()};
  result.values.resize(static_cast<Index>(named.shown.size()));
  for (std::size_t k = 0; k < named.shown.size(); ++k) {
    const Index at = named.shown[k];
    result.values(static_cast<Index>(k)) =
        std::exp(step.theta(at)) * named.unit[static_cast<std::size_t>(at)];
  }
  return result;
}

}  // namespace

UpdateRecord record_of(const Fit& fit,
                       const effects::TestContext& context,
                       const std::vector<PropertyName>& names,
                       const std::string& lines) {
  const UpdateResult& result = fit.result;
  Named named = named_parameters(fit, context, names);
  // What was held is no parameter of the fit.
  std::erase_if(named.shown, [&result](Index k) {
    return k < result.covariance.rows() && !(result.covariance(k, k) > 0.0);
  });
  UpdateRecord record;
  record.added = uncertain_rung;
  if (!fit.effects.empty()) {
    record.added = fit.effects.back().effect->name();
    record.where = fit.effects.back().where;
  }
  record.lines = lines;
  record.converged = result.converged;
  record.message = result.message;
  for (const Index k : named.shown) {
    record.parameters.push_back(named.name[static_cast<std::size_t>(k)]);
  }
  for (const UpdateStep& step : result.history) {
    record.steps.push_back(recorded(step, named));
  }
  record.l_curve = result.l_curve ? result.l_curve : prior_l_curve(result);
  identify(result, named, record);
  return record;
}

std::vector<UpdateRecord> records_of(const std::vector<Fit>& fits,
                                     const effects::TestContext& context,
                                     const std::vector<PropertyName>& names,
                                     const std::string& lines) {
  std::vector<UpdateRecord> records;
  for (std::size_t k = 1; k < fits.size(); ++k) {
    records.push_back(record_of(fits[k], context, names, lines));
  }
  return records;
}

}  // namespace tapfit::updating
