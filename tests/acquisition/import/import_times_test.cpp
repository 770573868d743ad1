// Times of an import in other units than seconds.
#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/import_recordings.hpp"
#include "acquisition/import/propose_import.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

ImportOptions options_for(const std::filesystem::path& bundle) {
  ImportOptions options;
  options.hammer = {.column = "f",
                    .channel = "hammer",
                    .quantity = Quantity::Force,
                    .unit = "N",
                    .dof = {7, 3, 1}};
  options.sensors = {
      {.column = "a", .channel = "acc1", .unit = "m/s^2", .dof = {2, 1, 1}}};
  options.folder = bundle;
  return options;
}

// 256 Hz, however the file counts its times.
TEST(ImportTimes, TimesAreInWhatTheirHeaderSays) {
  testing::TemporaryFolder folder;
  struct Header {
    std::string text;
    double per_second;
  };
  for (const Header& header : {Header{"t [s],f,a", 1.0},
                               Header{"time [ms],f,a", 1e3},
                               Header{"Zeit (ms),f,a", 1e3},
                               Header{"Zeit / ms,f,a", 1e3},
                               Header{"time_ms,f,a", 1e3},
                               Header{"t,f,a\nms,N,g", 1e3},
                               Header{"t [us],f,a", 1e6},
                               Header{"t [\xb5s],f,a", 1e6}}) {
    std::string text = header.text + "\n";
    for (int i = 0; i < 9; ++i) {
      text += fmt::format(
          "{},{},{}\n", i / 256.0 * header.per_second, i % 7, i % 5);
    }
    const std::size_t number = std::hash<std::string>{}(header.text);
    ImportOptions options = options_for(folder.path() / std::to_string(number));
    options.files = {{folder.write("a.csv", text), {}}};
    const TestBundle bundle = import_recordings(options);
    EXPECT_EQ(read_recordings(bundle)[0].sample_rate_hz, 256.0) << header.text;
    EXPECT_EQ(bundle.warnings.empty(), header.per_second == 1.0);
    if (bundle.warnings.empty()) continue;
    EXPECT_NE(bundle.warnings[0].find("the times of column \"1\" are in"),
              std::string::npos)
        << bundle.warnings[0];
  }
}

// "12:00:00.003" of the k-th sample at 1000 Hz, from just before a midnight on.
std::string clock_of(int k) {
  const int ms = (86'400'000 - 20 + k) % 86'400'000;
  return fmt::format("{:02}:{:02}:{:02}.{:03}",
                     ms / 3'600'000,
                     ms / 60'000 % 60,
                     ms / 1000 % 60,
                     ms % 1000);
}

TEST(ImportTimes, TimesOfDayAreTimes) {
  testing::TemporaryFolder folder;
  int number = 0;
  for (const char* form : {"{},",
                           "2024-01-31T{},",
                           "2024-01-31T{}Z,",
                           "2024-01-31T{}+01:00,",
                           "31.01.2024 {},",
                           "1/31/24,{},"}) {
    std::string text =
        form[0] == '1' ? "Date,Time,Force,Acc\n" : "Stamp,Force,Acc\n";
    for (int k = 0; k < 40; ++k) {
      text += fmt::format(fmt::runtime(form), clock_of(k)) +
              fmt::format("{},{}\n", k == 5 ? 9 : 0, k % 5 - 2);
    }
    ImportOptions options;
    options.files = {{folder.write("a.csv", text), {}}};
    options.folder = folder.path() / std::to_string(++number);
    const ImportProposal proposal = propose_import(options);
    EXPECT_EQ(proposal.options.hammer.channel, "Force") << form;
    ASSERT_EQ(proposal.options.sensors.size(), 1U) << form;
    const Recording recording =
        read_recordings(import_recordings(proposal.options)).at(0);
    EXPECT_EQ(recording.sample_rate_hz, 1000.0) << form;
    EXPECT_EQ(recording.samples(5, 0), 9.0);
    // Left out where the rate is given, whatever it says.
    options.sample_rate_hz = 512.0;
    options.folder = folder.path() / std::to_string(++number);
    EXPECT_EQ(
        read_recordings(import_recordings(propose_import(options).options))
            .at(0)
            .sample_rate_hz,
        512.0);
  }
}

TEST(ImportTimes, WholeSecondsOfTheDayGiveNoRateAndAreNoChannel) {
  testing::TemporaryFolder folder;
  std::string text = "Time,Force,Acc\n";
  for (int k = 0; k < 40; ++k) {
    text +=
        fmt::format("12:00:{:02},{},{}\n", k / 10, k == 5 ? 9 : 0, k % 5 - 2);
  }
  ImportOptions options;
  options.files = {{folder.write("a.csv", text), {}}};
  options.folder = folder.path() / "bundle";
  EXPECT_THROW((void)import_recordings(propose_import(options).options),
               InputError);
  options.sample_rate_hz = 512.0;
  const TestBundle bundle = import_recordings(propose_import(options).options);
  EXPECT_EQ(bundle.channels.size(), 2U);
}

TEST(ImportTimes, MillisecondsWithoutAUnitAreSuspected) {
  testing::TemporaryFolder folder;
  const auto csv = [&](double step) {
    std::string text = "t,f,a\n";
    for (int i = 0; i < 9; ++i) {
      text += fmt::format("{},{},{}\n", i * step, i % 7, i % 5);
    }
    return folder.write("a.csv", text);
  };
  ImportOptions options = options_for(folder.path() / "bundle");
  options.files = {{csv(1.953125), {}}};
  try {
    (void)import_recordings(options);
    FAIL() << "0.512 Hz were taken";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("times in ms are 512 Hz"), std::string::npos) << said;
    EXPECT_NE(said.find("\"t [ms]\""), std::string::npos) << said;
  }
  options.files = {{csv(0.5), {}}};
  const TestBundle bundle = import_recordings(options);
  ASSERT_FALSE(bundle.warnings.empty());
  EXPECT_NE(bundle.warnings[0].find("times in ms are 2000 Hz"),
            std::string::npos)
      << bundle.warnings[0];
}

}  // namespace
}  // namespace tapfit::acquisition
