#include "tui/app/all_plots.hpp"

#include "tests/tui/support/fake_workbench.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace tapfit::tui {
namespace {

std::set<std::string> names_of(const testing::FakeOptions& options) {
  std::set<std::string> names;
  for (const PlotFile& file :
       all_plots(testing::fake_workbench(options), Progress{})) {
    EXPECT_TRUE(names.insert(file.ending).second) << file.ending << " twice";
    EXPECT_FALSE(file.content.empty()) << file.ending;
  }
  return names;
}

bool any_begins(const std::set<std::string>& names, const std::string& with) {
  return std::ranges::any_of(names, [&with](const std::string& name) {
    return name.starts_with(with);
  });
}

TEST(AllPlots, AreThoseOfEveryScreen) {
  const std::set<std::string> names = names_of({});
  for (const char* screen :
       {"recording", "frf", "modes", "compare", "diagnose", "update"}) {
    EXPECT_TRUE(any_begins(names, screen)) << screen;
  }
  const auto ends = [](const std::string& name) {
    return name.ends_with(".svg") || name.ends_with(".csv");
  };
  EXPECT_TRUE(std::ranges::all_of(names, ends));
}

TEST(AllPlots, EndWithTheModesWithoutAModel) {
  testing::FakeOptions options;
  options.model = false;
  const std::set<std::string> names = names_of(options);
  EXPECT_TRUE(any_begins(names, "modes"));
  EXPECT_FALSE(any_begins(names, "compare"));
}

}  // namespace
}  // namespace tapfit::tui
