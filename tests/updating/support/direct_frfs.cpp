#include "tests/updating/support/direct_frfs.hpp"

#include "tests/updating/support/plate_model.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using std::complex;

namespace {

// The matrices, and where each degree of freedom that moves is among these.
struct MovingModel {
  const structure::Deck& deck;
  structure::System system = structure::assemble(deck);
  std::vector<int> position =
      std::vector<int>(static_cast<std::size_t>(system.dofs()), -1);
  Index n = 0;

  [[nodiscard]] int at(int node, int component) const {
    return position[6 * deck.grid_index(node) +
                    static_cast<std::size_t>(component - 1)];
  }
};

MovingModel moving_model(const structure::Deck& deck,
                         const std::vector<int>& also_free) {
  MovingModel model{deck};
  std::vector<int> free = model.system.free_dofs();
  free.insert(free.end(), also_free.begin(), also_free.end());
  for (std::size_t k = 0; k < free.size(); ++k) {
    model.position[static_cast<std::size_t>(free[k])] = static_cast<int>(k);
  }
  model.n = static_cast<Index>(free.size());
  return model;
}

using Entries = std::vector<Eigen::Triplet<complex<double>>>;

void put(const MovingModel& model,
         const structure::SparseMatrix& A,
         complex<double> factor,
         Entries& entries) {
  for (Index c = 0; c < A.outerSize(); ++c) {
    for (structure::SparseMatrix::InnerIterator it(A, c); it; ++it) {
      const int a = model.position[static_cast<std::size_t>(it.row())];
      const int b = model.position[static_cast<std::size_t>(it.col())];
      if (a >= 0 && b >= 0) entries.emplace_back(a, b, factor * it.value());
    }
  }
}

}  // namespace

MatrixXcd direct_frfs(const structure::Deck& deck,
                      const signal::FrfSet& pairs,
                      const std::vector<PointTerm>& terms,
                      const VectorXcd& s,
                      const std::vector<int>& also_free,
                      double k_free) {
  const MovingModel model = moving_model(deck, also_free);
  MatrixXcd H(s.size(), static_cast<Index>(pairs.frfs.size()));
  for (Index l = 0; l < s.size(); ++l) {
    Entries entries;
    put(model, model.system.K, 1.0, entries);
    put(model, model.system.M, s(l) * s(l), entries);
    for (const auto& [node, power, size] : terms) {
      const int dofs = power == 2 ? 3 : 1;  // a mass moves in all directions
      for (int d = 0; d < dofs; ++d) {
        const int at = model.at(node, 3 - d);
        entries.emplace_back(at, at, size * std::pow(s(l), power));
      }
    }
    for (const int dof : also_free) {
      const int at = model.position[static_cast<std::size_t>(dof)];
      // End grids carry half a gap of 30 mm.
      const int row = dof / 66;
      const double length = row == 0 || row == 4 ? 0.015 : 0.03;
      entries.emplace_back(at, at, k_free * length);
    }
    Eigen::SparseMatrix<complex<double>> Z(model.n, model.n);
    Z.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<complex<double>>> lu(Z);
    for (std::size_t f = 0; f < pairs.frfs.size(); ++f) {
      const signal::Frf& frf = pairs.frfs[f];
      VectorXcd force = VectorXcd::Zero(model.n);
      force(model.at(frf.reference.node, 3)) = frf.reference.sign;
      const VectorXcd x = lu.solve(force);
      H(l, static_cast<Index>(f)) = s(l) * s(l) *
                                    static_cast<double>(frf.response.sign) *
                                    x(model.at(frf.response.node, 3));
    }
  }
  return H;
}

ModelState undamped_state(const Fitter& fitter,
                          const FrfModel& model,
                          const std::vector<EffectInstance>& effects) {
  ModelState state = fitter.first_state(model, effects);
  state.zeta.setConstant(1e-12);
  state.zeta_other = 1e-12;
  return state;
}

double derivative_error(const FrfModel& model,
                        const ModelState& state,
                        const VectorXcd& s) {
  const Eigen::VectorXd theta = pack(state);
  const ModelResponse response = model.respond(state, s, true);
  double worst = 0.0;
  for (Index k = 0; k < theta.size(); ++k) {
    // Of fourth order: what truncation leaves is far below rounding, which is
    // that of small differences where a parameter moves little.
    constexpr double h = 1e-3;
    const auto across = [&](double step) {
      Eigen::VectorXd up = theta;
      Eigen::VectorXd down = theta;
      up(k) += step;
      down(k) -= step;
      return MatrixXcd(model.respond(unpack(state, up), s, false).H -
                       model.respond(unpack(state, down), s, false).H);
    };
    const MatrixXcd numeric = (8.0 * across(h) - across(2.0 * h)) / (12.0 * h);
    worst = std::max(
        worst, difference(response.dH[static_cast<std::size_t>(k)], numeric));
  }
  return worst;
}

}  // namespace tapfit::updating
