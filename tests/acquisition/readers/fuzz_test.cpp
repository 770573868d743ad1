// Readers on damaged files: each is read or refused with an InputError, never
// anything else. TAPFIT_FUZZ_ROUNDS=100000 looks longer; the input that brings
// a reader down is left in its file, named by the test.
#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/read_time_table.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/readers/mat_file.hpp"
#include "acquisition/uff/uff_function.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "acquisition/uff/uff_shapes.hpp"
#include "tests/acquisition/support/mat_text.hpp"
#include "tests/acquisition/support/mutation.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/acquisition/support/uff_text.hpp"
#include "tests/support/matchers.hpp"

#include <functional>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using testing::fuzz_rounds;
using testing::mutated;

// Counts what was read; anything but an InputError fails the test.
int survive(const std::string& good,
            int rounds,
            const fs::path& file,
            const std::function<void(const fs::path&)>& read) {
  std::mt19937_64 random(7);
  int accepted = 0;
  for (int k = 0; k < rounds; ++k) {
    const std::string bad = mutated(good, random);
    std::ofstream(file, std::ios::binary) << bad;
    try {
      read(file);
      ++accepted;
    } catch (const InputError& error) {
      EXPECT_FALSE(error.remedy().empty());
    } catch (const std::exception& error) {
      ADD_FAILURE() << "round " << k << ": " << error.what();
      return accepted;
    }
  }
  return accepted;
}

class Fuzz : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  [[nodiscard]] fs::path file(const std::string& name) const {
    return folder_.path() / name;
  }
};

TEST_F(Fuzz, Bundles) {
  folder_.write("run.wav", "");
  const std::string good = R"({"tapfit": 1, "title": "t", "channels": [
    {"name": "h", "quantity": "force", "unit": "N", "sensitivity": 2.0,
     "sensitivity_unit": "mV/N", "full_scale_volts": 5.0},
    {"name": "a", "quantity": "acceleration", "unit": "g", "sensitivity": 100,
     "sensitivity_unit": "mV/g", "full_scale_volts": 5.0, "mass_kg": 0.02}],
    "runs": [{"file": "run.wav",
    "hammer": {"channel": "h", "node": 3, "direction": "+Z"},
    "sensors": [{"channel": "a", "point": "1:+Z"}]}], "band_hz": [0.5, 30.0],
    "trigger_slope": "rising", "hold_off_s": 0.2,
    "uncertain": [{"material": 1, "property": "E", "sd_percent": 3.0}]})";
  survive(good, fuzz_rounds(200), file("test.json"), [](const fs::path& f) {
    (void)read_test_bundle(f.parent_path());
  });
}

TEST_F(Fuzz, SoundFiles) {
  Eigen::MatrixXd x(300, 2);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x.data()[i] = std::sin(0.05 * static_cast<double>(i));
  }
  for (const AudioFormat format :
       {AudioFormat::Flac24, AudioFormat::Wav24, AudioFormat::WavFloat64}) {
    write_audio(file("good"), x, 512, format);
    // Mostly the header: the rest is numbers, whatever they are.
    std::string good = bytes_of(file("good"));
    good.resize(std::min<std::size_t>(good.size(), 400));
    survive(good, fuzz_rounds(100), file("bad"), [](const fs::path& f) {
      (void)read_audio(f);
    });
  }
}

// Kept or not, what is wrong with the values is told alike.
void read_both_ways(const UffDataset& dataset) {
  EXPECT_EQ(refusal_of([&] { (void)check_function(dataset); }),
            refusal_of([&] { (void)read_function(dataset); }));
  (void)read_function(dataset);
}

TEST_F(Fuzz, UniversalFiles) {
  const std::string good =
      "    -1\n   164\n         1SI\n  1.0D+00  1.0D+00  1.0D+00\n    -1\n" +
      testing::uff_ascii({.axis = 13, .unit = "N", .values = {0, 4, 0, 1, 2}}) +
      testing::uff_binary({.unit = "g", .values = {1, 2, 3, 4, 5}}) +
      "    -1\n    15\n         7         1         0         1  0.0  1.0  "
      "2.0\n"
      "    -1\n    -1\n    82\n         1         3         8\nx\n"
      "         7         8         7\n    -1\n    -1\n  2412\n"
      "         1        44         0         0         1         4\n"
      "         3         4         5         6\n    -1\n"
      "    -1\n    55\nA\nB\nC\nD\nE\n"
      "         1         3         2         8         5         3\n"
      "         2         6         0         2\n"
      " -3.00000E+00 4.00000E+00 1.00000E+00 0.0E+0 0.0E+0 0.0E+0\n"
      "        11\n  1.0  2.0  0.0  0.0  3.0  4.0\n    -1\n";
  const int accepted =
      survive(good, fuzz_rounds(500), file("bad.uff"), [](const fs::path& f) {
        const UffFile uff = open_uff(f);
        UffGeometry geometry;
        for (const UffDataset& dataset : uff.datasets) {
          add_geometry(dataset, geometry);
          if (dataset.type == 55 || dataset.type == 2414) {
            (void)read_shape(dataset);
          }
          if (dataset.type == 58) read_both_ways(dataset);
        }
        if (is_uff(f)) (void)read_recordings(read_test_bundle(f));
      });
  EXPECT_GT(accepted, 0) << "tolerant reading takes some of them";
}

TEST_F(Fuzz, MatlabFiles) {
  const std::string good =
      testing::mat4_variable("force", Eigen::VectorXd::LinSpaced(20, 0, 1)) +
      testing::mat4_variable("acc", Eigen::MatrixXd::Random(20, 2));
  const auto read = [](const fs::path& f) {
    (void)columns_of(read_mat_arrays(f), {"force", "acc:2"}, f);
  };
  survive(good, fuzz_rounds(200), file("bad.mat"), read);
}

TEST_F(Fuzz, Sep005AndCsv) {
  survive(R"([{"name": "h", "data": [0, 3.5, 0], "unit_str": "N", "fs": 128},
              {"name": "a", "data": [1, 2, 3], "time": [0.5, 0.6, 0.7]}])",
          fuzz_rounds(200),
          file("bad.json"),
          [](const fs::path& f) {
            (void)read_time_table(f, {"h", "2"}, {});
          });
  survive("time;force;acc\n0,0;1,5;2\n0,1;-2e3;4\n0,2;0;1\n",
          fuzz_rounds(200),
          file("bad.csv"),
          [](const fs::path& f) {
            (void)read_time_table(f, {"force", "3"}, {});
          });
}

}  // namespace
}  // namespace tapfit::acquisition
