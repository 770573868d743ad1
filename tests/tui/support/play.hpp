// Key scripts played on the made-up workbench, and what is looked for in them.
#pragma once

#include "tests/tui/support/fake_workbench.hpp"
#include "tests/tui/support/holds.hpp"
#include "tui/app/program.hpp"
#include "tui/app/replay.hpp"
#include "tui/screen/text.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace tapfit::tui {

using testing::FakeOptions;

inline std::string played(const std::string& script,
                          const Canvas& canvas = {},
                          const FakeOptions& options = {}) {
  Program program(testing::fake_workbench(options), canvas);
  return replay(program, parse_key_script(script));
}

inline void expect_fits(const std::string& text, int width) {
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    EXPECT_LE(text_width(line), width) << line;
  }
  EXPECT_FALSE(holds(text, "nan")) << text;
  EXPECT_FALSE(holds(text, "inf ")) << text;
}

}  // namespace tapfit::tui
