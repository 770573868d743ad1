// What a report takes from a test.json beside the measurement.
#include "acquisition/bundle/test_notes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace tapfit::acquisition {
namespace {

std::filesystem::path folder_with(const std::string& text) {
  const auto folder =
      std::filesystem::temp_directory_path() / "tapfit-tests" / "test_notes";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "test.json") << text;
  return folder;
}

TEST(TestNotes, AreLimitsSerialNumbersAndFacts) {
  const TestNotes notes = read_test_notes(folder_with(R"({"tapfit": 1,
    "title": "T", "limits": {"frequency_percent": 2, "mac": 0.9,
               "cross_orthogonality_diagonal": 0.95},
    "operator": "A. Ritter", "temperature_c": 21.5, "hold_off_s": 1,
    "climate": {"humidity_percent": 40},
    "channels": [{"name": "acc1", "serial": "4711", "calibrated": "2025-03",
                  "calibration_due": "2026-03", "unit": "g", "cable_m": 2},
                 {"name": "hammer"}], "runs": []})"));
  EXPECT_EQ(notes.limits.frequency_percent, 2.0);
  EXPECT_EQ(notes.limits.mac, 0.9);
  EXPECT_FALSE(notes.limits.cross_orthogonality);
  EXPECT_EQ(notes.limits.cross_orthogonality_diagonal, 0.95);
  EXPECT_EQ(notes.channels.at("acc1").serial, "4711");
  EXPECT_EQ(notes.channels.at("acc1").calibrated, "2025-03");
  EXPECT_EQ(notes.channels.at("acc1").calibration_due, "2026-03");
  EXPECT_EQ(notes.channels.at("hammer").serial, "");
  using Fact = std::pair<std::string, std::string>;
  EXPECT_EQ(notes.channels.at("acc1").others,
            (std::vector<Fact>{{"cable", "2 m"}}));
  EXPECT_EQ(notes.facts,
            (std::vector<Fact>{{"operator", "A. Ritter"},
                               {"temperature", "21.5 °C"},
                               {"climate humidity", "40 %"}}));
}

TEST(TestNotes, AreNoneOfAFileThatIsNoJson) {
  const auto folder = folder_with("    -1\n");
  EXPECT_TRUE(read_test_notes(folder).facts.empty());
  EXPECT_TRUE(read_test_notes(folder / "not-there").facts.empty());
}

}  // namespace
}  // namespace tapfit::acquisition
