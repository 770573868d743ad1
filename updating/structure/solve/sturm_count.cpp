#include "updating/structure/solve/sturm_count.hpp"

#include "updating/structure/solve/factor.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index panel_columns =
    32;                             // columns eliminated before a block product
constexpr double rounding = 1e-14;  // of the diagonal a pivot started from
// The matrix counted differs from A by eps times this much of its diagonal.
constexpr double growth = 1e6;

class Counter {
 public:
  explicit Counter(const SparseMatrix& A)
      : A_(A),
        parts_(supernodes(A)),
        place_(parts_.order.size()),
        local_(parts_.order.size()),
        growth_(VectorXd::Zero(A.rows())),
        diagonal_(A.rows()),
        children_(parts_.count()),
        left_(parts_.count()) {
    for (std::size_t k = 0; k < place_.size(); ++k) {
      place_[static_cast<std::size_t>(parts_.order[k])] = static_cast<int>(k);
      diagonal_(static_cast<Index>(k)) =
          std::abs(A.coeff(parts_.order[k], parts_.order[k]));
    }
  }

  std::optional<Index> count() {
    for (std::size_t s = 0; s < parts_.count(); ++s) {
      MatrixXd front = assemble_front(s);
      if (!eliminate(s, front)) return std::nullopt;
      hand_on(s, front);
    }
    const bool tame = (growth_.array() <= growth * diagonal_.array()).all();
    return tame ? std::optional<Index>(negative_) : std::nullopt;
  }

 private:
  // Rows of supernode s in elimination order, its own columns first.
  [[nodiscard]] std::pair<const int*, const int*> rows(std::size_t s) const {
    const int* all = parts_.rows.data();
    return {all + parts_.rows_begin[s], all + parts_.rows_begin[s + 1]};
  }

  // Lower triangle: the columns of A and what the children left.
  MatrixXd assemble_front(std::size_t s) {
    const auto [begin, end] = rows(s);
    for (const int* row = begin; row != end; ++row) {
      local_[static_cast<std::size_t>(*row)] = row - begin;
    }
    MatrixXd front = MatrixXd::Zero(end - begin, end - begin);
    for (int column = parts_.first[s]; column < parts_.first[s + 1]; ++column) {
      const int at = parts_.order[static_cast<std::size_t>(column)];
      for (SparseMatrix::InnerIterator it(A_, at); it; ++it) {
        const int row = place_[static_cast<std::size_t>(it.row())];
        if (row < column) continue;
        front(local_[static_cast<std::size_t>(row)],
              column - parts_.first[s]) += it.value();
      }
    }
    for (const std::size_t child : children_[s]) add_child(child, front);
    return front;
  }

  void add_child(std::size_t child, MatrixXd& front) {
    const int* row = rows(child).first + parts_.columns(child);
    MatrixXd& left = left_[child];
    std::vector<Index> at;
    for (Index i = 0; i < left.rows(); ++i) {
      at.push_back(local_[static_cast<std::size_t>(row[i])]);
    }
    for (Index j = 0; j < left.cols(); ++j) {
      double* column = front.col(at[static_cast<std::size_t>(j)]).data();
      for (Index i = j; i < left.rows(); ++i) {
        column[at[static_cast<std::size_t>(i)]] += left(i, j);
      }
    }
    left.resize(0, 0);
  }

  // L D L' of the supernode's own columns; the rest becomes what is left.
  bool eliminate(std::size_t s, MatrixXd& front) {
    const Index columns = parts_.columns(s);
    const Index rows = front.rows();
    for (Index first = 0; first < columns; first += panel_columns) {
      const Index width = std::min(panel_columns, columns - first);
      const Index below = rows - first;
      // L D before and L after the division by the pivots.
      MatrixXd LD(below, width);
      for (Index k = 0; k < width; ++k) {
        if (!take_pivot(s, first + k, width - k, front, LD.col(k)))
          return false;
      }
      const Index rest = below - width;
      if (rest == 0) continue;
      front.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>() -=
          front.block(first + width, first, rest, width) *
          LD.bottomRows(rest).transpose();
    }
    return true;
  }

  bool take_pivot(std::size_t s,
                  Index k,
                  Index panel,
                  MatrixXd& front,
                  Eigen::Ref<VectorXd> LD) {
    const Index below = front.rows() - k;
    const double d = front(k, k);
    const int* row = rows(s).first;
    if (!(std::abs(d) > rounding * diagonal_(row[k]))) return false;
    if (d < 0.0) ++negative_;
    LD.tail(below) = front.col(k).tail(below);
    front.col(k).tail(below - 1) /= d;
    front(k, k) = 1.0;
    for (Index j = 1; j < panel; ++j) {
      front.col(k + j).tail(below - j) -=
          LD(LD.size() - below + j) * front.col(k).tail(below - j);
    }
    for (Index i = 0; i < below; ++i) {
      growth_(row[k + i]) +=
          std::abs(front(k + i, k) * LD(LD.size() - below + i));
    }
    return true;
  }

  void hand_on(std::size_t s, const MatrixXd& front) {
    const Index columns = parts_.columns(s);
    const Index rest = front.rows() - columns;
    if (rest == 0) return;
    left_[s] = front.bottomRightCorner(rest, rest);
    const int parent =
        parts_.owner[static_cast<std::size_t>(rows(s).first[columns])];
    children_[static_cast<std::size_t>(parent)].push_back(s);
  }

  const SparseMatrix& A_;
  Supernodes parts_;
  std::vector<int> place_;    // of a row of A in the elimination order
  std::vector<Index> local_;  // of a place in the current front
  VectorXd growth_;           // diagonal of |L| |D| |L'|
  VectorXd diagonal_;         // of A, in elimination order
  std::vector<std::vector<std::size_t>> children_;
  std::vector<MatrixXd> left_;  // Schur complements not yet taken up
  Index negative_ = 0;
};

}  // namespace

std::optional<Index> count_negative(const SparseMatrix& A) {
  if (A.rows() == 0) return 0;
  return Counter(A).count();
}

std::optional<Index> count_below(const SparseMatrix& K,
                                 const SparseMatrix& M,
                                 double shift) {
  return count_negative(K - shift * M);
}

}  // namespace tapfit::structure
