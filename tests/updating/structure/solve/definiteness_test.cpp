// Stiffness or mass below zero is refused, naming the card.
#include "updating/structure/solve/definiteness.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"

namespace tapfit::structure {
namespace {

// A plate of n by n elements on one clamped edge, as cards.
std::string plate(int n) {
  std::string text =
      "MAT1,1,7.+10,,.3,2700.\nPSHELL,1,1,0.01,1,,1\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      text += fmt::format("GRID,{},,{}.,{}.,0.{}\n",
                          1 + i * (n + 1) + j,
                          i,
                          j,
                          i == 0 ? ",,123456" : "");
    }
  }
  int element = 1;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = 1 + i * (n + 1) + j;
      text += fmt::format("CQUAD4,{},1,{},{},{},{}\n",
                          element++,
                          a,
                          a + n + 1,
                          a + n + 2,
                          a + 1);
    }
  }
  return text;
}

std::string message(const std::string& text) {
  return refusal_of([&] { static_cast<void>(modes_of(deck_of(text), 4)); });
}

// Few degrees of freedom are solved densely, many by Lanczos.
TEST(Definiteness, NegativeSpringOrMassIsNamed) {
  for (const int n : {2, 8}) {
    const std::string cards = plate(n);
    const int last = (n + 1) * (n + 1);
    const std::string spring =
        message(cards + fmt::format("CELAS2,901,-100000.,{},3\n", last));
    EXPECT_THAT(spring, HasSubstr("the stiffness is not positive"));
    EXPECT_THAT(spring, HasSubstr("CELAS2 901 (K = -100000)"));
    EXPECT_THAT(spring, HasSubstr("model.bdf:"));
    const std::string mass =
        message(cards + fmt::format("CMASS2,902,-50000.,{},3\n", last));
    EXPECT_THAT(mass, HasSubstr("the mass is not positive"));
    EXPECT_THAT(mass, HasSubstr("CMASS2 902 (M = -50000)"));
    // One that takes away less than there is stays legal.
    EXPECT_EQ(message(cards + fmt::format("CELAS2,901,-1.,{},3\n", last) +
                      fmt::format("CMASS2,902,-.001,{},3\n", last)),
              "");
  }
  EXPECT_THAT(message("GRID,1,,0.,0.,0.\nCONM2,9,1,,2.\nPBUSH,4,K,-5.\n"
                      "CBUSH,1,4,1,,,,,0\n"),
              HasSubstr("CBUSH 1 (K = -5)"));
}

TEST(Definiteness, MatricesWithoutADeckAreRefusedToo) {
  Eigen::MatrixXd K = Eigen::Vector3d(5.0, 3.0, 4.0).asDiagonal();
  const Eigen::MatrixXd M = Eigen::Matrix3d::Identity();
  EXPECT_EQ(eigenmodes(sparse(K), sparse(M), 3).frequency_hz.size(), 3);
  K(0, 1) = K(1, 0) = 4.0;  // 5 * 3 < 4 * 4
  EXPECT_TRUE(is_indefinite(sparse(K)));
  EXPECT_THROW(static_cast<void>(eigenmodes(sparse(K), sparse(M), 3)),
               InputError);
  EXPECT_THROW(static_cast<void>(eigenmodes(sparse(M), sparse(K), 3)),
               InputError);
  K(0, 1) = K(1, 0) = std::sqrt(15.0);  // singular is not negative
  EXPECT_FALSE(is_indefinite(sparse(K)));
}

}  // namespace
}  // namespace tapfit::structure
