#include "tui/report/frf_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>

namespace tapfit::tui {
namespace {

signal::FrfSet sample_frfs() {
  signal::Frf frf;
  frf.response = {.node = 12, .component = 3, .sign = 1};
  frf.reference = {.node = 3, .component = 3, .sign = 1};
  frf.H = Eigen::VectorXcd::Constant(3, {3.0, 4.0});
  frf.coherence = Eigen::Vector3d(1.0, 0.9, 0.8);
  frf.variance = Eigen::Vector3d(0.0025, 0.01, 1.0);
  frf.hits = 2;
  signal::FrfSet set;
  set.s.resize(3);
  for (Eigen::Index k = 0; k < 3; ++k) {
    set.s(k) = {0.5, 2.0 * std::numbers::pi * static_cast<double>(k + 1)};
  }
  set.frfs = {frf};
  return set;
}

TEST(FrfText, MedianSdIsThatOfTheMiddleLine) {
  // sd / |H|: 0.05/5, 0.1/5, 1/5; the middle one is 2 %.
  EXPECT_DOUBLE_EQ(median_sd_percent(sample_frfs().frfs[0]), 2.0);
}

TEST(FrfText, MedianSdOfAnEmptyFrfIsZeroNotNaN) {
  EXPECT_EQ(median_sd_percent(signal::Frf{}), 0.0);
}

TEST(FrfText, JsonHasThePromisedFields) {
  const auto frf = frf_json(sample_frfs()).at("frfs").at(0);
  EXPECT_EQ(frf.at("response"), "12Z+");
  EXPECT_EQ(frf.at("reference"), "3Z+");
  EXPECT_EQ(frf.at("type"), "accelerance");
  EXPECT_EQ(frf.at("lines"), 3);
  EXPECT_NEAR(frf.at("mean_coherence").get<double>(), 0.9, 1e-15);
  EXPECT_DOUBLE_EQ(frf.at("median_sd_percent").get<double>(), 2.0);
}

TEST(FrfText, JsonIsNullWhereNothingWasMeasured) {
  signal::FrfSet set = sample_frfs();
  set.frfs[0].hits = 0;
  set.frfs[0].coherence.setOnes();
  set.frfs[0].variance.setZero();
  const auto frf = frf_json(set).at("frfs").at(0);
  EXPECT_TRUE(frf.at("mean_coherence").is_null());
  EXPECT_TRUE(frf.at("median_sd_percent").is_null());
}

TEST(FrfText, TextGivesLinesBandAndWindow) {
  const std::string text = frf_text(sample_frfs());
  EXPECT_NE(text.find("3 lines, 1 to 3 Hz"), std::string::npos) << text;
  EXPECT_NE(text.find("window 0.5 1/s"), std::string::npos) << text;
  EXPECT_NE(text.find("12Z+ / 3Z+"), std::string::npos) << text;
}

// One hit agrees with itself: the coherence is 1 by its definition.
TEST(FrfText, TextShowsNoCoherenceOfASingleHit) {
  signal::FrfSet set = sample_frfs();
  EXPECT_NE(frf_text(set).find("0.9000"), std::string::npos) << frf_text(set);
  set.frfs[0].coherence.setOnes();
  set.frfs[0].hits = 1;
  const std::string text = frf_text(set);
  EXPECT_EQ(text.find("1.0000"), std::string::npos) << text;
  EXPECT_NE(text.find(" – "), std::string::npos) << text;
}

// Of ready FRFs a file may give all of it, or nothing.
TEST(FrfText, ShowsOfReadyFrfsWhatWasMeasured) {
  signal::FrfSet set = sample_frfs();
  signal::Frf& frf = set.frfs[0];
  frf.hits = 0;
  EXPECT_NE(frf_text(set).find("–     0.9000      2.0 %"), std::string::npos)
      << frf_text(set);
  frf.coherence.setOnes();
  frf.variance.setZero();
  EXPECT_NE(frf_text(set).find("–          –          –"), std::string::npos)
      << frf_text(set);
}

}  // namespace
}  // namespace tapfit::tui
