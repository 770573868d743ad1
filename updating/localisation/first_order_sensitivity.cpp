#include "updating/localisation/first_order_sensitivity.hpp"

#include "acquisition/foundation/parallel.hpp"

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

// All rows under each other, and where each place begins.
struct StackedRows {
  MatrixXd rows;
  std::vector<Index> first;
};

StackedRows stacked(const std::vector<MatrixXd>& places, Index columns) {
  StackedRows result;
  Index count = 0;
  for (const MatrixXd& rows : places) {
    result.first.push_back(count);
    count += rows.rows();
  }
  result.rows.resize(count, columns);
  for (std::size_t k = 0; k < places.size(); ++k) {
    result.rows.middleRows(result.first[k], places[k].rows()) = places[k];
  }
  return result;
}

MatrixXd single_rows(const std::vector<MatrixXd>& places, Index columns) {
  MatrixXd candidates =
      MatrixXd::Zero(columns, static_cast<Index>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k].rows() != 1) continue;
    candidates.col(static_cast<Index>(k)) = places[k].transpose();
  }
  return candidates;
}

// Sum over a place's rows of what response and reference feel there.
std::complex<double> pair_patterns(const MatrixXcd& felt_o,
                                   const MatrixXcd& felt_i,
                                   const WalkedPair& pair,
                                   Index first,
                                   Index count) {
  return felt_o.col(pair.response)
      .segment(first, count)
      .cwiseProduct(felt_i.col(pair.reference).segment(first, count))
      .sum();
}

}  // namespace

FirstOrderSensitivity first_order_sensitivity(const Fit& current,
                                              const Target& target,
                                              const std::vector<MatrixXd>& rows,
                                              const Progress& progress) {
  const FrfModel& model = *current.model;
  const Index lines = target.s.size();
  const Index frfs = target.H.cols();
  const Index size = model.base().size();
  FirstOrderSensitivity result;
  result.s = target.s;
  result.pattern.resize(rows.size());
  result.own.resize(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    result.pattern[k].resize(lines, frfs);
    if (rows[k].rows() == 1) result.own[k].resize(lines, frfs);
  }
  progress("patterns of places", 0.0);
  const StackedRows all = stacked(rows, size);
  const std::vector<FrfModel::Walk> walks = model.walk_columns(
      current.result.state, target.s, single_rows(rows, size));
  for_each_parallel(static_cast<std::size_t>(lines), [&](std::size_t at) {
    const auto line = static_cast<Index>(at);
    for (const FrfModel::Walk& walk : walks) {
      const MatrixXcd felt_o = all.rows * walk.Xo[at];
      const MatrixXcd felt_i = all.rows * walk.Xi[at];
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const Index first = all.first[k];
        const Index count = rows[k].rows();
        for (const WalkedPair& pair : walk.pairs) {
          result.pattern[k](line, pair.frf) =
              pair_patterns(felt_o, felt_i, pair, first, count);
          if (count != 1) continue;
          result.own[k](line, pair.frf) = walk.own(line, static_cast<Index>(k));
        }
      }
    }
  });
  return result;
}

}  // namespace tapfit::updating
