#include "updating/localisation/misplaced_points.hpp"

#include "updating/effects/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

// An error this many times that of the other points is no scatter (as where
// one rung cannot be all), and within this of it there is nothing to explain.
constexpr double far_off = 3.0;
constexpr double as_good = 1.5;
// Predicted with the point left out only where it stands out at all. Half of
// the FRFs, one sensor of two, can have 1.41 times the error of the whole.
constexpr double stands_out = 1.3;

// FRFs that share a hit point, or a channel's sensor point.
struct Group {
  Misplaced point;
  std::vector<std::size_t> frfs;
};

std::vector<Group> groups_of(const signal::FrfSet& measured,
                             const acquisition::TestBundle& bundle,
                             Looked looked) {
  std::map<std::string, std::size_t> of_channel;
  std::map<std::pair<std::string, Dof>, std::vector<std::size_t>> at;
  for (std::size_t f = 0; f < measured.frfs.size(); ++f) {
    const signal::Frf& frf = measured.frfs[f];
    at[{"", frf.reference}].push_back(f);
    const std::string& channel = bundle.channels.at(frf.channel).name;
    at[{channel, frf.response}].push_back(f);
    ++of_channel[channel];
  }
  std::vector<Group> groups;
  for (auto& [key, frfs] : at) {
    // What is left must still show where everything else is.
    if (2 * frfs.size() > measured.frfs.size()) continue;
    const bool stays =
        !key.first.empty() && of_channel[key.first] == frfs.size();
    if (stays && looked == Looked::Roved) continue;
    Group group;
    group.point.channel = key.first;
    group.point.written = key.second;
    group.frfs = std::move(frfs);
    groups.push_back(std::move(group));
  }
  return groups;
}

double error_of(const Target& target,
                const MatrixXcd& H,
                const std::vector<std::size_t>& frfs) {
  double sum = 0.0;
  for (const std::size_t f : frfs) {
    sum += std::pow(frf_error(target, H, static_cast<Index>(f)), 2);
  }
  return std::sqrt(sum / static_cast<double>(frfs.size()));
}

// What the channels of an FRF do to it, line by line.
VectorXcd chain_factor(const signal::Frf& frf,
                       const Fit& fit,
                       const acquisition::TestBundle& bundle,
                       const VectorXcd& s) {
  const std::string& response = bundle.channels.at(frf.channel).name;
  const std::string& hammer =
      bundle.channels.at(bundle.runs.at(frf.run).hammer.channel).name;
  VectorXcd factor = VectorXcd::Ones(s.size());
  for (const PlacedEffect& placed : fit.result.state.effects) {
    if (placed.effect->entry() != effects::Entry::Measurement) continue;
    for (const std::string& channel : placed.where.channels) {
      if (channel != response && channel != hammer) continue;
      const std::size_t group =
          placed.effect->passed_as(placed.where, channel == hammer);
      for (Index l = 0; l < s.size(); ++l) {
        factor(l) *= placed.effect->law(s(l), placed.p, group);
      }
    }
  }
  return factor;
}

// Squared misfit of a group's FRFs with its point at any grid, in any
// direction: columns +, -; rows 6 grid + component - 1.
class Elsewhere {
 public:
  Elsewhere(const Fit& fit, const Fitter& fitter, const Group& group)
      : fit_(&fit), fitter_(&fitter), group_(&group) {
    const MatrixXd rows = fit.model->base().rows.all();
    misfit_ = MatrixXd::Zero(rows.rows(), 2);
    const Target& target = fitter.target();
    const auto walks = fit.model->walk_columns(
        fit.result.state, target.s, MatrixXd(rows.cols(), 0));
    for (const FrfModel::Walk& walk : walks) {
      for (const WalkedPair& pair : walk.pairs) {
        const auto f = static_cast<std::size_t>(pair.frf);
        if (std::binary_search(group.frfs.begin(), group.frfs.end(), f)) {
          add(walk, pair, rows);
        }
      }
    }
  }

  /// Relative error with the point there.
  [[nodiscard]] double error(const Dof& dof) const {
    const structure::Deck& deck = *fitter_->setting().setting.deck;
    return error_at(
        static_cast<Index>(deck.grid_index(dof.node)), dof.component, dof.sign);
  }

  /// Where its FRFs fit best; translations only.
  [[nodiscard]] Dof best() const {
    const structure::Deck& deck = *fitter_->setting().setting.deck;
    Dof found = group_->point.written;
    double least = error(found);
    for (std::size_t k = 0; k < deck.grids.size(); ++k) {
      if (deck.grids[k].id < 0) continue;
      for (int at = 0; at < 6; ++at) {
        const Dof dof{deck.grids[k].id, 1 + at / 2, at % 2 == 0 ? 1 : -1};
        const double tried =
            error_at(static_cast<Index>(k), dof.component, dof.sign);
        if (tried >= least) continue;
        least = tried;
        found = dof;
      }
    }
    return found;
  }

 private:
  [[nodiscard]] double error_at(Index grid, int component, int sign) const {
    const double square = misfit_(6 * grid + component - 1, sign > 0 ? 0 : 1);
    const auto lines = static_cast<double>(fitter_->target().s.size());
    return std::sqrt(std::max(square, 0.0) /
                     (lines * static_cast<double>(group_->frfs.size())));
  }

  void add(const FrfModel::Walk& walk,
           const WalkedPair& pair,
           const MatrixXd& rows) {
    const Target& target = fitter_->target();
    const bool hit = group_->point.channel.empty();
    MatrixXcd X(rows.cols(), target.s.size());
    for (Index l = 0; l < X.cols(); ++l) {
      const auto line = static_cast<std::size_t>(l);
      X.col(l) = hit ? walk.Xo[line].col(pair.response)
                     : walk.Xi[line].col(pair.reference);
    }
    const VectorXcd factor = chain_factor(
        fitter_->setting().measured.frfs[static_cast<std::size_t>(pair.frf)],
        *fit_,
        *fitter_->setting().setting.bundle,
        target.s);
    const VectorXcd weight = target.weight.cast<complex<double>>();
    const VectorXcd weighted =
        factor.cwiseProduct(target.s.cwiseProduct(target.s))
            .cwiseQuotient(weight);
    const VectorXcd measured = target.H.col(pair.frf).cwiseQuotient(weight);
    const MatrixXcd there =
        rows.cast<complex<double>>() * (X * weighted.asDiagonal());
    const VectorXd power =
        there.rowwise().squaredNorm().array() + measured.squaredNorm();
    const VectorXd along = 2.0 * (there * measured.conjugate()).real();
    misfit_.col(0) += power - along;
    misfit_.col(1) += power + along;
  }

  const Fit* fit_;
  const Fitter* fitter_;
  const Group* group_;
  MatrixXd misfit_;
};

// The middle one of the FRFs' errors: a second point that is misplaced does
// not raise it.
double middle_error(const Fit& fit, const Target& target) {
  const MatrixXcd H = fit.model->respond(fit.result.state, target.s, false).H;
  std::vector<double> errors;
  for (Index f = 0; f < H.cols(); ++f) {
    errors.push_back(frf_error(target, H, f));
  }
  const auto middle =
      errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

// The same state in a base that holds every FRF, and the static answer at a
// grid.
Fit at_grid(const Fit& fit, const Fitter& fitter, int node) {
  Fit all = fit;
  std::vector<PlacedEffect> with_node = fit.effects;
  if (node != 0) {
    Where where;
    where.node = node;
    with_node.push_back({&effects::find("added-mass"), where, {1.0}});
  }
  all.model = fitter.model_for(with_node);
  return all;
}

// Fills in where the point is likely to have been; false where it is none.
bool judge_point(Group& group,
                 const Fit& fit,
                 const Fitter& fitter,
                 double floor,
                 const Progress& progress) {
  const Fitter rest = fitter.without(group.frfs);
  const Fit others =
      rest.fit(fit.effects, rest.model_for(fit.effects), progress);
  const double level = std::max(floor, middle_error(others, rest.target()));
  const Fit all = at_grid(others, fitter, 0);
  const Elsewhere anywhere(all, fitter, group);
  Misplaced& point = group.point;
  point.error = anywhere.error(point.written);
  if (point.error <= far_off * level) return false;
  const Dof best = anywhere.best();
  if (best == point.written) return false;
  const Fit closer = at_grid(others, fitter, best.node);
  const Elsewhere exactly(closer, fitter, group);
  point.likely = exactly.best();
  point.error_there = exactly.error(point.likely);
  return point.likely != point.written && point.error_there <= as_good * level;
}

}  // namespace

std::vector<MisplacedPoint> misplaced_points(const Fit& fit,
                                             const Fitter& fitter,
                                             double floor,
                                             Looked looked,
                                             const Progress& progress) {
  const Target& target = fitter.target();
  const effects::Setting& setting = fitter.setting().setting;
  const MatrixXcd H = fit.model->respond(fit.result.state, target.s, false).H;
  const double whole = std::max(floor, relative_error(target, H));
  std::vector<MisplacedPoint> found;
  for (Group& group :
       groups_of(fitter.setting().measured, *setting.bundle, looked)) {
    if (error_of(target, H, group.frfs) < stands_out * whole) continue;
    if (judge_point(group, fit, fitter, floor, progress)) {
      found.push_back({group.point, group.frfs});
    }
  }
  std::stable_sort(
      found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.point.error > b.point.error;
      });
  return found;
}

std::string describe(const Misplaced& point) {
  return fmt::format(
      "{} at {} as written down, error {:.2g} %: more likely at {}, error "
      "{:.2g} %",
      point.channel.empty() ? std::string("hits") : "sensor " + point.channel,
      name(point.written),
      100.0 * point.error,
      name(point.likely),
      100.0 * point.error_there);
}

}  // namespace tapfit::updating
