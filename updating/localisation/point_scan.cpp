#include "updating/localisation/point_scan.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

bool in_runs(const Location& where, std::size_t run) {
  return where.runs.empty() ||
         std::ranges::find(where.runs, static_cast<int>(run) + 1) !=
             where.runs.end();
}

bool on_channel(const Location& where,
                std::size_t channel,
                const acquisition::TestBundle& sheet) {
  return std::ranges::find(where.channels, sheet.channels.at(channel).name) !=
         where.channels.end();
}

// Of one point, the best first.
std::vector<PointElsewhere> best_grids(const Location& point,
                                       const VectorXd& errors,
                                       const structure::Deck& deck,
                                       std::size_t count) {
  std::vector<Index> order(static_cast<std::size_t>(errors.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(
      order, [&](Index a, Index b) { return errors(a) < errors(b); });
  std::vector<PointElsewhere> result;
  for (const Index g : order) {
    if (result.size() == count || !std::isfinite(errors(g))) break;
    const int node = deck.grids[static_cast<std::size_t>(g)].id;
    // A point of the test's own has coordinates, not a number to mistake.
    if (node < 0 || node == point.nodes.front()) continue;
    result.push_back({point, errors(g)});
    result.back().where.node = node;
  }
  return result;
}

// Of all grids those along one component: grids x r.
std::array<MatrixXd, 6> by_component(const MatrixXd& all) {
  std::array<MatrixXd, 6> rows;
  for (Index c = 0; c < 6; ++c) {
    rows[static_cast<std::size_t>(c)] =
        all(Eigen::seqN(c, all.rows() / 6, 6), Eigen::all);
  }
  return rows;
}

}  // namespace

PointScan::PointScan(const Fit& current,
                     const Target& target,
                     const ProjectedMisfit& misfit,
                     const signal::FrfSet& measured)
    : model_(current.model.get()),
      state_(&current.result.state),
      target_(&target),
      misfit_(&misfit),
      measured_(&measured),
      rows_(by_component(current.model->base().rows.all())),
      ends_(current.model->ends(current.result.state)),
      walks_(current.model->walk_columns(
          current.result.state, target.s, MatrixXd(rows_[0].cols(), 0))),
      now_(current.model->respond(current.result.state, target.s, false).H),
      share_(VectorXd::Zero(target.H.cols())) {
  for (Index f = 0; f < share_.size(); ++f) {
    share_(f) = directions(static_cast<std::size_t>(f))
                    .col(ProjectedMisfit::misfit)
                    .squaredNorm();
  }
  share_ /= std::max(share_.sum(), 1e-300);
}

// The FRFs that a point has part in, by the end that it is.
std::vector<PointScan::MovedEnd> PointScan::ends_of(
    const Location& point) const {
  const acquisition::TestBundle& sheet = *model_->context().bundle;
  std::vector<MovedEnd> result;
  for (std::size_t f = 0; f < measured_->frfs.size(); ++f) {
    const signal::Frf& frf = measured_->frfs[f];
    if (!in_runs(point, frf.run)) continue;
    const std::size_t hammer = sheet.runs.at(frf.run).hammer.channel;
    const int grid = point.nodes.front();
    if (on_channel(point, hammer, sheet)) {
      if (frf.reference.node == grid) result.push_back({f, true});
    } else if (on_channel(point, frf.channel, sheet)) {
      if (frf.response.node == grid) result.push_back({f, false});
    }
  }
  return result;
}

double PointScan::share(const std::vector<MovedEnd>& ends) const {
  double sum = 0.0;
  for (const MovedEnd& end : ends) sum += share_(static_cast<Index>(end.frf));
  return sum;
}

double PointScan::share(const Location& where) const {
  double sum = 0.0;
  for (std::size_t f = 0; f < measured_->frfs.size(); ++f) {
    if (passes(where, f)) sum += share_(static_cast<Index>(f));
  }
  return sum;
}

// Whether one of the place's channels has part in an FRF.
bool PointScan::passes(const Location& where, std::size_t frf) const {
  const acquisition::TestBundle& sheet = *model_->context().bundle;
  const signal::Frf& own = measured_->frfs[frf];
  const std::size_t hammer = sheet.runs.at(own.run).hammer.channel;
  return in_runs(where, own.run) && (on_channel(where, own.channel, sheet) ||
                                     on_channel(where, hammer, sheet));
}

void PointScan::prepare(const std::vector<MovedEnd>& ends) {
  std::vector<MovedEnd> fresh;
  for (const MovedEnd& end : ends) {
    if (changes_.try_emplace(end).second) fresh.push_back(end);
  }
  for_each_parallel(fresh.size(), [&](std::size_t k) {
    changes_.at(fresh[k]) = change_of(fresh[k]);
  });
}

// Error left with the point at each grid; infinite where nothing moves.
VectorXd PointScan::errors(const std::vector<MovedEnd>& ends) const {
  ChangeAtGrids sum = changes_.at(ends.front());
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const ChangeAtGrids& more = changes_.at(ends[k]);
    sum.power += more.power;
    sum.shared += more.shared;
  }
  VectorXd result = misfit_->errors(sum.power, sum.shared);
  for (const MovedEnd& end : ends) {
    const auto moves =
        (rows_of(end_now(end)).array() != 0.0).rowwise().any().eval();
    for (Index g = 0; g < result.size(); ++g) {
      if (!moves(g)) result(g) = std::numeric_limits<double>::infinity();
    }
  }
  return result;
}

// An FRF's rows of what the misfit is compared with.
MatrixXd PointScan::directions(std::size_t frf) const {
  const Index each = 2 * target_->s.size();
  return misfit_->directions().middleRows(each * static_cast<Index>(frf), each);
}

const Dof& PointScan::end_now(const MovedEnd& end) const {
  const PairEnds& ends = ends_[end.frf];
  return end.hammer ? ends.reference : ends.response;
}

// grids x r: what each moves along a degree of freedom, but for its sign.
const MatrixXd& PointScan::rows_of(const Dof& dof) const {
  return rows_[static_cast<std::size_t>(dof.component - 1)];
}

// The FRF's column at its other end, as it is recorded, a line per column.
MatrixXcd PointScan::column_of(const MovedEnd& end) const {
  const VectorXcd& s = target_->s;
  MatrixXcd X;
  for (const FrfModel::Walk& walk : walks_) {
    const auto own = std::ranges::find(
        walk.pairs, static_cast<Index>(end.frf), &WalkedPair::frf);
    if (own == walk.pairs.end()) continue;
    const Index at = own - walk.pairs.begin();
    X.resize(rows_[0].cols(), s.size());
    for (Index l = 0; l < s.size(); ++l) {
      const auto line = static_cast<std::size_t>(l);
      X.col(l) = s(l) * s(l) * walk.recorded(l, at) *
                 (end.hammer ? walk.Xo[line].col(own->response)
                             : walk.Xi[line].col(own->reference));
    }
  }
  return X;
}

// What the FRF's lines weigh in the misfit, real parts and then imaginary ones.
VectorXd PointScan::weighed(std::size_t frf, const VectorXcd& lines) const {
  const double scale =
      target_->use[frf] / std::sqrt(std::max(target_->count(), 1.0));
  const VectorXcd each = scale * (lines.array() / target_->weight.array());
  VectorXd both(2 * each.size());
  both << each.real(), each.imag();
  return both;
}

// With the grid's row v, B = [Re X, Im X] and h what there is now, weighed, the
// change is B'v - h, and for all grids at once
//
//   |B'v - h|^2 = v'(B B')v - 2 v'(B h) + h'h,   D'(B'v - h) = (B D)'v - D'h.
PointScan::ChangeAtGrids PointScan::change_of(const MovedEnd& end) const {
  const Dof& dof = end_now(end);
  const MatrixXd& v = rows_of(dof);
  const MatrixXcd X = dof.sign * column_of(end);
  MatrixXd B(2 * X.cols(), X.rows());  // transposed
  for (Index k = 0; k < X.rows(); ++k) {
    B.col(k) = weighed(end.frf, X.row(k).transpose());
  }
  const VectorXd h = weighed(end.frf, now_.col(static_cast<Index>(end.frf)));
  const MatrixXd D = directions(end.frf);
  const MatrixXd gram = B.transpose() * B;
  const VectorXd mixed = B.transpose() * h;
  const MatrixXd seen_of = B.transpose() * D;
  ChangeAtGrids change;
  change.power = (v * gram).cwiseProduct(v).rowwise().sum() - 2.0 * (v * mixed);
  change.power.array() += h.squaredNorm();
  change.power = change.power.cwiseMax(0.0);
  change.shared = (v * seen_of).transpose();
  change.shared.colwise() -= D.transpose() * h;
  return change;
}

// What the misfit sees of another FRF in this one's place.
PointScan::ChangeAtGrids PointScan::seen(std::size_t frf,
                                         const VectorXcd& there) const {
  const VectorXd change =
      weighed(frf, there - now_.col(static_cast<Index>(frf)));
  return {VectorXd::Constant(1, change.squaredNorm()),
          directions(frf).transpose() * change};
}

std::vector<PointElsewhere> PointScan::elsewhere(
    const std::vector<Location>& points, const PointScanOptions& options) {
  std::vector<PointElsewhere> result;
  for (const Location& point : points) {
    const std::vector<MovedEnd> ends = ends_of(point);
    if (ends.empty() || share(ends) < options.least_share) continue;
    prepare(ends);
    for (PointElsewhere& there : best_grids(
             point, errors(ends), *model_->context().deck, options.grids)) {
      result.push_back(std::move(there));
    }
  }
  return result;
}

// An FRF without the mistake, line by line; empty where it is none of its own.
VectorXcd PointScan::put_right(std::size_t frf,
                               const PairEnds& real,
                               const EffectInstance& mistake) const {
  const PairEnds& now = ends_[frf];
  const bool recorded = passes(mistake.where, frf);
  if (!recorded && real == now) return {};
  VectorXcd H = now_.col(static_cast<Index>(frf));
  if (real != now) {
    const bool hit = real.reference != now.reference;
    const Dof& dof = hit ? real.reference : real.response;
    H = (dof.sign * model_->row(dof.node, dof.component) *
         column_of({frf, hit}))
            .transpose();
  }
  if (!recorded) return H;
  const bool response = on_channel(
      mistake.where, measured_->frfs[frf].channel, *model_->context().bundle);
  const std::size_t group = mistake.effect->passed_as(mistake.where, !response);
  for (Index l = 0; l < H.size(); ++l) {
    H(l) *= mistake.effect->law(target_->s(l), mistake.p, group);
  }
  return H;
}

double PointScan::error_without(const EffectInstance& mistake) const {
  ModelState state;
  state.effects = state_->effects;
  state.effects.push_back(mistake);
  const std::vector<PairEnds> real = model_->ends(state);
  VectorXd power = VectorXd::Zero(1);
  MatrixXd shared = MatrixXd::Zero(misfit_->directions().cols(), 1);
  for (std::size_t f = 0; f < real.size(); ++f) {
    const VectorXcd H = put_right(f, real[f], mistake);
    if (H.size() == 0) continue;
    const ChangeAtGrids change = seen(f, H);
    power += change.power;
    shared += change.shared;
  }
  return misfit_->errors(power, shared)(0);
}

}  // namespace tapfit::updating
