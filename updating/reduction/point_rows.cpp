#include "updating/reduction/point_rows.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

// All rows of them, or those of some degrees of freedom and how the others are
// made again.
class PointRows::OwnColumns {
 public:
  explicit OwnColumns(MatrixXf all) : rows_(std::move(all)) {}
  OwnColumns(const MatrixXf& all,
             std::vector<int> kept,
             std::function<MatrixXd()> again)
      : rows_(all(kept, Eigen::all)),
        kept_(std::move(kept)),
        again_(std::move(again)) {}

  [[nodiscard]] Index cols() const { return rows_.cols(); }
  [[nodiscard]] Index numbers() const { return rows_.size(); }

  [[nodiscard]] Eigen::RowVectorXf row(Index dof) const {
    if (!again_) return rows_.row(dof);
    const auto at = std::ranges::lower_bound(kept_, dof);
    if (at == kept_.end() || *at != dof) return all().row(dof);
    return rows_.row(at - kept_.begin());
  }

  [[nodiscard]] const MatrixXf& all() const {
    if (!again_) return rows_;
    std::call_once(made_, [this] { all_ = again_().cast<float>(); });
    return all_;
  }

 private:
  MatrixXf rows_;
  std::vector<int> kept_;  // ascending
  std::function<MatrixXd()> again_;
  mutable std::once_flag made_;
  mutable MatrixXf all_;
};

PointRows::PointRows(MatrixXd columns)
    : shared_(std::make_shared<MatrixXd>(std::move(columns))),
      Q_(MatrixXd::Identity(shared_->cols(), shared_->cols())) {}

PointRows PointRows::with(const MatrixXd& columns) const {
  PointRows wider = *this;
  const Index n = columns.cols();
  wider.own_ = std::make_shared<OwnColumns>(columns.cast<float>());
  wider.Q_ = MatrixXd::Zero(Q_.rows() + n, Q_.cols() + n);
  wider.Q_.topLeftCorner(Q_.rows(), Q_.cols()) = Q_;
  wider.Q_.bottomRightCorner(n, n).setIdentity();
  return wider;
}

void PointRows::keep_only(std::vector<int> dofs,
                          std::function<MatrixXd()> again) {
  if (!own_) return;
  own_ = std::make_shared<OwnColumns>(
      own_->all(), std::move(dofs), std::move(again));
}

Index PointRows::own_numbers() const { return own_ ? own_->numbers() : 0; }

void PointRows::turn(const MatrixXd& Q) { Q_ = (Q_ * Q).eval(); }

void PointRows::set_at_rest(const std::vector<int>& dofs) {
  for (const Index dof : dofs) {
    if (dof < rows()) at_rest_.push_back(dof);
  }
  std::ranges::sort(at_rest_);
}

Index PointRows::rows() const { return shared_ ? shared_->rows() : 0; }

Eigen::RowVectorXd PointRows::row(Index dof) const {
  if (std::ranges::binary_search(at_rest_, dof)) {
    return Eigen::RowVectorXd::Zero(cols());
  }
  if (!own_) return shared_->row(dof) * Q_;
  return shared_->row(dof) * Q_.topRows(shared_->cols()) +
         own_->row(dof).cast<double>() * Q_.bottomRows(own_->cols());
}

MatrixXd PointRows::rows_of_grid(std::size_t grid) const {
  const Index first = 6 * static_cast<Index>(grid);
  MatrixXd rows = shared_->middleRows(first, 6) * Q_.topRows(shared_->cols());
  if (own_) {
    rows += own_->all().middleRows(first, 6).cast<double>() *
            Q_.bottomRows(own_->cols());
  }
  for (const Index dof : at_rest_) {
    if (dof >= first && dof < first + 6) rows.row(dof - first).setZero();
  }
  return rows;
}

MatrixXd PointRows::all() const {
  return *this * MatrixXd::Identity(cols(), cols());
}

MatrixXd PointRows::operator*(const MatrixXd& X) const {
  const MatrixXd QX = Q_ * X;
  MatrixXd result = *shared_ * QX.topRows(shared_->cols());
  // Few rows at a time in double precision.
  constexpr Index block = 512;
  for (Index first = 0; own_ && first < rows(); first += block) {
    const Index count = std::min(block, rows() - first);
    result.middleRows(first, count) +=
        own_->all().middleRows(first, count).cast<double>() *
        QX.bottomRows(own_->cols());
  }
  for (const Index dof : at_rest_) result.row(dof).setZero();
  return result;
}

}  // namespace tapfit::updating
