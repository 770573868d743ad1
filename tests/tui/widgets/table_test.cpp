#include "tui/widgets/table.hpp"

#include "tests/support/matchers.hpp"

namespace tapfit::tui {
namespace {

Table numbers(int count) {
  Table table{{{"name"}, {"n", true}}, {}};
  for (int i = 0; i < count; ++i) {
    table.rows.push_back({{"row " + std::to_string(i), std::to_string(i)}, {}});
  }
  return table;
}

TEST(Table, ShowsTheSelectedRowHoweverFarDown) {
  const Table table = numbers(100);
  Screen screen(20, 5);
  draw_table(screen, screen.area(), table, {73, ""}, true);
  EXPECT_THAT(screen.to_text(), HasSubstr("▸row 73"));
}

// In reverse a full bar would look empty and an empty one full.
TEST(Table, ABarIsTheSameInTheSelectedRow) {
  const Table table{{{"a"}, {"", false, true}}, {{{"x", "██"}, {}}}};
  Screen screen(12, 2);
  draw_table(screen, screen.area(), table, {}, true);
  EXPECT_TRUE(screen.at(1, 1).style.reverse);
  EXPECT_EQ(screen.at(4, 1).glyph, U'█');
  EXPECT_FALSE(screen.at(4, 1).style.reverse);
}

TEST(Table, RightColumnsEndTogether) {
  Screen screen(20, 4);
  Table table{{{"a"}, {"bbb", true}}, {{{"x", "1"}, {}}, {{"y", "22"}, {}}}};
  draw_table(screen, screen.area(), table, {}, false);
  EXPECT_EQ(screen.to_text(), " a  bbb\n x    1\n y   22\n\n");
}

TEST(Table, LeavesOutNumbersThatDoNotFitAndCutsTexts) {
  const Table table{{{"a"}, {"b", true}, {"c", true}},
                    {{{"x", "1.25", "2.75"}, {}}}};
  Screen numbers_cut(12, 2);  // "x  1.25  2.75" takes 13 cells and the edges
  draw_table(numbers_cut, numbers_cut.area(), table, {}, false);
  EXPECT_EQ(numbers_cut.to_text(), " a     b\n x  1.25\n");
  const Table words{{{"a"}, {"b"}}, {{{"x", "in words"}, {}}}};
  Screen words_cut(10, 2);
  draw_table(words_cut, words_cut.area(), words, {}, false);
  EXPECT_EQ(words_cut.to_text(), " a  b\n x  in w…\n");
}

TEST(Table, FilterHidesRowsAndMovesTheSelection) {
  const Table table = numbers(20);
  ListState state{0, "ROW 1"};  // 1 and 10..19
  EXPECT_EQ(visible_rows(table, state).size(), 11U);
  EXPECT_EQ(settled(table, state), 1U);
  EXPECT_TRUE(list_key(state, table, Key(keys::down)));
  EXPECT_EQ(state.selected, 10U);
  EXPECT_TRUE(list_key(state, table, Key(U'G')));
  EXPECT_EQ(state.selected, 19U);
}

// FRFs by name or coherence; what is marked stays marked.
TEST(Table, SortsByOneColumnAfterTheOther) {
  const Table table{{{"name"}, {"p", true}},
                    {{{"145Z+", "<0.001"}, {}},
                     {{"* 60Z+", "0.927"}, {}},
                     {{"gamma", "–"}, {}},
                     {{"Delta", "1.000"}, {}}}};
  ListState state{1, ""};
  std::string told;
  const auto order = [&] { return visible_rows(table, state); };
  using Rows = std::vector<std::size_t>;
  EXPECT_EQ(order(), (Rows{0, 1, 2, 3}));
  EXPECT_TRUE(sort_key(state, table, Key(U's'), told));
  EXPECT_EQ(order(), (Rows{1, 0, 3, 2}))
      << "60 before 145, and no matter a tag";
  EXPECT_EQ(told, "sorted by name");
  EXPECT_TRUE(sort_key(state, table, Key(U's'), told));
  EXPECT_EQ(order(), (Rows{3, 1, 0, 2}));
  EXPECT_EQ(settled(table, state), 1U);
  EXPECT_TRUE(list_key(state, table, keys::down));
  EXPECT_EQ(state.selected, 0U) << "the next as they stand";
  Screen screen(20, 5);
  draw_table(screen, screen.area(), table, state, true);
  const std::string text = screen.to_text();
  EXPECT_NE(text.find("p▾"), std::string::npos) << text;
  EXPECT_LT(text.find("Delta"), text.find("60Z+")) << text;
  EXPECT_TRUE(sort_key(state, table, Key(U's'), told));
  EXPECT_EQ(order(), (Rows{0, 1, 3, 2}));
  EXPECT_EQ(told, "sorted by p, rising");
  EXPECT_TRUE(sort_key(state, table, Key(U's'), told));
  EXPECT_EQ(order(), (Rows{0, 1, 2, 3}));
  EXPECT_EQ(told, "not sorted");
  EXPECT_FALSE(sort_key(state, table, Key(U'x'), told));
}

TEST(Table, KeepsToNoColumnThatIsNotThere) {
  ListState state{0, "", "gone"};
  std::string told;
  EXPECT_EQ(visible_rows(numbers(3), state),
            (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(sort_key(state, numbers(0), Key(U's'), told));
  EXPECT_TRUE(visible_rows(numbers(0), state).empty());
}

TEST(Table, TakesNoRowsAndNoRoom) {
  Screen screen(3, 1);
  ListState state{5, ""};
  EXPECT_NO_THROW(draw_table(screen, screen.area(), numbers(0), state, true));
  EXPECT_FALSE(list_key(state, numbers(0), Key(keys::down)));
  EXPECT_NO_THROW(draw_table(screen, {0, 0, 0, 0}, numbers(3), state, true));
}

}  // namespace
}  // namespace tapfit::tui
