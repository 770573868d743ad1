// What `tapfit uff` prints of a file.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/acquisition/support/uff_text.hpp"
#include "tui/commands/commands.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

// Labels in Latin-1, in UTF-8, and with what a terminal would obey.
TEST(UffCommand, ShowsUnitsWhateverTheirEncoding) {
  testing::TemporaryFolder folder;
  CommandOptions options;
  options.input = folder.write(
      "labels.uff",
      testing::uff_ascii({.unit = "m/s\xb2", .values = {1, 2}}) +
          testing::uff_ascii({.unit = "\xc2\xb5m", .values = {1, 2}}) +
          testing::uff_ascii({.unit = "\x1b[2J", .values = {1, 2}}));
  const Progress quiet;
  const std::string text = uff_command(options, quiet);
  EXPECT_NE(text.find("m/s\u00b2"), std::string::npos) << text;
  EXPECT_NE(text.find("\u00b5m"), std::string::npos) << text;
  EXPECT_NE(text.find("?[2J"), std::string::npos) << text;
  options.json = true;
  const auto json = nlohmann::json::parse(uff_command(options, quiet));
  EXPECT_EQ(json["functions"][0]["unit"], "m/s\u00b2");
}

}  // namespace
}  // namespace tapfit::tui
