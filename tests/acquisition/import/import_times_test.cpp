// Times of an import in other units than seconds.
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/import/import_recordings.hpp"
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

}  // namespace
}  // namespace tapfit::acquisition
