#include "modal/mode_set/read_modes_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/read_modes_csv.hpp"
#include "modal/mode_set/read_modes_json.hpp"
#include "modal/mode_set/uff55.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace tapfit::modal {
namespace {

using tapfit::testing::TemporaryFolder;

std::string said(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ReadModesCsv, TakesColumnsByNameInAnyOrder) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "modes.csv",
      "frequency_hz,frequency_sd_percent,damping_percent,12Z+,14Z-,9X+ re,"
      "9X+ im,12Z+ sd,14Z- sd,9X+ sd,name\n"
      "20.5,0.2,1.5,1.0,0.5,0.1,0.2,0.01,0.02,0.03,second\n"
      "10.0,0.1,1.0,-1.0,0.25,0.3,0.0,0.01,0.02,0.03,first\n");
  const ModeSet set = read_modes_csv(file);
  ASSERT_EQ(set.modes.size(), 2U);
  ASSERT_EQ(set.dofs.size(), 3U);
  const Mode& second = set.modes[1];  // by frequency
  EXPECT_DOUBLE_EQ(second.frequency_hz, 20.5);
  EXPECT_DOUBLE_EQ(second.frequency_sd_hz, 0.041);
  EXPECT_DOUBLE_EQ(second.damping_ratio, 0.015);
  EXPECT_EQ(name(set.dofs[0]), "9X+");
  EXPECT_EQ(second.shape(0), std::complex<double>(0.1, 0.2));
  EXPECT_EQ(second.shape(1), std::complex<double>(1.0, 0.0));
  EXPECT_EQ(name(set.dofs[2]), "14Z+");  // turned
  EXPECT_EQ(second.shape(2), std::complex<double>(-0.5, 0.0));
  EXPECT_DOUBLE_EQ(second.shape_sd(2), 0.02);
  ASSERT_EQ(set.warnings.size(), 1U);
  EXPECT_TRUE(has(set.warnings[0], "\"name\"")) << set.warnings[0];
  EXPECT_FALSE(set.scaled);
}

TEST(ReadModesCsv, FrequenciesAloneWillDo) {
  const TemporaryFolder folder;
  const ModeSet set =
      read_modes_csv(folder.write("modes.csv", "frequency_hz\n7.96\n13.83\n"));
  ASSERT_EQ(set.modes.size(), 2U);
  EXPECT_TRUE(set.dofs.empty());
  EXPECT_DOUBLE_EQ(set.modes[1].frequency_hz, 13.83);
}

TEST(ReadModesCsv, NamesTheCellThatIsNoNumber) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("modes.csv", "frequency_hz,12Z+\n10.0,1.0\n20.0,nan\n");
  const std::string text = said([&] { (void)read_modes_csv(file); });
  EXPECT_TRUE(has(text, "modes.csv:3:2")) << text;
  EXPECT_TRUE(has(text, "nan")) << text;
}

TEST(ReadModesCsv, WantsFrequenciesAndWholeShapes) {
  const TemporaryFolder folder;
  const auto without = folder.write("a.csv", "f,12Z+\n10.0,1.0\n");
  EXPECT_TRUE(
      has(said([&] { (void)read_modes_csv(without); }), "frequency_hz"));
  const auto half = folder.write("b.csv", "frequency_hz,12Z+ im\n10.0,1.0\n");
  EXPECT_TRUE(has(said([&] { (void)read_modes_csv(half); }), "12Z+"));
  const auto empty = folder.write("c.csv", "frequency_hz,12Z+\n");
  EXPECT_FALSE(said([&] { (void)read_modes_csv(empty); }).empty());
}

TEST(ReadModesCsv, CommentsAndALineOfUnitsAreRead) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    return read_modes_csv(folder.write("modes.csv", text));
  };
  for (const char* text : {"# published, 2024\n\nfrequency_hz\n3.09\n5.45\n",
                           "frequency_hz\nHz\n3.09\n5.45\n",
                           "% by hand\nFrequency;Damping\nHz;%\n"
                           "# bending\n3,09;0,5\n5,45;0,5\n"}) {
    const ModeSet set = read(text);
    ASSERT_EQ(set.modes.size(), 2U) << text;
    EXPECT_DOUBLE_EQ(set.modes[1].frequency_hz, 5.45) << text;
  }
  const ModeSet units =
      read("Frequency,Damping,12Z+\nHz,%,m/s^2\n3.09,0.5,0.3\n");
  EXPECT_DOUBLE_EQ(units.modes.at(0).damping_ratio, 0.005);
  EXPECT_DOUBLE_EQ(units.modes[0].shape(0).real(), 0.3);
  EXPECT_TRUE(units.warnings.empty());
  EXPECT_DOUBLE_EQ(
      read("Frequency,Damping\nHz,-\n3.09,0.005\n").modes.at(0).damping_ratio,
      0.005);
  // Another unit is none that a number is taken in.
  const std::string text = said([&] { (void)read("frequency_hz\nkHz\n3\n"); });
  EXPECT_TRUE(has(text, "no column \"frequency_hz\"")) << text;
  const std::string late = said([&] { (void)read("# a\n# b\nf,1Z+\n3,1\n"); });
  EXPECT_TRUE(has(late, "modes.csv:3")) << late;
}

TEST(ReadModesCsv, AHeaderAloneHoldsNoMode) {
  const TemporaryFolder folder;
  for (const char* text : {"frequency_hz\n", "# a\nfrequency_hz\nHz\n"}) {
    const auto file = folder.write("modes.csv", text);
    const std::string refused = said([&] { (void)read_modes_csv(file); });
    EXPECT_TRUE(has(refused, "no mode below the names")) << refused;
    EXPECT_TRUE(has(refused, "a line of numbers for each mode")) << refused;
  }
}

TEST(ReadModesCsv, ADirectionsSignIsEachColumnsOwn) {
  const TemporaryFolder folder;
  const auto file = folder.write("modes.csv",
                                 "frequency_hz,12Z+ re,12Z- im,12Z- sd\n"
                                 "10.0,1.0,0.5,0.01\n");
  const ModeSet set = read_modes_csv(file);
  ASSERT_EQ(set.dofs.size(), 1U);
  EXPECT_EQ(set.modes[0].shape(0), std::complex<double>(1.0, -0.5));
  EXPECT_DOUBLE_EQ(set.modes[0].shape_sd(0), 0.01);
}

TEST(ReadModesCsv, NothingIsSaidTwice) {
  const TemporaryFolder folder;
  for (const char* header : {"frequency_hz,12Z+,12Z-",
                             "frequency_hz,12Z+,12Z+ re",
                             "frequency_hz,frequency_hz,12Z+"}) {
    const auto file =
        folder.write("modes.csv", std::string(header) + "\n10.0,10.0,1.0\n");
    EXPECT_TRUE(has(said([&] { (void)read_modes_csv(file); }), "says again"))
        << header;
  }
}

TEST(ReadModesJson, TakesModesInAnyOrder) {
  const ModeSet set = read_modes_json(
      R"({"modes": [{"frequency_hz": 20.0, "shape": {"3Z+": 2}},
                    {"frequency_hz": 10.0, "shape": {"3Z+": 1}}]})",
      "memory");
  ASSERT_EQ(set.modes.size(), 2U);
  EXPECT_EQ(set.modes[0].frequency_hz, 10.0);
  EXPECT_EQ(set.modes[0].shape(0), std::complex<double>(1.0, 0.0));
}

TEST(ReadModesJson, RefusesAPointWithTwoValues) {
  const std::string text = said([] {
    (void)read_modes_json(
        R"({"modes": [{"frequency_hz": 10.0,
                       "shape": {"3Z+": 1, "3Z-": 1}}]})",
        "modes.json");
  });
  EXPECT_TRUE(has(text, "two values at 3Z+")) << text;
}

TEST(ReadModesJson, TakesPlainNumbersByHand) {
  const ModeSet set = read_modes_json(
      R"({"modes": [{"frequency_hz": 10.0, "shape": {"3Z+": 1, "4Z-": 2}},
                    {"frequency_hz": {"value": 20.0, "sd": 0.1},
                     "damping_ratio": 0.02,
                     "shape": {"3Z+": [1, 0.5], "4Z+": 0}}]})",
      "memory");
  ASSERT_EQ(set.modes.size(), 2U);
  EXPECT_EQ(set.modes[0].shape(1), std::complex<double>(-2.0, 0.0));
  EXPECT_EQ(set.modes[1].shape(0), std::complex<double>(1.0, 0.5));
  EXPECT_DOUBLE_EQ(set.modes[1].frequency_sd_hz, 0.1);
  EXPECT_DOUBLE_EQ(set.modes[1].damping_ratio, 0.02);
}

TEST(ReadModesJson, NamesThePointWithoutAValue) {
  const std::string text = said([] {
    (void)read_modes_json(
        R"({"modes": [{"frequency_hz": 10.0, "shape": {"3Z+": 1}},
                      {"frequency_hz": 20.0, "shape": {"4Z+": 1}}]})",
        "modes.json");
  });
  EXPECT_TRUE(has(text, "4Z+")) << text;
  EXPECT_TRUE(has(text, "modes.json: modes[0].shape")) << text;
}

ModeSet two_modes() {
  return read_modes_json(
      R"({"modes": [{"frequency_hz": 10.0, "damping_ratio": 0.01,
                     "shape": {"3Z+": 1, "4Z+": 2}},
                    {"frequency_hz": 20.0, "damping_ratio": 0.01,
                     "shape": {"3Z+": 1, "4Z+": -1}}]})",
      "memory");
}

TEST(ReadModesFile, TellsFormatsApart) {
  const TemporaryFolder folder;
  for (const ModeDataset as : {ModeDataset::Uff55, ModeDataset::Uff2414}) {
    const auto uff =
        folder.write("modes.uff", modes_as_uff(two_modes(), "two", as));
    const ModeSet set = read_modes_file(uff);
    ASSERT_EQ(set.modes.size(), 2U);
    EXPECT_NEAR(set.modes[1].frequency_hz, 20.0, 1e-4);  // six digits
    EXPECT_NEAR(set.modes[1].damping_ratio, 0.01, 1e-5);
    EXPECT_EQ(set.dofs, two_modes().dofs);
  }
  const auto csv = folder.write("modes.csv", "frequency_hz,3Z+\n1,2\n2,3\n");
  EXPECT_EQ(read_modes_file(csv).modes.size(), 2U);
  EXPECT_FALSE(said([&] { (void)read_modes_file(folder.path()); }).empty());
}

// As instruments head their columns.
TEST(ReadModesCsv, TakesUnitsInBrackets) {
  const TemporaryFolder folder;
  const ModeSet set = read_modes_csv(
      folder.write("modes.csv", "Frequency [Hz],Damping [%]\n8.2,1.5\n"));
  ASSERT_EQ(set.modes.size(), 1U);
  EXPECT_DOUBLE_EQ(set.modes[0].frequency_hz, 8.2);
  EXPECT_DOUBLE_EQ(set.modes[0].damping_ratio, 0.015);
  // Of what unit this is, its name does not say.
  EXPECT_EQ(read_modes_csv(
                folder.write("open.csv", "Frequency (Hz),Damping\n8.2,1.5\n"))
                .warnings.size(),
            1U);
}

TEST(CheckMeasured, NamesModeFaultAndRemedy) {
  EXPECT_NO_THROW(check_measured(two_modes(), "m"));
  const auto fault = [](const std::function<void(ModeSet&)>& spoil) {
    ModeSet set = two_modes();
    spoil(set);
    return said([&] { check_measured(set, "modes.uff"); });
  };
  const std::string negative =
      fault([](ModeSet& s) { s.modes[1].damping_ratio = -0.01; });
  EXPECT_TRUE(has(negative, "modes.uff: mode 2")) << negative;
  EXPECT_TRUE(has(negative, "damping ratio")) << negative;
  // Two modes of what is symmetric: only shapes that are alike are one mode.
  EXPECT_EQ(fault([](ModeSet& s) { s.modes[1].frequency_hz = 10.0; }), "");
  const std::string twice = fault([](ModeSet& s) {
    s.modes[1].frequency_hz = 10.0;
    s.modes[1].shape = std::complex<double>(0.0, -2.0) * s.modes[0].shape;
  });
  EXPECT_TRUE(has(twice, "frequency of the mode before")) << twice;
  EXPECT_FALSE(fault([](ModeSet& s) {
                 s.modes[1].frequency_hz = 10.0;
                 for (Mode& mode : s.modes) mode.shape.resize(0);
               }).empty());
  EXPECT_FALSE(
      fault([](ModeSet& s) { s.modes[1].frequency_sd_hz = -0.1; }).empty());
  // Weights of it would be nothing or without end.
  for (const double sd : {1e-300, 1e300}) {
    EXPECT_FALSE(
        fault([=](ModeSet& s) { s.modes[1].frequency_sd_hz = sd; }).empty());
  }
  EXPECT_FALSE(fault([](ModeSet& s) { s.modes[1].shape *= 1e-300; }).empty());
  const std::string nan =
      fault([](ModeSet& s) { s.modes[0].shape(1) = std::nan(""); });
  EXPECT_TRUE(has(nan, "mode 1")) << nan;
  EXPECT_FALSE(fault([](ModeSet& s) {
                 s.modes[0].frequency_hz = std::nan("");
               }).empty());
  // All points at its nodes: the frequency counts.
  EXPECT_EQ(fault([](ModeSet& s) { s.modes[0].shape.setZero(); }), "");
}

TEST(ReadModesJson, NamesTheNumberThatIsNone) {
  const auto fault = [](const char* text) {
    return said([text] { (void)read_modes_json(text, "modes.json"); });
  };
  const std::string text =
      fault(R"({"modes": [{"frequency_hz": 8.0}, {"frequency_hz": "8.2"}]})");
  EXPECT_TRUE(has(text, "modes.json: modes[1].frequency_hz")) << text;
  EXPECT_TRUE(has(text, "\"8.2\" is no number")) << text;
  EXPECT_TRUE(has(fault(R"({"modes": [{}]})"), "it is missing"));
  EXPECT_TRUE(has(fault(R"({"frequencies": [8.2]})"), "no list of modes"));
}

// Python writes NaN, others null, where a value is not known.
TEST(ReadModesJson, NamesThePointWithoutANumber) {
  for (const char* value :
       {"NaN", "-Infinity", "null", "\"0.3\"", "[1, null]"}) {
    const std::string text = said([value] {
      (void)read_modes_json(fmt::format(R"({{"note": "NaN \" NaN", "modes": [
            {{"frequency_hz": 3.0, "shape": {{"12Z+": 0.3}}}},
            {{"frequency_hz": 5.0, "shape": {{"12Z+": {}}}}}]}})",
                                        value),
                            "modes.json");
    });
    EXPECT_TRUE(has(text, "modes.json: modes[1].shape.12Z+")) << text;
    EXPECT_TRUE(has(text, "leave the point out")) << text;
    EXPECT_FALSE(has(text, "json.exception")) << text;
  }
  const auto fault = [](const std::string& entry) {
    return said([&] {
      (void)read_modes_json("{\"modes\": [{" + entry + "}]}", "modes.json");
    });
  };
  EXPECT_TRUE(has(fault(R"("frequency_hz": NaN)"), "modes[0].frequency_hz"));
  EXPECT_TRUE(
      has(fault(R"("frequency_hz": 3, "shape": 0.3)"), "no object of points"));
  EXPECT_TRUE(has(
      fault(
          R"("frequency_hz": 3, "shape": {"1Z+": 1}, "shape_sd": {"1Z+": NaN})"),
      "modes[0].shape_sd.1Z+"));
  // A damping that is not known is none.
  EXPECT_EQ(
      read_modes_json(
          R"({"modes": [{"frequency_hz": 3, "damping_ratio": NaN}]})", "m")
          .modes.at(0)
          .damping_ratio,
      0.0);
}

}  // namespace
}  // namespace tapfit::modal
