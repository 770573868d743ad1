#include "tui/views/diagnose_details.hpp"

#include "tests/tui/support/fake_results.hpp"
#include "tests/tui/support/play.hpp"
#include "tui/views/diagnose_view.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

using testing::fake_diagnosis;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(DiagnoseDetails, LeaveNothingOut) {
  updating::Diagnosis d = fake_diagnosis();
  d.warnings = {std::string(300, 'a') + " end of the first", "the second"};
  for (int node = 4680; node <= 4711; ++node) {
    updating::EffectRef other{"dashpot", {}};
    other.where.node = node;
    d.candidates[0].indistinguishable_from.push_back(other);
  }
  const std::string text = joined(details_of(d, d.candidates[0], 78));
  for (const char* words : {"verdict: added-mass",
                            "s = 5 + jw",
                            "end of the first",
                            "! the second",
                            "95 %: 0.0773 to 0.0797",
                            "dashpot node 4711"}) {
    EXPECT_TRUE(holds(text, words)) << words << " in\n" << text;
  }
  expect_fits(text, 300);
}

TEST(DiagnoseDetails, StandBehindANoteThatIsCut) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  updating::Diagnosis d = fake_diagnosis();
  const auto second_line = [&] {
    const std::string text =
        diagnose_view({bundle, d, {}}, {}, {80, 21, false}).to_text();
    const std::size_t begin = text.find('\n') + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  EXPECT_EQ(second_line(), " s = 5 + jw");
  d.warnings = {"short"};
  EXPECT_EQ(second_line(), " ! short");
  d.warnings.emplace_back("another");
  EXPECT_EQ(second_line(), " ! short  (1 of 2 notes, i: all)");
  d.warnings = {std::string(90, 'a')};
  EXPECT_TRUE(holds(second_line(), "a…  (i: all)")) << second_line();
  EXPECT_EQ(text_width(second_line()), 79);
  // The table follows at once.
  EXPECT_TRUE(
      holds(diagnose_view({bundle, d, {}}, {}, {80, 21, false}).to_text(),
            "(i: all)\n #   prob."));
}

TEST(DiagnoseDetails, ALongVerdictHasALineToItself) {
  const acquisition::TestBundle bundle = testing::fake_bundle();
  updating::Diagnosis d = fake_diagnosis();
  d.verdict = "sensor-mass+soft-support+stiffness-loss|ground-spring";
  const std::string text =
      diagnose_view({bundle, d, {}}, {}, {80, 21, false}).to_text();
  EXPECT_TRUE(holds(text,
                    " verdict: " + d.verdict +
                        "\n error 38.8 % → 3.8 %, floor 3.1 %\n s = 5 + jw\n"))
      << text;
}

TEST(DiagnoseDetails, AllNotesStandWhereThereIsNoCandidate) {
  const acquisition::TestBundle bundle;
  updating::Diagnosis d;
  d.warnings = {std::string(90, 'a') + " its end", "the second"};
  const std::string text =
      diagnose_view({bundle, d, {}}, {}, {80, 21, false}).to_text();
  EXPECT_TRUE(holds(text, "its end")) << text;
  EXPECT_TRUE(holds(text, "! the second")) << text;
}

// What was rejected is not identified.
TEST(DiagnoseDetails, SayOnlyOfWhatWasFoundThatItIsUnique) {
  updating::Diagnosis d = fake_diagnosis();
  const auto said = [&](std::size_t k) {
    return joined(details_of(d, d.candidates[k], 78));
  };
  EXPECT_TRUE(holds(said(0), "uniquely identified")) << said(0);
  d.candidates[1].indistinguishable_from.clear();
  EXPECT_FALSE(holds(said(1), "uniquely identified")) << said(1);
  d.candidates[0].indistinguishable_from = {{"sensor-mass", {}}};
  EXPECT_TRUE(holds(said(0), "with these points from")) << said(0);
  EXPECT_TRUE(holds(joined(details_of(d, d.candidates[0], 78, true)),
                    "with these modes from"));
}

TEST(DiagnoseDetails, AreShownByAKeyAndGoByEscape) {
  const std::string first = played("5\nwait\ni");
  EXPECT_TRUE(holds(first, "s = 5 + jw")) << first;
  EXPECT_TRUE(holds(first, "added-mass at node 5")) << first;
  EXPECT_FALSE(holds(first, "missing z")) << first;
  // Other keys do what they always do.
  EXPECT_TRUE(holds(played("5\nwait\nij"), "sensor-mass at acc1"));
  EXPECT_EQ(played("5\nwait\ni<Esc>"), played("5\nwait"));
  EXPECT_EQ(played("5\nwait\nii"), played("5\nwait"));
  EXPECT_EQ(played("5\nwait\ni<PageDown><PageUp>"), first);
}

}  // namespace
}  // namespace tapfit::tui
