// A session of its own on what another one has measured.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/generated_bundle.hpp"
#include "updating/session/session.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

TEST(SessionBeside, MeasuresNothingAnewAndLeavesTheOther) {
  const tapfit::testing::TemporaryFolder folder;
  const auto bundle = folder.path() / "bundle";
  testing::write_bundle(testing::plain_test({.runs = 4}), bundle);
  Session session(bundle);
  const auto modes = session.modes().modes.size();
  ASSERT_GT(modes, 0U);

  Session beside = session.beside();
  std::vector<std::string> worked_out;
  const Progress watched{
      [&](std::string_view stage, double) { worked_out.emplace_back(stage); },
      {}};
  EXPECT_EQ(beside.modes(watched).modes.size(), modes);
  EXPECT_EQ(beside.frfs(watched).frfs.size(), session.frfs().frfs.size());
  EXPECT_TRUE(worked_out.empty()) << worked_out.front();

  const bool accepted = session.hits().runs[0][0].accepted;
  beside.overrule_hit(0, 0);
  EXPECT_NE(beside.hits().runs[0][0].accepted, accepted);
  EXPECT_EQ(session.hits().runs[0][0].accepted, accepted);
  EXPECT_TRUE(session.overruled().empty());
}

}  // namespace
}  // namespace tapfit::updating
