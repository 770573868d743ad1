#include "updating/frf_model/frf_model.hpp"

#include <vector>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// A mass m on a spring k = m w^2 at b' q, moving by y of its own:
//
//   K += k [ b b'  -b ]    M += m [ 0  0 ]    over  [ q ]
//          [ -b'    1 ]           [ 0  1 ]          [ y ]
void append_resonator(const effects::Resonator& resonator,
                      double weight,
                      const VectorXd& b,
                      ModalMatrices& with) {
  const Index n = with.K.rows();
  const double m = weight * resonator.mass;
  const double k = m * resonator.omega * resonator.omega;
  VectorXd stretch = VectorXd::Zero(n + 1);
  stretch.head(b.size()) = b;
  stretch(n) = -1.0;
  with.K.conservativeResizeLike(MatrixXd::Zero(n + 1, n + 1));
  with.M.conservativeResizeLike(MatrixXd::Zero(n + 1, n + 1));
  with.K += k * stretch * stretch.transpose();
  with.M(n, n) = m;
}

// Every other law is k + s c + s^2 m.
void add_spring_and_mass(const EffectInstance& placed,
                         const effects::InterfaceDof& dof,
                         double share,
                         const VectorXd& b,
                         ModalMatrices& with) {
  const auto real_law = [&placed, &dof](std::complex<double> s) {
    return placed.effect->law(s, placed.p, dof.group).real();
  };
  const double k = real_law(0.0);
  const double m = k - real_law({0.0, 1.0});
  const MatrixXd bb = share * b * b.transpose();
  with.K.topLeftCorner(b.size(), b.size()) += k * bb;
  with.M.topLeftCorner(b.size(), b.size()) += m * bb;
}

}  // namespace

BaseModes FrfModel::full_modes(const ModelState& state) const {
  const BaseModes base = base_modes(state);
  const TestAsDone done = test_as_done(context_, state.effects);
  ModalMatrices with = with_changes(
      base, modal_modifications(state, done.context, runs_, base_), state);
  for (const EffectInstance& placed :
       outside_modal_basis(state, done.context, runs_)) {
    if (placed.effect->entry() != effects::Entry::LowRank) continue;
    const auto resonator = placed.effect->resonator(placed.p);
    for (const std::size_t run : runs_) {
      for (const effects::InterfaceDof& dof :
           placed.effect->interface_dofs(placed.where, done.context, run)) {
        const VectorXd b = base.phi.transpose() * row(dof).transpose();
        const double share = dof.weight / static_cast<double>(runs_.size());
        if (!resonator) {
          add_spring_and_mass(placed, dof, share, b, with);
        } else if (run == runs_.front()) {
          append_resonator(*resonator, dof.weight, b, with);
        }
      }
    }
  }
  BaseModes full = solve_modes(with.K, with.M);
  const Index r = base.phi.rows();
  full.own = full.phi.bottomRows(full.phi.rows() - r);
  full.phi = (base.phi * full.phi.topRows(r)).eval();
  return full;
}

}  // namespace tapfit::updating
