// A number that no structure has, in every field of every card in turn: a deck
// with one is refused, or has modes that are numbers.
#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace tapfit::structure {
namespace {

struct NamedDeck {
  const char* name;
  const char* text;
};

const NamedDeck decks[] = {
    {"Shells", R"(MAT1,1,7.+10,,.33,2700.
PSHELL,1,1,.003,1,1.,1,.8333,.1
GRID,1,,0,0,0.
GRID,2,,0.1,0,0.
GRID,3,,0.2,0,0.
GRID,4,,0.3,0,0.
GRID,5,,0,0.1,0.
GRID,6,,0.1,0.1,0.
GRID,7,,0.2,0.1,0.
GRID,8,,0.3,0.1,0.
GRID,9,,0,0.2,0.
GRID,10,,0.1,0.2,0.
GRID,11,,0.2,0.2,0.
GRID,12,,0.3,0.2,0.
CQUAD4,1,1,1,2,6,5
CQUAD4,2,1,2,3,7,6
CQUAD4,3,1,3,4,8,7
CQUAD4,4,1,5,6,10,9
CQUAD4,5,1,6,7,11,10
CQUAD4,6,1,7,8,12,11
SPC1,1,123456,1,5,9
CONM2,90,4,,.02,.0,.0,.001,
,1-5,0.,1-5,0.,0.,1-5
)"},
    {"Bars", R"(MAT1,1,7.+10,,.33,2700.
PBAR,1,1,1-4,2-9,3-9,4-9,.01,
,0.,0.,0.,0.,0.,0.,0.,0.
,.83,.83,0.
PBARL,2,1,,TUBE,,,,
,.01,.008,.1
PBEAM,3,1,1-4,2-9,3-9,0.,4-9,.01
,0.,0.,0.,0.,0.,0.,0.,0.
,YES,1.,1-4,2-9,3-9,0.,4-9,.01
PBEAML,4,1,,BAR,,,,
,.01,.02,.1
GRID,1,,0.1,0.,0.
GRID,2,,0.2,0.,0.
GRID,3,,0.3,0.,0.
GRID,4,,0.4,0.,0.
GRID,5,,0.5,0.,0.
GRID,6,,0.6,0.,0.
GRID,7,,0.7,0.,0.
GRID,8,,0.8,0.,0.
GRID,9,,0.9,0.,0.
CBAR,1,2,1,2,0.,0.,1.
CBAR,2,1,2,3,0.,0.,1.
CBAR,3,2,3,4,0.,0.,1.
CBAR,4,1,4,5,0.,0.,1.,
,,,.0,.0,.001,.0,.0,.001
CBEAM,5,3,5,6,0.,0.,1.
CBEAM,6,4,6,7,0.,0.,1.,
,,,.0,.0,.001,.0,.0,.001
CBAR,7,1,7,8,0.,0.,1.,
,5,4
CBAR,8,1,8,9,0.,0.,1.
SPC1,1,123456,1
)"},
    {"Rods", R"(MAT1,1,7.+10,,.33,2700.
PROD,1,1,1-4,1-9,.01,.1
PTUBE,2,1,.02,.002,.1,.03
GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,0.,1.,0.
GRID,4,,1.,1.,.5
CROD,1,1,1,4
CTUBE,2,2,2,4
CONROD,3,3,4,1,1-4,1-9,.01,.1
SPC1,1,123456,1,2,3
)"},
    {"Points", R"(MAT1,1,7.+10,,.33,2700.
PBAR,1,1,1-4,2-9,3-9,4-9
GRID,1,,0.1,0.,0.
GRID,2,,0.2,0.,0.
GRID,3,,0.3,0.,0.
GRID,4,,0.4,0.,0.
GRID,5,,0.5,0.,0.
GRID,6,,0.6,0.,0.
CBAR,1,1,1,2,0.,0.,1.
CBAR,2,1,2,3,0.,0.,1.
CBAR,3,1,3,4,0.,0.,1.
CBAR,4,1,4,5,0.,0.,1.
CBAR,5,1,5,6,0.,0.,1.
SPOINT,50,51
PELAS,10,1000.,.01,1.
CELAS1,11,10,3,3
CELAS2,12,500.,4,3,5,3,.01,1.
CELAS3,13,10,50,51
CELAS4,14,100.,50,0
PMASS,20,.01
CMASS1,21,20,2,3
CMASS2,22,.02,3,3
CMASS3,23,20,50
CMASS4,24,.05,51
PBUSH,30,K,1000.,1000.,1000.,10.,10.,10.
,B,1.,1.,1.,.1,.1,.1,GE
,.01
CBUSH,31,30,5,6,0.,0.,1.,
,.5,-1,.0,.0,.0
PBUSH1D,32,100.,1.,.1
CBUSH1D,33,32,2,4
PDAMP,40,.5
CDAMP1,41,40,2,3
CDAMP2,42,.5,3,3
CONM1,60,4,,.01,0.,.01,0.,0.
,.01,0.,0.,0.,1-5,0.,0.,0.
,0.,1-5,0.,0.,0.,0.,0.,1-5
SPC,1,1,123456,0.
)"},
    {"Solids", R"(MAT1,1,7.+10,,.33,2700.
PSOLID,1,1,0
GRID,1,,0,0,0
GRID,2,,0.1,0,0
GRID,3,,0.2,0,0
GRID,4,,0,0.1,0
GRID,5,,0.1,0.1,0
GRID,6,,0.2,0.1,0
GRID,7,,0,0,0.1
GRID,8,,0.1,0,0.1
GRID,9,,0.2,0,0.1
GRID,10,,0,0.1,0.1
GRID,11,,0.1,0.1,0.1
GRID,12,,0.2,0.1,0.1
CHEXA,1,1,1,2,5,4,7,8
,11,10
CPENTA,2,1,2,3,6,8,9,12
CTETRA,3,1,2,6,5,11
GRID,20,,.1,.2,.05
CPYRAM,4,1,4,10,11,5,20
SPC1,1,123,1,4,7,10
)"},
    {"Laminates", R"(MAT8,1,1.4+11,1.+10,.3,5.+9,3.+9,3.+9,1600.
,1-6,1-6,20.
MAT2,2,7.8+10,2.6+10,0.,7.8+10,0.,2.6+10,2700.
PCOMP,1,-.001,.1,,,,,SYM
,1,.0005,0.,YES,1,.0005,45.,YES
,1,.0005,90.,YES
PSHELL,2,2,.003,2
GRID,1,,0,0,0.
GRID,2,,0.1,0,0.
GRID,3,,0.2,0,0.
GRID,4,,0.3,0,0.
GRID,5,,0,0.1,0.
GRID,6,,0.1,0.1,0.
GRID,7,,0.2,0.1,0.
GRID,8,,0.3,0.1,0.
GRID,9,,0,0.2,0.
GRID,10,,0.1,0.2,0.
GRID,11,,0.2,0.2,0.
GRID,12,,0.3,0.2,0.
CQUAD4,1,1,1,2,6,5,30.,.0001
CTRIA3,2,1,2,3,7,10.,.0001
CTRIA3,3,2,2,7,6
CQUAD4,4,2,3,4,8,7
CQUAD4,5,1,5,6,10,9
CQUAD4,6,1,6,7,11,10
CQUAD4,7,1,7,8,12,11
SPC1,1,123456,1,5,9
)"},
    {"Axes", R"(MAT1,1,7.+10,,.33,2700.
PSHELL,1,1,.003,1,,1
CORD2R,1,0,0.,0.,0.,0.,0.,1.
,1.,0.,0.
CORD2C,2,0,0.,0.,0.,0.,0.,1.
,1.,0.,0.
CORD2S,3,1,0.,0.,0.,0.,0.,1.
,1.,0.,0.
CORD1R,4,1,2,5
GRDSET,,0,,,,0,
GRID,1,,0,0,0.
GRID,2,1,0.1,0,0.
GRID,3,,0.2,0,0.
GRID,4,,0.3,0,0.
GRID,5,,0,0.1,0.
GRID,6,,0.1,0.1,0.
GRID,7,,0.2,0.1,0.
GRID,8,,0.3,0.1,0.
GRID,9,,0,0.2,0.
GRID,10,,0.1,0.2,0.
GRID,11,,0.2,0.2,0.
GRID,12,,0.3,0.2,0.
CQUAD4,1,1,1,2,6,5
CQUAD4,2,1,2,3,7,6
CQUAD4,3,1,3,4,8,7
CQUAD4,4,1,5,6,10,9
CQUAD4,5,1,6,7,11,10
CQUAD4,6,1,7,8,12,11
SPC1,1,123456,1,5,9
)"},
    {"Relations", R"(MAT1,1,7.+10,,.33,2700.
PSHELL,1,1,.003,1,,1
GRID,1,,0,0,0.
GRID,2,,0.1,0,0.
GRID,3,,0.2,0,0.
GRID,4,,0.3,0,0.
GRID,5,,0,0.1,0.
GRID,6,,0.1,0.1,0.
GRID,7,,0.2,0.1,0.
GRID,8,,0.3,0.1,0.
GRID,9,,0,0.2,0.
GRID,10,,0.1,0.2,0.
GRID,11,,0.2,0.2,0.
GRID,12,,0.3,0.2,0.
CQUAD4,1,1,1,2,6,5
CQUAD4,2,1,2,3,7,6
CQUAD4,3,1,3,4,8,7
CQUAD4,4,1,5,6,10,9
CQUAD4,5,1,6,7,11,10
CQUAD4,6,1,7,8,12,11
GRID,30,,.3,.2,.1
GRID,31,,.3,.0,.1
GRID,32,,.2,.1,.1
GRID,33,,.1,.1,.2
GRID,34,,.1,.2,.2
RBE2,40,12,123456,30,31
RBE3,41,,32,123,1.,123,6,7
,1.,123,10
RBAR,42,7,33,123456,,,123456
RROD,43,11,34,1,
MPC,1,4,3,1.,8,3,-1.
CONM2,90,30,,.1
CONM2,91,32,,.1
CONM2,92,33,,.01,,,,
,1-4,,1-4,,,1-4
CONM2,93,34,,.01
SPC1,1,123456,1,5,9
SPC1,1,23456,34
)"},
    {"Materials", R"(MAT1,1,7.+10,,.33,2700.
PSHELL,1,1,.003,1,,1
MAT9,9,1.+11,4.+10,4.+10,0.,0.,0.,1.+11
,4.+10,0.,0.,0.,1.+11,0.,0.,0.
,3.+10,0.,0.,3.+10,0.,3.+10,2700.
MAT11,11,1.+11,1.+10,1.+10,.3,.3,.3,5.+9
,5.+9,5.+9,1600.
PSOLID,9,9
PSOLID,11,11
GRID,1,,0.,0.,0.
GRID,2,,.2,0.,0.
GRID,3,,.2,.2,0.
GRID,4,,0.,.2,0.
GRID,5,,.1,0.,0.
GRID,6,,.2,.1,0.
GRID,7,,.1,.2,0.
GRID,8,,0.,.1,0.
CQUAD8,1,1,1,2,3,4,5,6
,7,8
GRID,11,,0.,0.,.1
GRID,12,,.2,0.,.1
GRID,13,,.2,.2,.1
GRID,14,,0.,.2,.1
GRID,15,,.1,.1,.2
CHEXA,2,9,1,2,3,4,11,12
,13,14
CPYRAM,3,11,11,12,13,14,15
PSHEAR,20,1,.002,.1
CSHEAR,21,20,1,2,3,4
SPC1,1,123456,1,4,8
)"},
};

constexpr const char* absurd[] = {"0.",
                                  "-1.",
                                  "1.-300",
                                  "1.+300",
                                  "1.+38",
                                  "1.-20",
                                  "nan",
                                  "inf",
                                  "",
                                  "text",
                                  "2147483648",
                                  "1.+400",
                                  "-1"};

std::vector<std::string> parted(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

bool is_number(const std::string& field) {
  return field.find_first_of("0123456789") != std::string::npos &&
         field.find_first_not_of("+-.0123456789") == std::string::npos;
}

// Every deck that differs from a text in one number of it.
template <typename Visit>
void for_each_changed(const std::string& text, const Visit& visit) {
  const std::vector<std::string> lines = parted(text, '\n');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> fields = parted(lines[i], ',');
    for (std::size_t k = 1; k < fields.size(); ++k) {
      if (!is_number(fields[k])) continue;
      for (const char* value : absurd) {
        std::string changed;
        for (std::size_t j = 0; j < lines.size(); ++j) {
          if (j != i) {
            changed += lines[j] + "\n";
            continue;
          }
          for (std::size_t m = 0; m < fields.size(); ++m) {
            changed += (m > 0 ? "," : "") + (m == k ? value : fields[m]);
          }
          changed += "\n";
        }
        visit(changed, lines[i] + " <- " + value);
      }
    }
  }
}

class AbsurdNumbers : public ::testing::TestWithParam<NamedDeck> {};

TEST_P(AbsurdNumbers, AreRefusedOrHaveModes) {
  int refused = 0;
  int solved = 0;
  const auto modes_of = [](const std::string& text) {
    const Deck deck = deck_of(text);
    return deck_modes(deck, assemble(deck), 6).modes;
  };
  ASSERT_NO_THROW((void)modes_of(GetParam().text));
  for_each_changed(GetParam().text,
                   [&](const std::string& text, const std::string& what) {
                     try {
                       const Eigenmodes modes = modes_of(text);
                       EXPECT_TRUE(modes.frequency_hz.allFinite()) << what;
                       EXPECT_TRUE(modes.phi.allFinite()) << what;
                       ++solved;
                     } catch (const InputError& error) {
                       EXPECT_FALSE(error.remedy().empty()) << what;
                       ++refused;
                     }
                   });
  EXPECT_GT(refused, 100);
  EXPECT_GT(solved, 30);
}

INSTANTIATE_TEST_SUITE_P(Cards,
                         AbsurdNumbers,
                         ::testing::ValuesIn(decks),
                         [](const auto& tried) { return tried.param.name; });

}  // namespace
}  // namespace tapfit::structure
