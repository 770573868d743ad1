#include "updating/massless_dofs.hpp"

#include "tests/updating/structure/deck_support.hpp"
#include "updating/reduced_base.hpp"

#include <Eigen/LU>

#include <complex>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;

// A chain along x of springs between masses; those at grids 3 and 6 are none.
structure::Deck chain() {
  std::string text;
  for (int k = 1; k <= 8; ++k) {
    text += fmt::format("GRID,{},,{}.,0.,0.,,23456\n", k, k);
    text += fmt::format(
        "CELAS2,{},{}.+5,{},1,{},1\n", k, k + 1, k, k == 8 ? 0 : k + 1);
    if (k != 3 && k != 6) text += fmt::format("CONM2,{},{},,.5\n", 20 + k, k);
  }
  return structure::deck_of(text);
}

// Hit and measured where there is no mass: against Z^-1 of all that moves.
TEST(MasslessDofs, AreInTheBase) {
  const structure::Deck deck = chain();
  BaseOptions options;
  options.high_hz = 200.0;
  options.split = false;
  options.points = {0, 6 * 2, 6 * 5};
  const BaseBuilder builder(deck, {}, options, {});
  EXPECT_LT(builder.error(), 1e-6);
  const ReducedBase base = builder.build({}, {});
  const structure::System system = structure::assemble(deck);
  const std::vector<int> free = system.free_dofs();
  const MatrixXd K = structure::extract(system.K, free);
  const MatrixXd M = structure::extract(system.M, free);
  for (const double hz : {12.0, 77.0, 190.0}) {
    const std::complex<double> s =
        2.0 * std::numbers::pi * hz * std::complex(0.03, 1.0);
    const MatrixXcd whole =
        (K.cast<std::complex<double>>() + s * s * M).inverse();
    const MatrixXcd g =
        (base.K.diagonal().array() + s * s).inverse().matrix().asDiagonal();
    for (const int a : {0, 2, 5}) {
      for (const int b : {0, 2, 5}) {
        const std::complex<double> H =
            (base.rows.row(6 * a) * g * base.rows.row(6 * b).transpose())(0);
        // The base's own bound, of the largest receptance.
        EXPECT_LT(std::abs(H - whole(a, b)), 1e-6 * whole.norm())
            << hz << ' ' << a << ' ' << b;
      }
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
