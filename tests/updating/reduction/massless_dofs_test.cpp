#include "updating/reduction/massless_dofs.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/structure/assembly/assemble.hpp"

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

class MasslessDofs : public ::testing::Test {
 protected:
  // Largest difference of the receptances between grids 1, 3 and 6 through the
  // base from Z^-1 of all that moves, in shares of the largest receptance;
  // with a mass at grid 3 on both sides.
  double worst(const ReducedBase& base, double mass) const {
    const structure::System system = structure::assemble(deck_);
    const std::vector<int> free = system.free_dofs();
    const MatrixXd K = structure::extract(system.K, free);
    MatrixXd M = structure::extract(system.M, free);
    M(2, 2) += mass;
    double most = 0.0;
    for (const double hz : {12.0, 77.0, 190.0}) {
      const std::complex<double> s =
          2.0 * std::numbers::pi * hz * std::complex(0.03, 1.0);
      const MatrixXcd whole =
          (K.cast<std::complex<double>>() + s * s * M).inverse();
      const Eigen::VectorXd b = base.rows.row(6 * 2).transpose();
      MatrixXcd Z = s * s * mass * b * b.transpose();
      Z.diagonal().array() += base.K.diagonal().array() + s * s;
      const MatrixXcd g = Z.inverse();
      for (const int i : {0, 2, 5}) {
        for (const int j : {0, 2, 5}) {
          const std::complex<double> H =
              (base.rows.row(6 * i) * g * base.rows.row(6 * j).transpose())(0);
          most = std::max(most, std::abs(H - whole(i, j)) / whole.norm());
        }
      }
    }
    return most;
  }

  ReducedBase base_of(const std::vector<int>& measured,
                      const std::vector<int>& acted) const {
    BaseOptions options;
    options.high_hz = 200.0;
    options.split = false;
    options.points = measured;
    const BaseBuilder builder(deck_, {}, options, {});
    EXPECT_LT(builder.error(), 1e-6);
    return builder.build(acted, {});
  }

  structure::Deck deck_ = chain();
};

TEST_F(MasslessDofs, AreInTheBase) {
  // The base's own bound.
  EXPECT_LT(worst(base_of({0, 6 * 2, 6 * 5}, {}), 0.0), 1e-6);
}

// Not measured: an effect there is what brings it into the base.
TEST_F(MasslessDofs, AreInTheBaseOfAnEffectThere) {
  EXPECT_LT(worst(base_of({0, 6 * 5}, {6 * 2}), 0.3), 1e-6);
}

// What is lent is no mass of the deck's.
TEST(MasslessDeck, IsRefused) {
  const structure::Deck deck = structure::deck_of(
      "GRID,1,,0.,0.,0.,,23456\nGRID,2,,1.,0.,0.,,23456\n"
      "CELAS2,1,1.+5,1,1,2,1\nCELAS2,2,1.+5,2,1\n");
  BaseOptions options;
  options.points = {0};
  try {
    const BaseBuilder builder(deck, {}, options, {});
    FAIL() << "a deck without mass has modes";
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault(), "the model has no mass");
  }
}

}  // namespace
}  // namespace tapfit::updating
