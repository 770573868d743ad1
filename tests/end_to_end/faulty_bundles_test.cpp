// One fault at a time in what a bundle consists of, and what its user is told.
// The table in docs/faulty-tests.md promises these words.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <functional>
#include <ostream>
#include <sys/stat.h>
#include <vector>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Fault {
  const char* name;
  const char* words;  // on standard error
  const char* command;
  std::function<void(const fs::path& bundle)> make;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

/// A small test with recordings and a deck; made once.
const fs::path& sound_bundle() {
  static const fs::path bundle = [] {
    const fs::path folder = scratch_folder("sound") / "test";
    const auto made = run_tapfit(
        fmt::format("simulate '{}' --structure ladder --seed 5 --runs 2 "
                    "--hits 1",
                    folder.string()));
    EXPECT_EQ(made.exit_status, 0) << made.err;
    return folder;
  }();
  return bundle;
}

std::function<void(const fs::path&)> sheet(std::function<void(json&)> change) {
  return [change = std::move(change)](const fs::path& bundle) {
    json test = json::parse(read_file(bundle / "test.json"));
    change(test);
    write_file(bundle / "test.json", test.dump(1));
  };
}

std::function<void(const fs::path&)> deck(
    std::function<std::string(std::string)> change) {
  return [change = std::move(change)](const fs::path& bundle) {
    const fs::path file = bundle / "model.bdf";
    write_file(file, change(read_file(file)));
  };
}

// A line before the first card that follows BEGIN BULK, or at the top.
std::string with_card(std::string cards, const std::string& card) {
  const std::size_t begin = cards.find("BEGIN BULK");
  const std::size_t at =
      begin == std::string::npos ? 0 : cards.find('\n', begin) + 1;
  return cards.insert(at, card + "\n");
}

std::function<void(const fs::path&)> card(const std::string& text) {
  return deck([text](std::string cards) { return with_card(cards, text); });
}

fs::path first_recording(const fs::path& bundle) {
  const json test = json::parse(read_file(bundle / "test.json"));
  return bundle / test["runs"][0]["file"].get<std::string>();
}

std::vector<Fault> faults_of_the_sheet() {
  return {
      {"no test.json",
       "cannot be opened",
       "hits",
       [](const fs::path& b) { fs::remove(b / "test.json"); }},
      {"test.json is a folder",
       "cannot be read|is a folder",
       "hits",
       [](const fs::path& b) {
         fs::remove(b / "test.json");
         fs::create_directory(b / "test.json");
       }},
      {"test.json is a pipe",
       "is a pipe",
       "hits",
       [](const fs::path& b) {
         fs::remove(b / "test.json");
         ASSERT_EQ(mkfifo((b / "test.json").c_str(), 0600), 0);
       }},
      {"test.json is a device",
       "is a device",
       "hits",
       [](const fs::path& b) {
         fs::remove(b / "test.json");
         fs::create_symlink("/dev/zero", b / "test.json");
       }},
      {"test.json cut off",
       "missing comma, quote or bracket",
       "hits",
       [](const fs::path& b) {
         const std::string text = read_file(b / "test.json");
         write_file(b / "test.json", text.substr(0, text.size() / 2));
       }},
      {"test.json not in UTF-8",
       "save the file as UTF-8",
       "hits",
       [](const fs::path& b) {
         write_file(b / "test.json",
                    "{\"title\": \"Pr\xfc"
                    "fstand\"}");
       }},
      {"runs and frfs", "only one of runs, frfs", "hits", sheet([](json& t) {
         t["frfs"] = "x.uff";
       })},
      {"runs without channels", "no channels", "hits", sheet([](json& t) {
         t.erase("channels");
       })},
      {"channel that is not listed",
       "no channel is called",
       "hits",
       sheet([](json& t) { t["runs"][0]["sensors"][0]["channel"] = "acc9"; })},
      {"channel listed twice", "was there before", "hits", sheet([](json& t) {
         t["channels"].push_back(t["channels"][0]);
       })},
      {"channel placed twice in a run",
       "has a place in this run already",
       "hits",
       sheet([](json& t) {
         t["runs"][0]["sensors"].push_back(t["runs"][0]["sensors"][0]);
       })},
      {"sensitivity of 0", "the sensitivity is 0", "hits", sheet([](json& t) {
         t["channels"][1]["sensitivity"] = 0;
       })},
      {"sensitivity of no sensor",
       "which no sensor has",
       "hits",
       sheet([](json& t) { t["channels"][0]["sensitivity"] = 1e-308; })},
      {"sensor of a thousand tonnes",
       "100 the most",
       "hits",
       sheet([](json& t) { t["channels"][1]["mass_kg"] = 1e6; })},
      {"control character in a name",
       "holds a control character",
       "hits",
       sheet([](json& t) { t["channels"][1]["name"] = "acc1\x1b[31m"; })},
      {"unit that is none", "is no known unit of", "hits", sheet([](json& t) {
         t["channels"][1]["unit"] = "furlong";
       })},
      {"unit of another quantity",
       "is no known unit of",
       "hits",
       sheet([](json& t) { t["channels"][1]["unit"] = "N"; })},
      {"sensitivity per another quantity",
       "is no voltage per unit of",
       "hits",
       sheet([](json& t) { t["channels"][1]["sensitivity_unit"] = "V/N"; })},
      {"hammer on a sensor's channel",
       "does not measure force",
       "hits",
       sheet([](json& t) {
         t["runs"][0]["hammer"]["channel"] = t["channels"][1]["name"];
       })},
      {"band the wrong way round", "is no band", "hits", sheet([](json& t) {
         t["band_hz"] = {50.0, 5.0};
       })},
      {"band above half the sampling rate",
       "holds only frequencies below",
       "hits",
       sheet([](json& t) {
         t["band_hz"] = {5.0, 1e5};
       })},
      {"block of a day", "is too long", "hits", sheet([](json& t) {
         t["block_s"] = 86400;
       })},
      {"pre-trigger as long as the block",
       "leaves nothing of a block",
       "hits",
       sheet([](json& t) {
         t["block_s"] = 1.0;
         t["pre_trigger_s"] = 1.0;
       })},
      {"grid that the deck does not have",
       "99999",
       "compare",
       sheet([](json& t) { t["runs"][0]["sensors"][0]["node"] = 99999; })},
  };
}

std::vector<Fault> faults_of_files() {
  return {
      {"recording missing",
       "there is no file",
       "hits",
       [](const fs::path& b) { fs::remove(first_recording(b)); }},
      {"recording is a folder",
       "is a folder",
       "hits",
       [](const fs::path& b) {
         const fs::path file = first_recording(b);
         fs::remove(file);
         fs::create_directory(file);
       }},
      {"recording is text",
       "cannot be read as a sound file",
       "hits",
       [](const fs::path& b) { write_file(first_recording(b), "no sound"); }},
      {"recording cut off",
       "ends early",
       "hits",
       [](const fs::path& b) {
         const fs::path file = first_recording(b);
         fs::resize_file(file, fs::file_size(file) / 2);
       }},
      {"fewer channels listed than recorded",
       "test.json lists",
       "hits",
       sheet([](json& t) {
         t["channels"].push_back(t["channels"][1]);
         t["channels"].back()["name"] = "another";
       })},
      {"model missing",
       "there is no file",
       "compare",
       [](const fs::path& b) { fs::remove(b / "model.bdf"); }},
      {"model is another file",
       "is no Nastran bulk data",
       "compare",
       sheet([](json& t) { t["model"] = "test.json"; })},
      {"INCLUDE of a missing file",
       "cannot open the model",
       "compare",
       card("INCLUDE 'nowhere.bdf'")},
      {"INCLUDE of itself",
       "include each other without end",
       "compare",
       card("INCLUDE 'model.bdf'")},
      {"INCLUDE of another file",
       "is no Nastran bulk data",
       "compare",
       card("INCLUDE 'test.json'")},
      {"INCLUDE of a folder", "is a folder", "compare", card("INCLUDE '.'")},
      {"INCLUDEs that multiply",
       "more than 1000 INCLUDE files",
       "compare",
       [](const fs::path& b) {
         std::string twice;
         for (int k = 0; k < 12; ++k) {
           twice = fmt::format("INCLUDE 'part{0}.bdf'\nINCLUDE 'part{0}.bdf'\n",
                               k + 1);
           write_file(b / fmt::format("part{}.bdf", k), twice);
         }
         write_file(b / "part12.bdf", "$\n");
         card("INCLUDE 'part0.bdf'")(b);
       }},
      {"element without its property",
       "77777",
       "compare",
       card("CBAR,99991,77777,1,2,0.,0.,1.")},
      {"element of a kind that is not read",
       "is not supported",
       "compare",
       card("CFOO,99992,1,1,2")},
      {"modulus of no structure",
       "of no structure in any units",
       "compare",
       card("MAT1,99993,1.-300,,.3,2700.")},
      {"density of no structure",
       "of no structure in any units",
       "compare",
       card("MAT1,99993,7.+10,,.3,1.+38")},
      {"area of no structure",
       "of no structure in any units",
       "compare",
       card("PBAR,99994,1,1.+38,1.-8,1.-8,2.-8")},
      {"WTMASS of no units",
       "of no structure in any units",
       "compare",
       card("PARAM,WTMASS,1.+38")},
      {"number that is none",
       "model.bdf",
       "compare",
       card("GRID,99995,,0.0x,0.,0.")},
      {"session.json is another file",
       "session.json",
       "update --session",
       [](const fs::path& b) { write_file(b / "session.json", "[1, 2]"); }},
  };
}

class FaultyBundle : public testing::TestWithParam<Fault> {};

TEST_P(FaultyBundle, IsToldInThePromisedWords) {
  const Fault& fault = GetParam();
  const fs::path bundle = fresh_folder() / "test";
  fs::copy(sound_bundle(), bundle);
  fault.make(bundle);
  const std::string command = fault.command;
  const std::size_t space = command.find(' ');
  const ProgramResult result = run_tapfit(
      fmt::format("{} '{}'{}",
                  command.substr(0, space),
                  bundle.string(),
                  space == std::string::npos ? "" : command.substr(space)));
  EXPECT_EQ(result.exit_status, 1) << result.err;
  EXPECT_EQ(result.out, "");
  std::string words = fault.words;
  bool said = false;
  while (!words.empty()) {
    const std::size_t bar = std::min(words.find('|'), words.size());
    said = said || holds(result.err, words.substr(0, bar));
    words.erase(0, bar + 1);
  }
  EXPECT_TRUE(said) << fault.words << "\n" << result.err;
  static const std::string page =
      read_file(TAPFIT_SOURCE_DIR "/docs/faulty-tests.md");
  std::string promised = fault.words;
  for (std::size_t at = 0; (at = promised.find('|', at)) != std::string::npos;
       at += 4) {
    promised.replace(at, 1, " or ");
  }
  EXPECT_TRUE(holds(page, fmt::format("| {} | {} |", fault.name, promised)))
      << fault.name;
}

std::string test_name(const testing::TestParamInfo<Fault>& info) {
  std::string name;
  for (const char c : std::string(info.param.name)) {
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Sheet,
                         FaultyBundle,
                         testing::ValuesIn(faults_of_the_sheet()),
                         test_name);
INSTANTIATE_TEST_SUITE_P(File,
                         FaultyBundle,
                         testing::ValuesIn(faults_of_files()),
                         test_name);

}  // namespace
}  // namespace tapfit::end_to_end
