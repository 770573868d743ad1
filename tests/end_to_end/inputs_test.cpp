// What the program reads: regular files of a bounded size, nothing of a file
// that is not what its place asks for, and with --inside nothing from
// elsewhere.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <sys/stat.h>
#include <vector>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path recordings = TAPFIT_SOURCE_DIR "/recordings";

/// Within so much time and memory that neither is used up.
ProgramResult run_bounded(const std::string& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  ProgramResult result = run_tapfit(arguments);
  const std::chrono::duration<double> took =
      std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count(), 20.0) << arguments;
  return result;
}

class Inputs : public testing::Test {
 protected:
  void SetUp() override {
    bundle_ = fresh_folder() / "truss";
    fs::remove_all(bundle_);
    fs::copy(recordings / "paper-truss", bundle_);
  }
  [[nodiscard]] std::string at(const std::string& name) const {
    return "'" + (bundle_ / name).string() + "'";
  }
  void put_in_test(const std::function<void(json&)>& change) const {
    json test = json::parse(read_file(bundle_ / "test.json"));
    change(test);
    write_file(bundle_ / "test.json", test.dump(1));
  }

  fs::path bundle_;
};

struct Special {
  const char* kind;
  std::function<void(const fs::path&)> make;
};

std::vector<Special> specials() {
  return {{"a device",
           [](const fs::path& p) { fs::create_symlink("/dev/zero", p); }},
          {"a pipe",
           [](const fs::path& p) { ASSERT_EQ(mkfifo(p.c_str(), 0600), 0); }},
          {"a folder", [](const fs::path& p) { fs::create_directory(p); }}};
}

TEST_F(Inputs, ThatAreNoRegularFilesAreRefusedAtOnce) {
  struct Place {
    const char* file;     // of the bundle
    std::string command;  // %b: the bundle
  };
  for (const Place& place :
       {Place{"test.json", "hits " + at("")},
        Place{"test.json", "hits " + at("test.json")},
        Place{"session.json", "update " + at("") + " --session"},
        Place{"model.bdf", "model " + at("model.bdf")},
        Place{"model.bdf", "compare " + at("")},
        Place{"part.bdf", "model " + at("asks.bdf")},
        Place{"modes.uff", "mac " + at("modes.uff")},
        Place{"modes.json", "mac " + at("modes.json")},
        Place{"measured.uff", "frf " + at("")},
        Place{"measured.uff", "uff " + at("measured.uff")},
        Place{"keys", at("") + " --keys " + at("keys")},
        Place{"part.json", "score --merge " + at("part.json")},
        Place{"acc.mat", "import " + at("acc.mat") + " -o " + at("acc")},
        Place{"K.mtx", "model " + at("") + " --modes 1"}}) {
    for (const Special& special : specials()) {
      SetUp();
      write_file(bundle_ / "asks.bdf", "INCLUDE 'part.bdf'\n");
      if (std::string(place.file) == "K.mtx") {
        put_in_test([](json& test) {
          test["model"] = {
              {"stiffness", "K.mtx"}, {"mass", "K.mtx"}, {"dofs", "K.mtx"}};
        });
      }
      fs::remove(bundle_ / place.file);
      special.make(bundle_ / place.file);
      const ProgramResult result = run_bounded(place.command);
      EXPECT_EQ(result.exit_status, 1) << place.command << special.kind;
      EXPECT_EQ(result.out, "") << place.command << special.kind;
      EXPECT_FALSE(holds(result.err, "own fault")) << result.err;
      EXPECT_TRUE(holds(result.err, place.file)) << result.err;
    }
  }
}

// 12 files of 10 INCLUDEs each ask for 10^12 files.
TEST_F(Inputs, IncludesThatMultiplyEndAtALimit) {
  for (int k = 0; k < 12; ++k) {
    std::string cards;
    for (int i = 0; i < 10; ++i)
      cards += fmt::format("INCLUDE 'f{}.bdf'\n", k + 1);
    write_file(bundle_ / fmt::format("f{}.bdf", k), cards);
  }
  write_file(bundle_ / "f12.bdf", "GRID,1,,0.,0.,0.\n");
  const ProgramResult result = run_bounded("model " + at("f0.bdf"));
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_TRUE(holds(result.err, "more than 1000 INCLUDE")) << result.err;
}

TEST_F(Inputs, FilesBeyondTheirSizeAreRefused) {
  for (const char* file : {"test.json", "model.bdf"}) {
    SetUp();
    fs::resize_file(bundle_ / file, std::uintmax_t{1} << 40U);  // sparse
    for (const char* command : {"compare", "model", "run"}) {
      const ProgramResult result = run_bounded(command + (" " + at("")));
      EXPECT_EQ(result.exit_status, 1) << file << command;
      EXPECT_TRUE(holds(result.err, "the most that is read")) << result.err;
    }
  }
  const fs::path deck = bundle_ / "alone.inp";
  write_file(deck, "*NODE\n");
  fs::resize_file(deck, std::uintmax_t{1} << 40U);
  const ProgramResult result = run_bounded("model " + at("alone.inp"));
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_TRUE(holds(result.err, "the most that is read")) << result.err;
}

// Bytes that a terminal obeys, that turn the direction of writing and that are
// no UTF-8, in the folder's own name.
TEST_F(Inputs, OfAnyNameAreToldInPlainText) {
  const fs::path odd =
      bundle_.parent_path() / fs::path("a\x1b[31m\x07\nb\u202e\xff\"<b>&");
  fs::remove_all(odd);
  fs::rename(bundle_, odd);
  const fs::path report = odd / "r.html";
  const std::string where = "'" + odd.string() + "'";
  for (const std::string& command :
       {"update " + where + " --json",
        "predict " + where + " --effect added-mass@3=1kg --json",
        "report " + where + " -o '" + report.string() + "'",
        "report " + where + " -o '" + (odd / "r.md").string() + "'",
        "session " + where}) {
    const ProgramResult result = run_bounded(command);
    const bool no_session = command.starts_with("session");
    EXPECT_EQ(result.exit_status, no_session ? 1 : 0) << result.err;
    if (command.ends_with("--json")) {
      EXPECT_TRUE(json::accept(result.out)) << result.out;
    }
    std::string told = result.out + result.err;
    if (command.starts_with("report")) {
      told += read_file(command.ends_with("md'") ? odd / "r.md" : report);
    }
    for (const char* never : {"\x1b", "\x07", "\u202e", "b\xff"}) {
      EXPECT_FALSE(holds(told, never)) << command;
    }
  }
}

// A bundle from a stranger names a file of the reader's.
TEST_F(Inputs, OfAnotherKindAreNotQuoted) {
  const fs::path secret = bundle_.parent_path() / "secret";
  write_file(secret,
             "root:x:0:0:root:/root:/bin/bash\n"
             "alice:$6$hunter2$Zq:19000:0:99999:7:::\n"
             "password = hunter2\n"
             "hunter2,hunter2,hunter2\n"
             "  hunter2 hunter2\n");
  const auto untold = [&](const std::string& command) {
    const ProgramResult result = run_bounded(command);
    EXPECT_EQ(result.exit_status, 1) << command;
    for (const char* word : {"hunter2", "HUNTER2", "root:", "ROOT:", "alice"}) {
      EXPECT_FALSE(holds(result.err + result.out, word)) << command << "\n"
                                                         << result.err;
    }
  };
  for (const char* key : {"model", "frfs"}) {
    SetUp();
    put_in_test([&](json& test) { test[key] = "../secret"; });
    untold("compare " + at(""));
  }
  for (const char* key : {"stiffness", "mass", "dofs"}) {
    SetUp();
    put_in_test([&](json& test) {
      test["model"] = {
          {"stiffness", "K.mtx"}, {"mass", "K.mtx"}, {"dofs", "d.csv"}};
      test["model"][key] = "../secret";
    });
    write_file(
        bundle_ / "K.mtx",
        "%%MatrixMarket matrix coordinate real symmetric\n1 1 1\n1 1 1.0\n");
    write_file(bundle_ / "d.csv", "1,3\n");
    untold("compare " + at(""));
  }
  SetUp();
  std::string deck = read_file(recordings / "paper-truss" / "model.bdf");
  deck.insert(0, "INCLUDE '../secret'\n");
  write_file(bundle_ / "model.bdf", deck);
  untold("compare " + at(""));
  untold("model " + at("model.bdf"));
  fs::remove(bundle_ / "test.json");
  fs::create_symlink(secret, bundle_ / "test.json");
  untold("hits " + at(""));
  untold("hits '" + secret.string() + "'");
  untold("mac '" + secret.string() + "'");
  untold("uff '" + secret.string() + "'");
  untold("model '" + secret.string() + "'");
  SetUp();
  fs::create_symlink(secret, bundle_ / "session.json");
  untold("session " + at(""));
}

TEST_F(Inputs, FromElsewhereAreListedAndRefusedOnDemand) {
  const fs::path elsewhere = bundle_.parent_path() / "elsewhere.bdf";
  fs::rename(bundle_ / "model.bdf", elsewhere);
  put_in_test([](json& test) { test["model"] = "../elsewhere.bdf"; });
  const ProgramResult told = run_tapfit("frf " + at(""));
  EXPECT_EQ(told.exit_status, 0) << told.err;
  EXPECT_TRUE(holds(told.err, "outside its folder")) << told.err;
  EXPECT_TRUE(holds(told.err, elsewhere.string())) << told.err;
  const ProgramResult refused = run_tapfit("frf " + at("") + " --inside");
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(holds(refused.err, elsewhere.string())) << refused.err;
  // A link counts as what it leads to, and so does an INCLUDE.
  fs::create_symlink(elsewhere, bundle_ / "model.bdf");
  put_in_test([](json& test) { test["model"] = "model.bdf"; });
  EXPECT_EQ(run_tapfit("frf " + at("") + " --inside").exit_status, 1);
  fs::remove(bundle_ / "model.bdf");
  write_file(bundle_ / "model.bdf", "INCLUDE '../elsewhere.bdf'\n");
  EXPECT_EQ(run_tapfit("frf " + at("") + " --inside").exit_status, 1);
  EXPECT_EQ(run_tapfit("model " + at("model.bdf") + " --inside").exit_status,
            1);
  EXPECT_EQ(run_tapfit("model " + at("model.bdf")).exit_status, 0);
  // All of it in the folder.
  fs::copy_file(elsewhere, bundle_ / "part.bdf");
  write_file(bundle_ / "model.bdf", "INCLUDE 'part.bdf'\n");
  const ProgramResult fine = run_tapfit("frf " + at("") + " --inside");
  EXPECT_EQ(fine.exit_status, 0) << fine.err;
  EXPECT_FALSE(holds(fine.err, "outside")) << fine.err;
}

}  // namespace
}  // namespace tapfit::end_to_end
