#include "updating/localisation/location_scan.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

// Lines are summed in pieces of this many, each by one thread and in order, so
// that the result does not depend on the threads.
constexpr Index piece = 16;

// All rows under each other, and where each place begins.
struct Stacked {
  explicit Stacked(const std::vector<MatrixXd>& places, Index columns) {
    Index count = 0;
    for (const MatrixXd& place : places) {
      first.push_back(count);
      count += place.rows();
    }
    first.push_back(count);
    rows.resize(count, columns);
    for (std::size_t k = 0; k < places.size(); ++k) {
      rows.middleRows(first[k], places[k].rows()) = places[k];
    }
  }

  MatrixXd rows;
  std::vector<Index> first;
};

// What rows feel of every pair: FRFs x rows.
MatrixXcd felt_by_both(const MatrixXd& rows,
                       const MatrixXcd& Xo,
                       const MatrixXcd& Xi,
                       const std::vector<WalkedPair>& pairs) {
  const MatrixXcd felt_o = rows * Xo;
  const MatrixXcd felt_i = rows * Xi;
  MatrixXcd felt(static_cast<Index>(pairs.size()), rows.rows());
  for (std::size_t f = 0; f < pairs.size(); ++f) {
    felt.row(static_cast<Index>(f)) =
        felt_o.col(pairs[f].response)
            .cwiseProduct(felt_i.col(pairs[f].reference))
            .transpose();
  }
  return felt;
}

}  // namespace

// The model's columns, and the directions as the residual has them: of each
// line and walk FRFs x directions, conjugate, times the weight of V.
struct LocationScan::Walked {
  Walked(const Fit& current,
         const Target& target,
         const ProjectedMisfit& misfit,
         const ScannedPlaces& places)
      : size(current.model->base().size()) {
    MatrixXd candidates(size, static_cast<Index>(places.grids.size()));
    for (std::size_t b = 0; b < places.grids.size(); ++b) {
      candidates.col(static_cast<Index>(b)) = places.grids[b].transpose();
    }
    walks =
        current.model->walk_columns(current.result.state, target.s, candidates);
    const MatrixXd& all = misfit.directions();
    const Index lines = target.s.size();
    const VectorXd weight =
        stack(target, MatrixXcd::Ones(lines, target.H.cols()));
    for (const FrfModel::Walk& walk : walks) {
      const auto frfs = static_cast<Index>(walk.pairs.size());
      directions.emplace_back();
      weights.emplace_back(lines, frfs);
      for (Index l = 0; l < lines; ++l) {
        MatrixXcd at(frfs, all.cols());
        for (Index f = 0; f < frfs; ++f) {
          const Index first =
              2 * lines * walk.pairs[static_cast<std::size_t>(f)].frf + l;
          at.row(f).real() = all.row(first);
          at.row(f).imag() = -all.row(first + lines);
          weights.back()(l, f) = weight(first) * target.s(l) * target.s(l);
        }
        directions.back().push_back(std::move(at));
      }
    }
  }

  Index size;
  std::vector<FrfModel::Walk> walks;
  std::vector<std::vector<MatrixXcd>> directions;  // per walk, per line
  std::vector<MatrixXcd> weights;                  // per walk, lines x FRFs

  // V of rows on a line: FRFs x rows.
  [[nodiscard]] MatrixXcd weighted(const MatrixXd& rows,
                                   std::size_t walk,
                                   std::size_t line) const {
    const FrfModel::Walk& w = walks[walk];
    MatrixXcd V = felt_by_both(rows, w.Xo[line], w.Xi[line], w.pairs);
    V.array().colwise() *=
        weights[walk].row(static_cast<Index>(line)).transpose().array();
    return V;
  }
};

LocationScan::LocationScan(const Fit& current,
                           const Target& target,
                           const ProjectedMisfit& misfit,
                           const ScannedPlaces& places,
                           const Progress& progress)
    : misfit_(&misfit), lines_(target.s.size()) {
  progress("patterns of places", 0.0);
  const Walked walked(current, target, misfit, places);
  take_grids(walked, places);
  progress("patterns of places", 0.3);
  take_sums(walked, places);
}

void LocationScan::take_grids(const Walked& walked,
                              const ScannedPlaces& places) {
  const Stacked all(places.grids, walked.size);
  const Index directions = misfit_->directions().cols();
  grids_.assign(places.grids.size(),
                std::vector<LineSums>(walked.walks.size()));
  for (std::size_t b = 0; b < grids_.size(); ++b) {
    for (std::size_t w = 0; w < walked.walks.size(); ++w) {
      LineSums& sums = grids_[b][w];
      sums.own = walked.walks[w].own.col(static_cast<Index>(b));
      sums.power.resize(lines_);
      sums.shared.resize(directions, lines_);
    }
  }
  for_each_parallel(static_cast<std::size_t>(lines_), [&](std::size_t line) {
    const auto l = static_cast<Index>(line);
    for (std::size_t w = 0; w < walked.walks.size(); ++w) {
      const MatrixXcd V = walked.weighted(all.rows, w, line);
      const VectorXd power = V.colwise().squaredNorm().transpose();
      const MatrixXcd shared = walked.directions[w][line].transpose() * V;
      for (std::size_t b = 0; b < grids_.size(); ++b) {
        grids_[b][w].power(l) = power(static_cast<Index>(b));
        grids_[b][w].shared.col(l) = shared.col(static_cast<Index>(b));
      }
    }
  });
}

void LocationScan::take_sums(const Walked& walked,
                             const ScannedPlaces& places) {
  const Stacked all(places.parts, walked.size);
  const auto parts = static_cast<Index>(places.parts.size());
  const auto sums = static_cast<Index>(places.sums.size());
  const Index directions = misfit_->directions().cols();
  const Index pieces = (lines_ + piece - 1) / piece;
  std::vector<VectorXd> power(static_cast<std::size_t>(pieces),
                              VectorXd::Zero(sums));
  std::vector<MatrixXd> shared(static_cast<std::size_t>(pieces),
                               MatrixXd::Zero(directions, parts));
  for_each_parallel(static_cast<std::size_t>(pieces), [&](std::size_t at) {
    const Index end = std::min(lines_, piece * (static_cast<Index>(at) + 1));
    for (Index l = piece * static_cast<Index>(at); l < end; ++l) {
      const auto line = static_cast<std::size_t>(l);
      for (std::size_t w = 0; w < walked.walks.size(); ++w) {
        const MatrixXcd rows = walked.weighted(all.rows, w, line);
        MatrixXcd V(rows.rows(), parts);
        for (Index k = 0; k < parts; ++k) {
          const auto from = static_cast<std::size_t>(k);
          V.col(k) = rows.middleCols(all.first[from],
                                     all.first[from + 1] - all.first[from])
                         .rowwise()
                         .sum();
        }
        shared[at] += (walked.directions[w][line].transpose() * V).real();
        VectorXcd sum(V.rows());
        for (Index k = 0; k < sums; ++k) {
          const auto& of = places.sums[static_cast<std::size_t>(k)];
          sum = V.col(static_cast<Index>(of.front()));
          for (std::size_t e = 1; e < of.size(); ++e) {
            sum += V.col(static_cast<Index>(of[e]));
          }
          power[at](k) += sum.squaredNorm();
        }
      }
    }
  });
  power_ = VectorXd::Zero(sums);
  MatrixXd of_parts = MatrixXd::Zero(directions, parts);
  for (std::size_t at = 0; at < power.size(); ++at) {
    power_ += power[at];
    of_parts += shared[at];
  }
  shared_ = MatrixXd::Zero(directions, sums);
  for (Index k = 0; k < sums; ++k) {
    for (const std::size_t e : places.sums[static_cast<std::size_t>(k)]) {
      shared_.col(k) += of_parts.col(static_cast<Index>(e));
    }
  }
}

// H changes by -s^2 pattern w, w = z / (1 + H_bb z).
VectorXd LocationScan::errors(std::size_t grid, const MatrixXcd& z) const {
  const Index directions = misfit_->directions().cols();
  MatrixXd shared = MatrixXd::Zero(directions, z.cols());
  VectorXd power = VectorXd::Zero(z.cols());
  for (const LineSums& sums : grids_[grid]) {
    MatrixXcd w(z.rows(), z.cols());
    for (Index k = 0; k < z.cols(); ++k) {
      for (Index l = 0; l < z.rows(); ++l) {
        w(l, k) = -z(l, k) / (1.0 + sums.own(l) * z(l, k));
      }
    }
    shared += (sums.shared * w).real();
    power += w.cwiseAbs2().transpose() * sums.power;
  }
  return misfit_->errors(power, shared);
}

double LocationScan::any_law(std::size_t grid) const {
  double explained = 0.0;
  for (Index l = 0; l < lines_; ++l) {
    double power = 1e-300;
    std::complex<double> along = 0.0;
    for (const LineSums& sums : grids_[grid]) {
      power += sums.power(l);
      along += sums.shared(ProjectedMisfit::missing, l);
    }
    explained += std::norm(along) / power;
  }
  return std::sqrt(std::max(misfit_->missing_power() - explained, 0.0));
}

ProjectedMisfit::Scaled LocationScan::scaled(std::size_t sum,
                                             double sign) const {
  const auto k = static_cast<Index>(sum);
  return misfit_->scaled(power_(k), sign * shared_.col(k));
}

}  // namespace tapfit::updating
