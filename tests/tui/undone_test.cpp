#include "tui/undone.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

using updating::AddedEffect;
using updating::EffectRef;

EffectRef mass_at(int node) {
  updating::Where where;
  where.node = node;
  return {"added-mass", where};
}

EffectRef support() {
  updating::Where where;
  where.nodes = {1, 2, 3};
  where.variant = "rotation";
  return {"soft-support", where};
}

TEST(Undone, FindsTheOneChange) {
  const std::vector<AddedEffect> none;
  const std::vector<AddedEffect> one{{mass_at(5), true}};
  const std::vector<AddedEffect> off{{mass_at(5), false}};
  EXPECT_EQ(change_between(none, one), (EffectChange{mass_at(5), {}}));
  EXPECT_EQ(change_between(one, off), (EffectChange{{}, 0}));
  EXPECT_FALSE(change_between(one, one));
  EXPECT_FALSE(change_between(one, none));
}

TEST(Undone, ComesBackFromTheSession) {
  const std::vector<EffectChange> undone{
      {mass_at(5), {}}, {{}, 2}, {support(), {}}};
  updating::SavedSession session;
  session.title = "a test";
  session.effects = {{mass_at(7), true}};
  const std::string text = with_undone(updating::as_text(session), undone);
  EXPECT_EQ(undone_in(text), undone);
  EXPECT_TRUE(undone_in(with_undone(updating::as_text(session), {})).empty());
}

TEST(Undone, TakesFilesWithoutOrWithRubbish) {
  EXPECT_TRUE(undone_in("").empty());
  EXPECT_TRUE(undone_in("{\"undone\": 3}").empty());
  EXPECT_TRUE(undone_in("{\"undone\": [{\"effect\": 1}]}").empty());
  EXPECT_TRUE(undone_in("[]").empty());
}

}  // namespace
}  // namespace tapfit::tui
