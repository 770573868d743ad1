#include "updating/structure/solve/factor.hpp"

#include "updating/structure/solve/blas_turn.hpp"

#include <cholmod.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <vector>

namespace tapfit::structure {
namespace {

// CHOLMOD's view of an Eigen matrix; the upper triangle is read.
cholmod_sparse view(const SparseMatrix& A) {
  cholmod_sparse result{};
  result.nrow = static_cast<std::size_t>(A.rows());
  result.ncol = static_cast<std::size_t>(A.cols());
  result.nzmax = static_cast<std::size_t>(A.nonZeros());
  result.p = const_cast<int*>(A.outerIndexPtr());
  result.i = const_cast<int*>(A.innerIndexPtr());
  result.x = const_cast<double*>(A.valuePtr());
  result.stype = 1;
  result.itype = CHOLMOD_INT;
  result.xtype = CHOLMOD_REAL;
  result.dtype = CHOLMOD_DOUBLE;
  result.sorted = 1;
  result.packed = 1;
  return result;
}

// CHOLMOD's settings, status and counts, which every call writes to: threads
// must not share one (CHOLMOD User Guide, "cholmod_common").
struct Common : cholmod_common {
  Common() : cholmod_common{} {
    cholmod_start(this);
    print = 0;
  }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  ~Common() { cholmod_finish(this); }
};

[[noreturn]] void out_of_memory() { throw std::bad_alloc(); }

}  // namespace

SingularMatrix::SingularMatrix(Eigen::Index row)
    : InputError(
          "the matrix cannot be factored: part of the structure is a mechanism",
          "stiffness matrix",
          "Look for parts that are not held or not joined, elements without "
          "stiffness, and springs that are missing."),
      row_(row) {}

struct Factor::Impl {
  Common common;
  cholmod_factor* L = nullptr;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { cholmod_free_factor(&L, &common); }

  // @param order as by Perm of another factor; null: one is looked for
  void analyse(cholmod_sparse& a, int* order) {
    if (order != nullptr) {
      common.nmethods = 1;
      common.method[0].ordering = CHOLMOD_GIVEN;
    }
    L = cholmod_analyze_p(&a, order, nullptr, 0, &common);
    if (L == nullptr) out_of_memory();
  }

  void factor(const SparseMatrix& A, int* order) {
    cholmod_sparse a = view(A);
    analyse(a, order);
    const auto turn = blas_turn();
    cholmod_factorize(&a, L, &common);
    if (common.status == CHOLMOD_OK && L->minor == L->n) return;
    // Not positive definite: L D L' without pivoting, on the same ordering.
    cholmod_free_factor(&L, &common);
    common.status = CHOLMOD_OK;
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.final_ll = 0;
    analyse(a, order);
    cholmod_factorize(&a, L, &common);
    if (L->minor != L->n) {
      throw SingularMatrix(static_cast<const int*>(L->Perm)[L->minor]);
    }
    if (common.status != CHOLMOD_OK) out_of_memory();
  }

  // Pivots of L D L' in the permuted order.
  [[nodiscard]] Eigen::VectorXd pivots() const {
    const Eigen::Index n = static_cast<Eigen::Index>(L->n);
    Eigen::VectorXd d(n);
    const double* x = static_cast<const double*>(L->x);
    if (L->is_super == 0) {
      const int* p = static_cast<const int*>(L->p);
      for (Eigen::Index j = 0; j < n; ++j) d(j) = x[p[j]];
      if (L->is_ll != 0) d = d.cwiseAbs2();
      return d;
    }
    const int* super = static_cast<const int*>(L->super);
    const int* pi = static_cast<const int*>(L->pi);
    const int* px = static_cast<const int*>(L->px);
    for (std::size_t s = 0; s < L->nsuper; ++s) {
      const int rows = pi[s + 1] - pi[s];
      for (int j = super[s]; j < super[s + 1]; ++j) {
        const int k = j - super[s];
        const double l = x[px[s] + k * rows + k];
        d(j) = l * l;
      }
    }
    return d;
  }

  // A pivot that is rounding of what its diagonal started from.
  void check_pivots(const SparseMatrix& A) const {
    constexpr double relative_rounding = 1e-14;
    const Eigen::VectorXd d = pivots();
    const Eigen::VectorXd a = A.diagonal();
    const int* order = static_cast<const int*>(L->Perm);
    for (Eigen::Index j = 0; j < d.size(); ++j) {
      const double scale = std::abs(a(order[j]));
      if (!(std::abs(d(j)) > relative_rounding * scale))
        throw SingularMatrix(order[j]);
    }
  }
};

Factor::Factor(const SparseMatrix& A) : impl_(std::make_unique<Impl>()) {
  take(A, nullptr);
}

Factor::Factor(const SparseMatrix& A, const Factor& like)
    : impl_(std::make_unique<Impl>()) {
  take(A, &like);
}

void Factor::take(const SparseMatrix& A, const Factor* like) {
  if (A.rows() == 0) return;
  int* order = nullptr;
  if (like != nullptr) order = static_cast<int*>(like->impl_->L->Perm);
  if (!A.isCompressed()) {
    SparseMatrix packed = A;
    packed.makeCompressed();
    impl_->factor(packed, order);
  } else {
    impl_->factor(A, order);
  }
  impl_->check_pivots(A);
}

Factor::~Factor() = default;
Factor::Factor(Factor&&) noexcept = default;
Factor& Factor::operator=(Factor&&) noexcept = default;

Eigen::MatrixXd Factor::solve(const Eigen::MatrixXd& B) const {
  if (impl_->L == nullptr || B.size() == 0) return B;
  cholmod_dense b{};
  b.nrow = static_cast<std::size_t>(B.rows());
  b.ncol = static_cast<std::size_t>(B.cols());
  b.nzmax = static_cast<std::size_t>(B.size());
  b.d = b.nrow;
  b.x = const_cast<double*>(B.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  Common common;
  const auto turn = blas_turn();
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, impl_->L, &b, &common);
  if (x == nullptr) out_of_memory();
  const Eigen::MatrixXd result = Eigen::Map<Eigen::MatrixXd>(
      static_cast<double*>(x->x), B.rows(), B.cols());
  cholmod_free_dense(&x, &common);
  return result;
}

Eigen::VectorXd Factor::pivots() const {
  if (impl_->L == nullptr) return {};
  const Eigen::VectorXd d = impl_->pivots();
  const int* order = static_cast<const int*>(impl_->L->Perm);
  Eigen::VectorXd by_row(d.size());
  for (Eigen::Index j = 0; j < d.size(); ++j) by_row(order[j]) = d(j);
  return by_row;
}

Supernodes supernodes(const SparseMatrix& A) {
  Common common;
  common.supernodal = CHOLMOD_SUPERNODAL;
  cholmod_sparse a = view(A);
  cholmod_factor* L = cholmod_analyze(&a, &common);
  Supernodes result;
  if (L != nullptr) {
    const auto copy = [](const void* from, std::size_t size) {
      const int* begin = static_cast<const int*>(from);
      return std::vector<int>(begin, begin + size);
    };
    result.order = copy(L->Perm, L->n);
    result.first = copy(L->super, L->nsuper + 1);
    result.rows_begin = copy(L->pi, L->nsuper + 1);
    result.rows = copy(L->s, L->ssize);
  }
  cholmod_free_factor(&L, &common);
  if (result.first.empty()) out_of_memory();
  for (std::size_t s = 0; s < result.count(); ++s) {
    result.owner.insert(result.owner.end(),
                        static_cast<std::size_t>(result.columns(s)),
                        static_cast<int>(s));
  }
  return result;
}

std::string sparse_library() {
  std::array<int, 3> version{};
  cholmod_version(version.data());
  return fmt::format("{}.{}.{}", version[0], version[1], version[2]);
}

}  // namespace tapfit::structure
