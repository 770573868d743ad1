#include "updating/virtual_test/truth_seal.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A sealed folder with two files.
class TruthSeal : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write(folder_ / "test.json", "{}");
    write(folder_ / "run-01.flac", "samples");
    write(seal(), sealed_text(truth_, folder_));
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path seal() const { return folder_ / seal_file; }

  void expect_error(const std::string& what, const std::string& remedy) {
    try {
      (void)open_seal(folder_);
      FAIL() << "it was opened";
    } catch (const InputError& error) {
      EXPECT_NE(error.fault().find(what), std::string::npos) << error.what();
      EXPECT_EQ(error.where(), seal().string());
      EXPECT_NE(error.remedy().find(remedy), std::string::npos);
    }
  }

  json truth_{{"effect", "added-mass"}, {"hidden", {"added-mass@30=0.05"}}};
  fs::path folder_ =
      fs::path(::testing::TempDir()) /
      (std::string("tapfit-seal-") +
       ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(TruthSeal, GivesTheTruthBack) { EXPECT_EQ(open_seal(folder_), truth_); }

TEST_F(TruthSeal, IsNotReadByAccident) {
  const std::string text = read(seal());
  EXPECT_EQ(text.find("mass"), std::string::npos);
  EXPECT_EQ(text.find("0.05"), std::string::npos);
}

TEST_F(TruthSeal, MissingIsSaid) {
  fs::remove(seal());
  expect_error("no seal", "tapfit challenge");
}

TEST_F(TruthSeal, DamageIsSaid) {
  const std::string whole = read(seal());
  const json good = json::parse(whole);
  json turned = good;
  std::string packed = turned["truth"];
  packed[4] = packed[4] == '0' ? '1' : '0';
  turned["truth"] = packed;
  json listed = good;
  listed["files"]["test.json"] = "0123456789abcdef";
  json other_type = good;
  other_type["tapfit_seal"] = "one";
  json no_digits = good;
  no_digits["truth"] = "xyz0";
  for (const std::string& text : {whole.substr(0, whole.size() / 2),
                                  std::string(),
                                  std::string("[]"),
                                  turned.dump(),
                                  listed.dump(),
                                  other_type.dump(),
                                  no_digits.dump()}) {
    write(seal(), text);
    expect_error("the seal is damaged", "the same seed");
  }
}

TEST_F(TruthSeal, OfAnotherTestIsSaid) {
  write(folder_ / "run-01.flac", "other samples");
  expect_error("another test: run-01.flac is not", "new folder");
  fs::remove(folder_ / "run-01.flac");
  expect_error("another test: run-01.flac is missing", "new folder");
  // What came beside it, a saved session, is no matter.
  write(folder_ / "run-01.flac", "samples");
  write(folder_ / "session.json", "{}");
  EXPECT_EQ(open_seal(folder_), truth_);
}

}  // namespace
}  // namespace tapfit::updating
