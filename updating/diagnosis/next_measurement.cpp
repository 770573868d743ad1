#include "updating/diagnosis/next_measurement.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using acquisition::Placement;
using acquisition::Run;
using acquisition::TestBundle;
using Eigen::Index;
using Eigen::MatrixXcd;

// Neighbouring grids of a fine mesh are one place to someone with a hammer.
constexpr std::size_t grids_tried = 120;

/// Runs that could be measured, and the FRF of each that is new.
struct Plan {
  TestBundle bundle;
  signal::FrfSet frfs;
  std::vector<bool> moves_sensor;  ///< of each FRF
};

void expect(Plan& plan, std::size_t run, const Placement& sensor, bool moved) {
  signal::Frf frf;
  frf.response = sensor.dof;
  frf.reference = plan.bundle.runs[run].hammer.dof;
  frf.run = run;
  frf.channel = sensor.channel;
  plan.frfs.frfs.push_back(std::move(frf));
  plan.moves_sensor.push_back(moved);
}

// Grids that can be hit and measured: what is held does not move.
std::vector<int> reachable(const Fit& fit,
                           const effects::TestContext& context) {
  std::vector<int> grids;
  for (const structure::Grid& grid : context.deck->grids) {
    if (grid.id > 0 &&
        fit.model->row(grid.id, context.component).norm() > 0.0) {
      grids.push_back(grid.id);
    }
  }
  const std::size_t step = grids.size() / grids_tried + 1;
  std::vector<int> tried;
  for (std::size_t k = 0; k < grids.size(); k += step) {
    tried.push_back(grids[k]);
  }
  return tried;
}

Plan plan_for(const Fit& fit, const effects::TestContext& context) {
  Plan plan;
  plan.bundle = *context.bundle;
  const Run as_it_was = context.bundle->runs.front();
  plan.bundle.runs.clear();
  for (const int grid : reachable(fit, context)) {
    const Dof here{grid, context.component, 1};
    const std::size_t hit = plan.bundle.runs.size();
    plan.bundle.runs.push_back(as_it_was);
    plan.bundle.runs.back().hammer.dof = here;
    for (const Placement& sensor : as_it_was.sensors) {
      expect(plan, hit, sensor, false);
    }
    for (std::size_t k = 0; k < as_it_was.sensors.size(); ++k) {
      plan.bundle.runs.push_back(as_it_was);
      Placement& sensor = plan.bundle.runs.back().sensors[k];
      sensor.dof = here;
      expect(plan, plan.bundle.runs.size() - 1, sensor, true);
    }
  }
  return plan;
}

MatrixXcd predict(const Fit& fit, const Fitter& fitter, const Plan& plan) {
  effects::TestContext context = fitter.problem().context;
  context.bundle = &plan.bundle;
  FrfModel model(fit.model->base(), context, plan.frfs);
  model.set_reference(fitter.first_state(model, fit.effects));
  return model.respond(fit.result.state, fitter.target().s, false).H;
}

// Root mean square over the lines, of each FRF.
Eigen::VectorXd apart(const MatrixXcd& a,
                      const MatrixXcd& b,
                      const Target& target) {
  const MatrixXcd scaled = target.weight.cwiseInverse().asDiagonal() * (a - b);
  return scaled.cwiseAbs2().colwise().mean().cwiseSqrt().transpose();
}

EffectRef last_of(const Fit& fit) {
  return {fit.effects.back().effect->name(), fit.effects.back().where};
}

}  // namespace

std::optional<NextMeasurement> next_measurement(const Fit& a,
                                                const Fit& b,
                                                const Fitter& fitter) {
  const effects::TestContext& context = fitter.problem().context;
  const Target& target = fitter.target();
  // Of modes it is not known how they were measured.
  if (context.bundle->runs.empty()) return std::nullopt;
  const Plan plan = plan_for(a, context);
  if (plan.frfs.frfs.empty()) return std::nullopt;
  const auto now = [&target](const Fit& fit) {
    return fit.model->respond(fit.result.state, target.s, false).H;
  };
  const Eigen::VectorXd differences =
      apart(predict(a, fitter, plan), predict(b, fitter, plan), target);
  Index best = 0;
  NextMeasurement next;
  next.difference = differences.maxCoeff(&best);
  next.difference_now = apart(now(a), now(b), target).maxCoeff();
  const auto k = static_cast<std::size_t>(best);
  const signal::Frf& frf = plan.frfs.frfs[k];
  next.one = last_of(a);
  next.other = last_of(b);
  next.hit = frf.reference;
  next.sensor = frf.response;
  next.channel = plan.bundle.channels[frf.channel].name;
  next.moves_sensor = plan.moves_sensor[k];
  return next;
}

}  // namespace tapfit::updating
