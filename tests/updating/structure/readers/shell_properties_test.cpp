// Laminates of one kind of stiffness, shells whose elements have the
// thickness, and how parameters may be written.
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/elements/shell_section.hpp"

namespace tapfit::structure {
namespace {

const std::string corners =
    "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\n"
    "MAT8,1,1.4+11,1.+10,.3,5.+9,5.+9,3.+9,1600.\n";

ShellSection section_of_laminate(const std::string& head) {
  const Deck deck = deck_of(corners + "CQUAD4,5,1,1,2,3,4\nPCOMP,1," + head +
                            "\n,1,.002,0.,YES,1,.003,90.,YES\n");
  return shell_section(deck, deck.shells.front());
}

// By the Quick Reference Guide: of MEM the membrane alone, of BEND the bending
// alone, both stiff in transverse shear; of SMEAR the mean stiffness,
// 12 I / t^3 = 1, without coupling or shear, Z0 passed over.
TEST(Laminates, OfOneKindOfStiffness) {
  const ShellSection all = section_of_laminate("");
  EXPECT_GT(all.coupling.norm(), 0.0);
  const ShellSection membrane = section_of_laminate(",,,,,,MEM");
  EXPECT_EQ(membrane.membrane, all.membrane);
  EXPECT_EQ(membrane.mass, all.mass);
  EXPECT_TRUE(membrane.bending.isZero(0.0));
  EXPECT_TRUE(membrane.coupling.isZero(0.0));
  const ShellSection bent = section_of_laminate(",,,,,,BEND");
  EXPECT_EQ(bent.bending, all.bending);
  EXPECT_EQ(bent.mass, all.mass);
  EXPECT_TRUE(bent.membrane.isZero(0.0));
  EXPECT_TRUE(bent.coupling.isZero(0.0));
  EXPECT_TRUE(bent.shear_compliance.isZero(0.0));
  const ShellSection smeared = section_of_laminate("0.,,,,,,SMEAR");
  EXPECT_EQ(smeared.membrane, all.membrane);
  EXPECT_TRUE(smeared.coupling.isZero(0.0));
  EXPECT_TRUE(smeared.shear_compliance.isZero(0.0));
  EXPECT_LT((smeared.bending - all.membrane * 25e-6 / 12.0).norm(),
            1e-14 * smeared.bending.norm());
}

TEST(Laminates, OfAnUnknownKindAreRefused) {
  EXPECT_THAT(
      refusal_of([] { static_cast<void>(section_of_laminate(",,,,,,THICK")); }),
      HasSubstr("LAM = THICK is not supported"));
}

// T1 to T4 of every element in place of the property's T.
TEST(ShellProperties, MayLeaveTheThicknessToTheElements) {
  const std::string isotropic =
      corners + "MAT1,2,7.+10,,.3,2700.\nPSHELL,1,2,,2,,2\n";
  const Deck deck =
      deck_of(isotropic + "CQUAD4,5,1,1,2,3,4\n,,,.01,.01,.02,.02\n");
  EXPECT_DOUBLE_EQ(deck.shell_properties.at(1).thickness, 0.015);
  // Mass over area.
  EXPECT_DOUBLE_EQ(shell_section(deck, deck.shells.front()).mass,
                   0.015 * 2700.0);
  for (const char* thicknesses : {"", ",,,.01,.01,,.02\n"}) {
    EXPECT_THAT(refusal_of([&] {
                  static_cast<void>(deck_of(isotropic + "CQUAD4,5,1,1,2,3,4\n" +
                                            thicknesses));
                }),
                HasSubstr("neither it nor PSHELL 1 has a thickness"));
  }
}

TEST(Parameters, MayBeYesOrNo) {
  const std::string shell = corners +
                            "MAT1,2,7.+10,,.3,2700.\nPSHELL,1,2,.01,2,,2\n"
                            "CQUAD4,5,1,1,2,3,4\n";
  EXPECT_TRUE(deck_of(shell + "PARAM,COUPMASS,YES\n").coupled_mass);
  EXPECT_FALSE(deck_of(shell + "PARAM,COUPMASS,NO\n").coupled_mass);
  EXPECT_TRUE(deck_of(shell + "PARAM,COUPMASS,1\n").coupled_mass);
}

}  // namespace
}  // namespace tapfit::structure
