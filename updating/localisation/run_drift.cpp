#include "updating/localisation/run_drift.hpp"

#include "acquisition/bundle/runs_alike.hpp"
#include "updating/residual/independent_data.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t fewest_runs = 4;

bool sensors_stay(const acquisition::TestBundle& bundle) {
  const auto same = [](const acquisition::Placement& a,
                       const acquisition::Placement& b) {
    return a.channel == b.channel && a.dof == b.dof;
  };
  return std::ranges::all_of(bundle.runs, [&](const acquisition::Run& run) {
    return std::ranges::equal(run.sensors, bundle.runs.front().sensors, same);
  });
}

/// d residual / d ln of all moduli together; empty where none is fitted.
VectorXd slope_by_moduli(const Fit& fit, const Target& target) {
  const auto& uncertain = fit.model->context().bundle->uncertain;
  const ModelResponse response =
      fit.model->respond(fit.result.state, target.s, true);
  VectorXd slope;
  for (std::size_t k = 0;
       k < std::min(uncertain.size(), fit.result.state.factor.size());
       ++k) {
    if (uncertain[k].property != "E") continue;
    const VectorXd column = stack(target, response.dH[k]);
    slope = slope.size() == 0 ? column : VectorXd(slope + column);
  }
  return slope;
}

/// Where each FRF's runs stand in the mean between the first, -1/2, and the
/// last, 1/2.
std::vector<double> times(const std::vector<std::size_t>& run,
                          const acquisition::TestBundle& bundle) {
  const auto last = static_cast<double>(bundle.runs.size() - 1);
  const std::vector<acquisition::RunGroup> groups =
      acquisition::runs_alike(bundle);
  std::vector<double> result;
  for (const std::size_t r : run) {
    const acquisition::RunGroup& group =
        groups[acquisition::group_of(groups, r)];
    double sum = 0.0;
    for (const std::size_t one : group) sum += static_cast<double>(one);
    result.push_back(sum / static_cast<double>(group.size()) / last - 0.5);
  }
  return result;
}

}  // namespace

std::optional<RunDrift> run_drift(const Fit& fit, const Target& target) {
  const acquisition::TestBundle& bundle = *fit.model->context().bundle;
  if (bundle.runs.size() < fewest_runs || !sensors_stay(bundle)) return {};
  const VectorXd slope = slope_by_moduli(fit, target);
  const VectorXd& r = fit.result.residual;
  const Index block = 2 * target.s.size();
  const auto frfs = static_cast<Index>(target.run.size());
  if (slope.size() == 0 || r.size() != block * frfs) return {};
  const std::vector<double> time = times(target.run, bundle);
  Eigen::MatrixXd A(r.size(), 2);
  A.col(0) = slope;
  for (Index f = 0; f < frfs; ++f) {
    A.col(1).segment(f * block, block) =
        time[static_cast<std::size_t>(f)] * slope.segment(f * block, block);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  if (qr.rank() < 2) return {};
  const VectorXd x = qr.solve(r);
  const double rest = (r - A * x).squaredNorm();
  const Eigen::Matrix2d inverse = (A.transpose() * A).inverse();
  RunDrift drift;
  // A measurement that is stiffer than the model leaves the residual's minus.
  drift.change = -x(1);
  drift.sd = std::sqrt(rest / effective_data(target) * inverse(1, 1));
  drift.explained = 1.0 - rest / std::max(r.squaredNorm(), 1e-300);
  return drift;
}

bool is_significant(const RunDrift& drift) {
  return drift.explained >= 0.5 && std::abs(drift.change) > 5.0 * drift.sd;
}

std::string statement(const RunDrift& drift) {
  return fmt::format(
      "the stiffness {} by about {:.2g} % from the first run to the last, "
      "which "
      "is {:.0f} % of what is left: look for warmth or a clamp that works "
      "loose, and hit the first point again at the end",
      drift.change < 0.0 ? "falls" : "rises",
      100.0 * std::abs(std::expm1(drift.change)),
      100.0 * drift.explained);
}

}  // namespace tapfit::updating
