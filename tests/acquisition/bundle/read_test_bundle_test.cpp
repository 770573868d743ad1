#include "acquisition/bundle/read_test_bundle.hpp"

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <nlohmann/json.hpp>

namespace tapfit::acquisition {
namespace {

using nlohmann::json;

json good() {
  return json::parse(R"json({
    "tapfit": 1, "title": "A plate", "model": "model.bdf",
    "channels": [
      {"name": "hammer", "quantity": "force", "unit": "N",
       "sensitivity": 2.0, "sensitivity_unit": "mV/N",
       "full_scale_volts": 5.0},
      {"name": "acc1", "quantity": "acceleration", "unit": "g",
       "sensitivity": 0.01, "sensitivity_unit": "V/(m/s^2)",
       "full_scale_volts": 5.0, "mass_kg": 0.02}],
    "runs": [{"file": "run.wav",
      "hammer": {"channel": "hammer", "node": 3, "direction": "+Z"},
      "sensors": [{"channel": "acc1", "point": "1:-X"}]}],
    "band_hz": [0.5, 30.0],
    "uncertain": [{"material": 1, "property": "E", "sd_percent": 4.0},
                  {"element_property": 7, "property": "t"}]
})json");
}

class Bundle : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("model.bdf", "");
    folder_.write("run.wav", "");
  }
  TestBundle read(const json& document) {
    folder_.write("test.json", document.dump());
    return read_test_bundle(folder_.path());
  }
  // The error must name the place and say what to try.
  void refuses(const json& document, const std::string& where) {
    try {
      read(document);
      ADD_FAILURE() << "accepted, expected a refusal at " << where;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), where) << error.what();
      EXPECT_GT(error.remedy().size(), 10U) << error.what();
    }
  }
  testing::TemporaryFolder folder_;
};

// Four samples of 8 bits, mu-law: every command begins with the bundle.
TEST_F(Bundle, ARecordingWithLossIsWarnedOf) {
  folder_.write("run.wav",
                std::string("RIFF\x26\0\0\0WAVEfmt \x12\0\0\0"
                            "\x07\0\x01\0\x40\x1f\0\0\x40\x1f\0\0"
                            "\x01\0\x08\0\0\0data\x04\0\0\0\x80\x7f\xff\x12",
                            50));
  const TestBundle bundle = read(good());
  ASSERT_EQ(bundle.warnings.size(), 1U);
  EXPECT_THAT(bundle.warnings[0], HasSubstr("U-Law"));
}

TEST_F(Bundle, ReadsEveryField) {
  const TestBundle bundle = read(good());
  EXPECT_EQ(bundle.title, "A plate");
  EXPECT_EQ(bundle.deck, folder_.path() / "model.bdf");
  ASSERT_EQ(bundle.channels.size(), 2U);
  // 5 V / 2 mV/N; 5 V / 0.01 V/(m/s^2), whatever the display unit is.
  EXPECT_NEAR(bundle.channels[0].full_scale_si(), 2500.0, 1e-9);
  EXPECT_NEAR(bundle.channels[1].full_scale_si(), 500.0, 1e-9);
  EXPECT_NEAR(bundle.channels[1].sensitivity, 0.0980665, 1e-12);
  EXPECT_EQ(bundle.channels[1].mass_kg, 0.02);
  EXPECT_EQ(bundle.runs[0].hammer.dof, (Dof{3, 3, 1}));
  EXPECT_EQ(bundle.runs[0].sensors[0].dof, (Dof{1, 1, -1}));
  EXPECT_EQ((*bundle.band_hz)[1], 30.0);
  EXPECT_EQ(bundle.uncertain[0].card, "material");
  EXPECT_EQ(bundle.uncertain[1].card, "property");
  EXPECT_EQ(bundle.uncertain[1].sd_percent, 3.0);
  EXPECT_TRUE(bundle.warnings.empty());
}

TEST_F(Bundle, RefusesAPreTriggerThatFillsTheBlock) {
  json document = good();
  document["block_s"] = 2.0;
  for (const double pre : {2.0, 10.0}) {
    document["pre_trigger_s"] = pre;
    refuses(document, "test.json: pre_trigger_s");
  }
  document["pre_trigger_s"] = 0.5;
  EXPECT_EQ(read(document).pre_trigger_s, 0.5);
}

// Beyond what an index can count, too.
TEST_F(Bundle, RefusesAPreTriggerBeyondAnHour) {
  json document = good();
  for (const double pre : {3601.0, 1e38, 1e308}) {
    document["pre_trigger_s"] = pre;
    refuses(document, "test.json: pre_trigger_s");
  }
}

TEST_F(Bundle, SaysThatATextIsLatin1) {
  folder_.write("test.json",
                "{\"title\": \"Pr\xfc"
                "fling\"}");
  EXPECT_THAT([&] { (void)read_test_bundle(folder_.path()); },
              Throws<InputError>(
                  AllOf(Property(&InputError::remedy, HasSubstr("UTF-8")),
                        Property(&InputError::what, Not(HasSubstr("\xfc"))))));
}

// What a terminal takes for a command, and what turns a text around.
TEST_F(Bundle, RefusesControlCharactersInAnyText) {
  for (const char* control :
       {"\x1b[31m", "\x07", "\xc2\x9b", "\xe2\x80\xae", "\x7f"}) {
    json document = good();
    document["channels"][1]["name"] = std::string("acc1") + control;
    refuses(document, "test.json: channels[1].name");
    document = good();
    document["title"] = control;
    refuses(document, "test.json: title");
    document = good();
    document["runs"][0]["file"] = control;
    refuses(document, "test.json: runs[0].file");
    document = good();
    document[control] = 1;
    EXPECT_THROW(read(document), InputError);
  }
}

TEST_F(Bundle, TakesLineEndsForBlanks) {
  json document = good();
  document["title"] = "A plate\nof steel";
  EXPECT_EQ(read(document).title, "A plate of steel");
}

TEST_F(Bundle, AcceptsThePathOfTheFileItself) {
  read(good());
  EXPECT_EQ(read_test_bundle(folder_.path() / "test.json").runs.size(), 1U);
}

TEST_F(Bundle, WarnsOfUnknownFields) {
  json document = good();
  document["weather"] = "mild";
  document["runs"][0]["sensors"][0]["glue"] = "wax";
  const TestBundle bundle = read(document);
  ASSERT_EQ(bundle.warnings.size(), 2U);
  EXPECT_THAT(bundle.warnings[0], HasSubstr("runs[0].sensors[0].glue"));
}

TEST_F(Bundle, TakesMatricesOrNoModel) {
  json document = good();
  document.erase("model");
  EXPECT_FALSE(read(document).deck);
  for (const char* name : {"K.mtx", "M.mtx", "dofs.csv"}) {
    folder_.write(name, "");
  }
  document["model"] = {
      {"stiffness", "K.mtx"}, {"mass", "M.mtx"}, {"dofs", "dofs.csv"}};
  EXPECT_TRUE(read(document).matrices);
  document["model"].erase("mass");
  refuses(document, "test.json: model");
}

TEST_F(Bundle, TakesReadyFrfsInsteadOfRuns) {
  folder_.write("measured.uff", "");
  json document = {{"tapfit", 1}, {"frfs", "measured.uff"}};
  EXPECT_EQ(read(document).frfs, folder_.path() / "measured.uff");
  document.erase("frfs");
  refuses(document, "test.json: runs");
}

TEST_F(Bundle, NamesLineAndColumnOfASyntaxError) {
  folder_.write("test.json", "{\n  \"tapfit\": 1,\n  \"title\" \"x\"\n}");
  EXPECT_THAT(
      [&] { (void)read_test_bundle(folder_.path()); },
      Throws<InputError>(Property(&InputError::where, "test.json:3:13")));
}

TEST_F(Bundle, RefusesAForeignFileByWhatItIs) {
  for (const char* text :
       {"Meeting at ten\n", "RIFFxxxxWAVE", "[1, 2]", "0;1"}) {
    const auto file = folder_.write("notes.txt", text);
    EXPECT_THAT([&] { (void)read_test_bundle(file); },
                Throws<InputError>(AllOf(
                    Property(&InputError::where, file.string()),
                    Property(&InputError::what, HasSubstr("not a test bundle")),
                    Property(&InputError::remedy, HasSubstr("tapfit import")))))
        << text;
  }
}

TEST_F(Bundle, TakesAByteOrderMark) {
  folder_.write("test.json", "\xef\xbb\xbf" + good().dump());
  EXPECT_NO_THROW((void)read_test_bundle(folder_.path() / "test.json"));
}

TEST_F(Bundle, SurvivesEveryTruncation) {
  const std::string text = good().dump(1);
  for (std::size_t n = 0; n + 1 < text.size(); n += 7) {
    folder_.write("test.json", text.substr(0, n));
    EXPECT_THROW((void)read_test_bundle(folder_.path()), InputError) << n;
  }
}

TEST_F(Bundle, RefusesWithThePlace) {
  const auto with = [](const std::string& pointer, const json& value) {
    json document = good();
    document[json::json_pointer(pointer)] = value;
    return document;
  };
  refuses(with("/tapfit", 2), "test.json: tapfit");
  refuses(json::array(), "test.json");
  refuses(with("/channels/0/unit", "m"), "test.json: channels[0].unit");
  refuses(with("/channels/0/quantity", "voltage"),
          "test.json: channels[0].quantity");
  refuses(with("/channels/0/sensitivity", 0.0),
          "test.json: channels[0].sensitivity");
  refuses(with("/channels/0/sensitivity", "2"),
          "test.json: channels[0].sensitivity");
  refuses(with("/channels/0/sensitivity_unit", "mV/g"),
          "test.json: channels[0].sensitivity_unit");
  refuses(with("/channels/0/full_scale_volts", 0),
          "test.json: channels[0].full_scale_volts");
  refuses(with("/channels/1/name", "hammer"), "test.json: channels[1].name");
  refuses(with("/runs/0/sensors", json::array()), "test.json: runs[0].sensors");
  refuses(with("/runs/0/sensors/0/channel", "acc9"),
          "test.json: runs[0].sensors[0].channel");
  refuses(with("/runs/0/sensors/0/channel", "hammer"),
          "test.json: runs[0].sensors[0].channel");
  refuses(with("/runs/0/sensors/0/channel", 1),
          "test.json: runs[0].sensors[0].channel");
  refuses(with("/runs/0/sensors/0/point", "1:W"),
          "test.json: runs[0].sensors[0].point");
  refuses(with("/runs/0/hammer/channel", "acc1"),
          "test.json: runs[0].hammer.channel");
  refuses(with("/runs/0/hammer/node", 0), "test.json: runs[0].hammer.node");
  refuses(with("/runs/0/hammer/node", 2.5), "test.json: runs[0].hammer.node");
  refuses(with("/runs/0/hammer/direction", "up"),
          "test.json: runs[0].hammer.direction");
  refuses(with("/band_hz", {30.0, 0.5}), "test.json: band_hz");
  refuses(with("/band_hz", {0.0, 5.0}), "test.json: band_hz");
  refuses(with("/band_hz/0", -1), "test.json: band_hz[0]");
  refuses(with("/model", "gone.bdf"), "test.json: model");
  refuses(with("/units", "furlongs"), "test.json: units");
  refuses(with("/uncertain/0/element_property", 1), "test.json: uncertain[0]");
  refuses(with("/trigger_percent", 0), "test.json: trigger_percent");
  refuses(with("/trigger_slope", "up"), "test.json: trigger_slope");
  refuses(with("/suspension_hz", 0), "test.json: suspension_hz");
  refuses(with("/suspension_hz", 1e308), "test.json: suspension_hz");
  refuses(with("/block_s", 1e308), "test.json: block_s");
  // Its square is 0: a weight without end.
  refuses(with("/uncertain/0/sd_percent", 1e-300),
          "test.json: uncertain[0].sd_percent");
  refuses(with("/band_hz/1", 1e308), "test.json: band_hz[1]");
  refuses(with("/channels/1/mass_kg", 1e308), "test.json: channels[1].mass_kg");
  refuses(with("/channels/1/height_m", -1e308),
          "test.json: channels[1].height_m");
  refuses(with("/channels/0/full_scale_volts", 1e308),
          "test.json: channels[0].full_scale_volts");
  for (const double sensitivity : {0.0, 1e-308, -1e308}) {
    refuses(with("/channels/0/sensitivity", sensitivity),
            "test.json: channels[0].sensitivity");
  }
}

TEST_F(Bundle, SaysWhatIsInAFilesPlace) {
  std::filesystem::create_directory(folder_.path() / "folder");
  json document = good();
  document["model"] = "folder";
  try {
    read(document);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is a folder"));
  }
}

TEST_F(Bundle, IsFoundUnderNearlyItsName) {
  std::filesystem::create_directory(folder_.path() / "plate-absorber");
  try {
    (void)read_test_bundle(folder_.path() / "plate-absorbr");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.remedy(),
                ::testing::StartsWith("did you mean plate-absorber? "));
  }
}

TEST_F(Bundle, NamesMissingFields) {
  json document = good();
  document["runs"][0]["hammer"].erase("node");
  refuses(document, "test.json: runs[0].hammer");
  document = good();
  document["channels"][1].erase("sensitivity");
  refuses(document, "test.json: channels[1]");
  document = good();
  document.erase("channels");
  refuses(document, "test.json: channels");
}

TEST_F(Bundle, ComesBackAsItWasWritten) {
  TestBundle bundle = read(good());
  bundle.block_s = 2.5;
  bundle.suspension_hz = 1.6;
  bundle.trigger = {3.0, -1, 40.0, 0.3};
  folder_.write("test.json", test_bundle_text(bundle, folder_.path()));
  const TestBundle again = read_test_bundle(folder_.path());
  EXPECT_EQ(again.title, bundle.title);
  EXPECT_EQ(again.deck, bundle.deck);
  EXPECT_EQ(again.block_s, 2.5);
  EXPECT_EQ(again.suspension_hz, 1.6);
  EXPECT_EQ(again.trigger.range_percent, 3.0);
  EXPECT_EQ(again.trigger.slope, -1);
  EXPECT_EQ(again.trigger.rearm_percent, 40.0);
  EXPECT_EQ(again.trigger.hold_off_s, 0.3);
  EXPECT_EQ(again.band_hz, bundle.band_hz);
  EXPECT_EQ(again.uncertain[1].id, 7);
  for (std::size_t c = 0; c < 2; ++c) {
    // One rounding in the division by the unit's factor and back.
    EXPECT_NEAR(again.channels[c].full_scale_si(),
                bundle.channels[c].full_scale_si(),
                1e-12 * bundle.channels[c].full_scale_si());
  }
  EXPECT_EQ(again.runs[0].file, bundle.runs[0].file);
  EXPECT_EQ(again.runs[0].sensors[0].dof, bundle.runs[0].sensors[0].dof);
}

TEST(BundleFolder, MustBeThere) {
  EXPECT_THROW((void)read_test_bundle("/nowhere/at/all"), InputError);
}

}  // namespace
}  // namespace tapfit::acquisition
