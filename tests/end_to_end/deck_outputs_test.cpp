// The updated deck of a test whose deck is in several files.
#include "tests/end_to_end/written_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;

// Grids and rods in one file, materials in another, with line ends of Windows;
// five of the materials are uncertain, nothing else is.
TEST_F(OutputsOfATest, OfADeckKeepItsIncludeFiles) {
  const std::string whole = read_file(bundle_ / "model.bdf");
  const std::size_t metals = whole.find("$ Aluminium");
  const std::size_t end = whole.find("ENDDATA");
  ASSERT_LT(metals, end);
  ASSERT_NE(end, std::string::npos);
  fs::create_directory(bundle_ / "parts");
  write_file(bundle_ / "parts" / "truss.inc", whole.substr(0, metals));
  write_file(bundle_ / "parts" / "metals.inc",
             whole.substr(metals, end - metals));
  write_file(bundle_ / "model.bdf",
             "include 'parts/truss.inc'  $ Rods\r\n"
             "include 'parts/\r\nmetals.inc'\r\nENDDATA\r\n");
  const fs::path out = bundle_.parent_path() / "out";
  fs::create_directory(out);

  const ProgramResult result = run(
      "export", fmt::format("--deck '{}' --json", (out / "new.bdf").string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("written"),
            (nlohmann::json{(out / "new.bdf").string(),
                            (out / "parts" / "metals.inc").string()}));
  std::set<std::string> changed;
  for (const auto& card : json.at("cards")) {
    if (card.at("before") == "") continue;
    changed.insert(card.at("card").get<std::string>());
  }
  EXPECT_EQ(changed,
            (std::set<std::string>{
                "MAT1 1", "MAT1 6", "MAT1 11", "MAT1 14", "MAT1 21"}));
  EXPECT_TRUE(read_file(out / "new.bdf")
                  .starts_with("INCLUDE '../truss/parts/truss.inc'  $ Rods\r\n"
                               "include 'parts/\r\nmetals.inc'\r\n"))
      << read_file(out / "new.bdf");
  EXPECT_EQ(read_file(bundle_ / "parts" / "truss.inc") +
                read_file(bundle_ / "parts" / "metals.inc") + "ENDDATA\n",
            whole);
  // What it says is that structure, by the program's own reader.
  const auto modes_of = [](const fs::path& deck) {
    const ProgramResult model =
        run_tapfit(fmt::format("model '{}' --modes 3 --json", deck.string()));
    EXPECT_EQ(model.exit_status, 0) << model.err;
    return nlohmann::json::parse(model.out);
  };
  const auto before = modes_of(bundle_ / "model.bdf");
  const auto after = modes_of(out / "new.bdf");
  EXPECT_EQ(after.at("elements"), before.at("elements"));
  EXPECT_EQ(after.at("mass_kg"), before.at("mass_kg"));
  EXPECT_NE(after.at("frequencies_hz"), before.at("frequencies_hz"));
}

// Its cards could not be read from it again, nor could files stand beside it.
TEST_F(OutputsOfATest, OfADeckAskForAFile) {
  const ProgramResult refused = run("export", "--deck /dev/null");
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(holds(refused.err, "is no file")) << refused.err;
  EXPECT_TRUE(holds(refused.err, "name a file")) << refused.err;
}

}  // namespace
}  // namespace tapfit::end_to_end
