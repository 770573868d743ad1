#include "signal/files/uff58.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/signal/support/some_frfs.hpp"
#include "tests/support/matchers.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>

namespace tapfit::signal {
namespace {

using testing::some_set;
using testing::written;

using complex = std::complex<double>;
using std::numbers::pi;

// One dataset around the given header fields and data.
std::string dataset(int type,
                    int data_type,
                    int count,
                    int even,
                    const std::string& data,
                    const std::string& numerator =
                        "        12    0    0    0 Acceleration         m/s^2",
                    const std::string& tag = "    58",
                    const std::string& force = "N") {
  return fmt::format(
      "    -1\n{}\nFRF\nNONE\nNONE\nNONE\nNONE\n"
      "{:5}         1    0         0 NONE              12   3 NONE           "
      "    3   3\n"
      "{:10}{:10}{:10}  2.00000E+00  5.00000E-01  0.00000E+00\n"
      "        18    0    0    0 Frequency            Hz\n"
      "{}\n"
      "        13    0    0    0 Force                {}\n"
      "         0    0    0    0 NONE                 NONE\n"
      "{}    -1\n",
      tag,
      type,
      data_type,
      count,
      even,
      numerator,
      force,
      data);
}

// One value, 1, in units of the given labels.
std::string labelled(const std::string& motion, const std::string& force) {
  return dataset(4,
                 5,
                 1,
                 1,
                 " 1. 0.\n",
                 "        12    0    0    0 Acceleration         " + motion,
                 "    58",
                 force);
}

TEST(Uff58, ReadsEveryLayout) {
  const std::string s = " 1.00000E+00 2.00000E+00 3.00000E+00 4.00000E+00\n";
  const auto even = read_frfs_uff_text(dataset(4, 5, 2, 1, s), "x").set;
  EXPECT_EQ(even.frfs[0].H(1), complex(3.0, 4.0));
  EXPECT_NEAR(even.frequency_hz()(1), 2.5, 1e-12);
  EXPECT_EQ(read_frfs_uff_text(dataset(4, 2, 4, 1, s), "x").set.frfs[0].H(3),
            complex(4.0, 0.0));
  const auto uneven = read_frfs_uff_text(dataset(4, 4, 2, 0, s), "x").set;
  EXPECT_EQ(uneven.frfs[0].H(1), complex(4.0, 0.0));
  EXPECT_NEAR(uneven.frequency_hz()(1), 3.0, 1e-12);
  const auto triple =
      read_frfs_uff_text(dataset(4,
                                 6,
                                 2,
                                 0,
                                 "  5.00000E+00  1.000000000000D+00 -2.0D+00\n"
                                 "  6.00000E+00  3.000000000000D+00  4.0d-1\n"),
                         "x");
  EXPECT_EQ(triple.set.frfs[0].H(1), complex(3.0, 0.4));
}

TEST(Uff58, ReadsGluedColumnsAndLostExponents) {
  const auto set =
      read_frfs_uff_text(
          dataset(
              4, 5, 2, 1, "-1.00000E+00-2.00000E+00-3.00000E+00-4.0000-103\n"),
          "x")
          .set;
  EXPECT_EQ(set.frfs[0].H(0), complex(-1.0, -2.0));
  EXPECT_EQ(set.frfs[0].H(1), complex(-3.0, -4e-103));
}

TEST(Uff58, MakesAccelerances) {
  const std::string s = " 1.00000E+00 2.00000E+00 3.00000E+00 4.00000E+00\n";
  const auto set =
      read_frfs_uff_text(
          dataset(4,
                  5,
                  2,
                  1,
                  s,
                  "         8    0    0    0 Displacement         mm"),
          "x")
          .set;
  const double w = 2.0 * pi * 2.0;
  EXPECT_LT(std::abs(set.frfs[0].H(0) + 1e-3 * w * w * complex(1.0, 2.0)),
            1e-12);
  const auto in_g =
      read_frfs_uff_text(
          dataset(4,
                  5,
                  2,
                  1,
                  s,
                  "        12    0    0    0 Acceleration         g"),
          "x")
          .set;
  EXPECT_LT(std::abs(in_g.frfs[0].H(0) - 9.80665 * complex(1.0, 2.0)), 1e-12);
}

TEST(Uff58, TakesUnitsOf164WhereTheLabelSaysNothing) {
  const std::string units =
      "    -1\n   164\n         5mm (milli-newton)          2\n"
      "  1.00000000000000000D+03  1.00000000000000000D+03"
      "  1.00000000000000000D+00\n  2.73149999999999977D+02\n    -1\n";
  const std::string s = " 1.00000E+00 2.00000E+00\n";
  const auto set =
      read_frfs_uff_text(
          units +
              dataset(4,
                      5,
                      1,
                      1,
                      s,
                      "        12    0    0    0 Acceleration         NONE"),
          "x")
          .set;
  // mm/s^2 over N (labelled): 1e-3.
  EXPECT_LT(std::abs(set.frfs[0].H(0) - 1e-3 * complex(1.0, 2.0)), 1e-15);
}

TEST(Uff58, TakesLabelsOfOtherPrograms) {
  const auto value = [](const std::string& motion, const std::string& force) {
    return read_frfs_uff_text(labelled(motion, force), "x")
        .set.frfs[0]
        .H(0)
        .real();
  };
  EXPECT_DOUBLE_EQ(value("G", "N"), 9.80665);
  EXPECT_DOUBLE_EQ(value("m/sec^2", "pound"), 1.0 / 4.4482216152605);
  // The ratio as label of the numerator.
  EXPECT_DOUBLE_EQ(value("g/N", "NONE"), 9.80665);
  EXPECT_DOUBLE_EQ(value("(m/s^2)/N", "N"), 1.0);
  EXPECT_DOUBLE_EQ(value("m/s2/lbf", ""), 1.0 / 4.4482216152605);
}

// What the numbers are in is not known then, and SI would be a guess.
TEST(Uff58, LeavesOutFrfsInUnknownUnits) {
  const std::vector<std::pair<std::string, std::string>> labels{{"mV", "N"},
                                                                {"V", "V"},
                                                                {"g rms", "N"},
                                                                {"m/s^2", "Pa"},
                                                                {"N", "N"},
                                                                {"g/N", "lbf"}};
  for (const auto& [motion, force] : labels) {
    const UffFrfs result = read_frfs_uff_text(
        labelled(motion, force) + labelled("m/s^2", "N"), "x.uff");
    ASSERT_EQ(result.set.frfs.size(), 1u) << motion << " " << force;
    EXPECT_EQ(result.set.frfs[0].H(0), complex(1.0, 0.0));
    ASSERT_EQ(result.set.statements.size(), 1u) << motion;
    const std::string& said = result.set.statements[0];
    const bool by_motion = motion != "m/s^2";
    for (const std::string& part :
         {std::string("x.uff, line 2"),
          fmt::format("\"{}\" is no known unit of {}; known are",
                      by_motion ? motion : force,
                      by_motion ? "acceleration" : "force")}) {
      EXPECT_THAT(said, HasSubstr(part));
    }
    EXPECT_THROW((void)read_frfs_uff_text(labelled(motion, force), "x"),
                 InputError);
  }
}

TEST(Uff58, NamesTheFirstOfManyFrfsLeftOut) {
  std::string text = labelled("m/s^2", "N");
  for (int i = 0; i < 20; ++i) text += labelled("V", "N");
  const UffFrfs result = read_frfs_uff_text(text, "x.uff");
  EXPECT_EQ(result.skipped.size(), 20u);
  ASSERT_EQ(result.set.statements.size(), 5u);
  EXPECT_EQ(result.set.statements.back(), "16 more FRFs are left out");
}

TEST(Uff58, ReadsBinaryOfEitherByteOrder) {
  for (const bool big : {false, true}) {
    std::string bytes;
    for (const double value : {1.5, -2.5, 3.25, 1e-7}) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      for (int i = 0; i < 8; ++i)
        bytes += static_cast<char>(bits >> (8 * (big ? 7 - i : i)) & 0xff);
    }
    const std::string tag = fmt::format(
        "    58b{:6}{:6}{:12}{:12}     0     0           0           0",
        big ? 2 : 1,
        2,
        11,
        bytes.size());
    // With and without a line end before the fence.
    for (const std::string end : {"", "\r\n"}) {
      const auto set =
          read_frfs_uff_text(
              dataset(
                  4, 6, 2, 1, bytes + end, "        12    0    0    0 A", tag),
              "x")
              .set;
      EXPECT_EQ(set.frfs[0].H(0), complex(1.5, -2.5));
      EXPECT_EQ(set.frfs[0].H(1), complex(3.25, 1e-7));
    }
  }
}

TEST(Uff58, TakesCoherenceAndNamesTheRest) {
  const std::string text =
      dataset(4, 5, 2, 1, " 1. 2. 3. 4.\n") +
      dataset(6, 2, 2, 1, " 0.5 0.75\n") + dataset(1, 2, 2, 1, " 1. 2.\n") +
      "    -1\n    82\n         1\n    -1\n" + dataset(4, 5, 1, 1, " 1. 2.\n");
  const UffFrfs result = read_frfs_uff_text(text, "x.uff");
  ASSERT_EQ(result.set.frfs.size(), 1u);
  EXPECT_EQ(result.set.frfs[0].coherence(1), 0.75);
  ASSERT_EQ(result.skipped.size(), 3u);
  EXPECT_THAT(result.skipped[0], HasSubstr("function type 1"));
  EXPECT_THAT(result.skipped[1], HasSubstr("dataset 82"));
  EXPECT_THAT(result.skipped[2], HasSubstr("lines differ"));
}

// Response 12 and reference 3 along Z of a node's displacement system.
std::string nodes_in(int of_response, int of_reference) {
  return fmt::format(
      "    -1\n    15\n"
      "{:10}{:10}{:10}{:10}  0.00000E+00  0.00000E+00  0.00000E+00\n"
      "{:10}{:10}{:10}{:10}  1.00000E+00  0.00000E+00  0.00000E+00\n    -1\n",
      12,
      0,
      of_response,
      8,
      3,
      0,
      of_reference,
      8);
}

// Origin, a point on +x, one on the +xz plane.
std::string system_18(int label, const std::string& points) {
  return fmt::format(
      "    -1\n    18\n{:10}{:10}{:10}{:10}{:10}\nCS\n{}    -1\n",
      label,
      0,
      0,
      8,
      1,
      points);
}

TEST(Uff58, DirectionsCountAlongTheNodesSystems) {
  const std::string frf = dataset(4, 5, 2, 1, " 1. 2. 3. 4.\n") +
                          dataset(6, 2, 2, 1, " 0.5 0.75\n");
  // Its x is +Y and its z is -X of the global axes.
  const std::string along = system_18(
      2,
      "  0.00000E+00  0.00000E+00  0.00000E+00  0.00000E+00  1.00000E+00  "
      "0.00000E+00\n -1.00000E+00  0.00000E+00  0.00000E+00\n");
  const FrfSet turned =
      read_frfs_uff_text(frf + nodes_in(2, 0) + along, "x.uff").set;
  ASSERT_EQ(turned.frfs.size(), 1u);
  EXPECT_EQ(name(turned.frfs[0].response), "12X-");
  EXPECT_EQ(name(turned.frfs[0].reference), "3Z+");
  // Coherence belongs to the same, wherever the systems stand in the file.
  EXPECT_EQ(turned.frfs[0].coherence(1), 0.75);
  // Its z leans from Z towards X by 30 degrees.
  const std::string askew = system_18(
      5,
      "  0.00000E+00  0.00000E+00  0.00000E+00  8.66025E-01  0.00000E+00 "
      "-5.00000E-01\n  5.00000E-01  0.00000E+00  8.66025E-01\n");
  const FrfSet own =
      read_frfs_uff_text(nodes_in(0, 5) + askew + frf, "x.uff").set;
  EXPECT_EQ(name(own.frfs[0].response), "12Z+");
  EXPECT_EQ(name(own.frfs[0].reference), "P3Z+");
  // Never read as a global direction.
  EXPECT_THROW(static_cast<void>(
                   read_frfs_uff_text(nodes_in(0, 7) + askew + frf, "x.uff")),
               InputError);
}

TEST(Uff58, DropsLinesThatAreNoNumbers) {
  const UffFrfs result =
      read_frfs_uff_text(dataset(4, 5, 2, 1, " NaN NaN 3. 4.\n"), "x");
  ASSERT_EQ(result.set.lines(), 1);
  EXPECT_EQ(result.set.frfs[0].H(0), complex(3.0, 4.0));
  ASSERT_EQ(result.skipped.size(), 1u);
  // Whoever sees the FRFs only is told, too.
  EXPECT_EQ(result.set.statements, result.skipped);
  EXPECT_THAT(result.skipped[0], HasSubstr("1 line is left out of all FRFs"));
  EXPECT_THAT(result.skipped[0], HasSubstr("1 of " + name(result.set.frfs[0])));
}

// One dead FRF costs itself, not the lines of all others.
TEST(Uff58, LeavesOutAnFrfThatHoldsNoNumbers) {
  FrfSet set = some_set(0.0);
  set.frfs[1].H.head(6).setConstant(std::nan(""));
  const UffFrfs result = read_frfs_uff_text(written(set), "x");
  ASSERT_EQ(result.set.frfs.size(), 1u);
  EXPECT_EQ(result.set.lines(), 7);
  ASSERT_EQ(result.skipped.size(), 1u);
  EXPECT_THAT(result.skipped[0], HasSubstr("6 of its 7 values are not finite"));
}

TEST(Uff58, LeavesOutAnFrfWithAHole) {
  FrfSet set = some_set(0.0);
  set.frfs.resize(2);
  set.frfs[0].H(0) = std::nan("");  // at the end of the band: of all FRFs
  set.frfs[1].H(3) = std::nan("");
  const UffFrfs result = read_frfs_uff_text(written(set), "x");
  ASSERT_EQ(result.set.frfs.size(), 1u);
  EXPECT_EQ(result.set.lines(), 6);
  ASSERT_EQ(result.skipped.size(), 2u);
  EXPECT_THAT(result.skipped[0], HasSubstr("is no number"));
}

TEST(Uff58, RefusesWhatIsBrokenWithItsPlace) {
  const auto refuse = [](const std::string& text, const char* part) {
    EXPECT_THAT([&] { (void)read_frfs_uff_text(text, "x.uff"); }, Refuses(part))
        << "accepted: " << part;
  };
  refuse("", "no FRF");
  refuse(dataset(1, 2, 2, 1, " 1. 2.\n"), "function type 1");
  refuse(dataset(4, 5, 2, 1, " 1. 2. 3.\n"), "3 of 4");
  refuse(dataset(4, 5, 2, 1, " 1. 2. 3. four\n"), "data line 1");
  refuse(dataset(4, 5, 2000000000, 1, " 1. 2. 3. 4.\n"),
         "2000000000 values are announced");
  refuse(dataset(4, 3, 2, 1, " 1. 2. 3. 4.\n"), "data type 3");
  refuse("    -1\n    58\nFRF\n    -1\n", "no FRF");
  refuse(dataset(4,
                 5,
                 2,
                 1,
                 "12",
                 "        12    0    0    0 A",
                 "    58b     1     2          11        4000"),
         "cut off");
  // Found by mutation: the header ends with the file, no byte announced.
  refuse("    -1\n    58b     1     2           1           0\nFRF", "no FRF");
  EXPECT_THROW((void)read_frfs_uff("/nowhere/at-all.uff"), InputError);
}

}  // namespace
}  // namespace tapfit::signal
