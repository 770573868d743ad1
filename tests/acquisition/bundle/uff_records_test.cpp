// Time records written and read again; each line held to the columns of the
// format's description.
#include "acquisition/bundle/uff_records.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/uff/write_uff_geometry.hpp"
#include "tests/acquisition/support/mutation.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <cmath>
#include <sstream>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

Channel channel(const std::string& name, Quantity quantity, double full_scale) {
  Channel result;
  result.name = name;
  result.quantity = quantity;
  result.unit = quantity == Quantity::Force ? "N" : "g";
  result.unit_to_si = quantity == Quantity::Force ? 1.0 : 9.80665;
  result.full_scale_volts = full_scale;
  return result;
}

class UffRecords : public ::testing::Test {
 protected:
  UffRecords() {
    bundle_.title = "Fachwerk mit St\xc3\xb6rung";
    bundle_.channels = {channel("hammer", Quantity::Force, 50.0),
                        channel("a", Quantity::Acceleration, 5.0),
                        channel("b", Quantity::Acceleration, 8.0)};
    bundle_.band_hz = {0.5, 30.125};
    for (int r = 0; r < 2; ++r) {
      Eigen::MatrixXd x(501, 3);
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        x.data()[i] = std::sin(0.37 * static_cast<double>(i + r)) / 3.0;
      }
      acquisition::Run run;
      run.file = folder_.path() / (r == 0 ? "a.wav" : "b.wav");
      write_audio(run.file, x, 1999, AudioFormat::WavFloat64);
      run.hammer = {0, {r + 1, 3, 1}};
      run.sensors = {{1, {11, 3, -1}}, {2, {123456, 1, 1}}};
      bundle_.runs.push_back(run);
    }
  }
  fs::path written(UffEncoding encoding) {
    std::ostringstream out;
    write_uff_records(bundle_, encoding, out);
    return folder_.write("records.uff", out.str());
  }

  testing::TemporaryFolder folder_;
  TestBundle bundle_;
};

TEST_F(UffRecords, ComeBackAsTheyWere) {
  const std::vector<Recording> first = read_recordings(bundle_);
  for (const UffEncoding encoding : {UffEncoding::Binary, UffEncoding::Text}) {
    const TestBundle back = read_test_bundle(written(encoding));
    ASSERT_EQ(back.runs.size(), 2U);
    EXPECT_EQ(back.band_hz, bundle_.band_hz);
    for (std::size_t r = 0; r < 2; ++r) {
      EXPECT_EQ(back.runs[r].hammer.dof, bundle_.runs[r].hammer.dof);
      ASSERT_EQ(back.runs[r].sensors.size(), 2U);
      EXPECT_EQ(back.runs[r].sensors[0].dof, bundle_.runs[r].sensors[0].dof);
      EXPECT_EQ(back.runs[r].sensors[1].dof, bundle_.runs[r].sensors[1].dof);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_DOUBLE_EQ(back.channels[c].full_scale_si(),
                       bundle_.channels[c].full_scale_si());
    }
    const std::vector<Recording> second = read_recordings(back);
    // Doubles as they are; 13 digits as text.
    const double tolerance = encoding == UffEncoding::Binary ? 0.0 : 1e-12;
    for (std::size_t r = 0; r < 2; ++r) {
      EXPECT_EQ(second[r].sample_rate_hz, 1999.0);
      EXPECT_TRUE(((second[r].samples - first[r].samples).array().abs() <=
                   tolerance * first[r].samples.array().abs())
                      .all());
    }
  }
}

TEST_F(UffRecords, KeepARateThatIsNoWholeNumber) {
  Recording recording;
  recording.sample_rate_hz = 1234.5678901;
  recording.samples = Eigen::MatrixXd::Random(20, 3);
  std::ostringstream out;
  int number = 1;
  write_uff_run(
      bundle_, bundle_.runs[0], recording, UffEncoding::Binary, number, out);
  EXPECT_EQ(number, 4);
  const TestBundle back = read_test_bundle(folder_.write("r.uff", out.str()));
  EXPECT_DOUBLE_EQ(read_recordings(back)[0].sample_rate_hz, 1234.5678901);
}

// Columns counted by hand from the description of dataset 58.
TEST_F(UffRecords, KeepTheirColumns) {
  const std::string text = testing::bytes_of(written(UffEncoding::Text));
  for (const char c : text) EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
  std::istringstream lines(text);
  std::vector<std::string> line;
  for (std::string next; std::getline(lines, next);) {
    EXPECT_LE(next.size(), 80U);
    line.push_back(next);
  }
  const auto start = static_cast<std::size_t>(
      std::find(line.begin(), line.end(), "    58") - line.begin());
  ASSERT_LT(start + 13, line.size());
  const std::string& who = line[start + 6];
  EXPECT_EQ(who.substr(0, 5), "    1");
  EXPECT_EQ(who.substr(5, 10), "         1");
  EXPECT_EQ(who.substr(31, 10), "NONE      ");
  EXPECT_EQ(who.substr(41, 10), "         1");
  EXPECT_EQ(who.substr(51, 4), "   3");
  const std::string& form = line[start + 7];
  EXPECT_EQ(form.substr(0, 30), "         4       501         1");
  EXPECT_EQ(form.size(), 69U);
  EXPECT_EQ(line[start + 8].substr(0, 10), "        17");
  EXPECT_EQ(line[start + 9].substr(46, 2), " N");
  EXPECT_EQ(line[start + 12].size(), 80U);
  const std::string binary = testing::bytes_of(written(UffEncoding::Binary));
  EXPECT_THAT(binary,
              HasSubstr("    58b     1     2          11        4008     0"));
}

TEST(WriteGeometry, ComesBack) {
  UffGeometry geometry;
  geometry.nodes[7] = {0.1, -2.5e-3, 1.0 / 3.0};
  geometry.nodes[1234567] = {1.0, 2.0, 3.0};
  geometry.nodes[8] = Eigen::Vector3d::Zero();
  geometry.trace_lines = {{7, 8, 1234567, 7}, {8, 7}};
  for (const UffNodes as : {UffNodes::D2411, UffNodes::D15}) {
    std::ostringstream out;
    write_geometry(geometry, as, out);
    const std::string text = out.str();
    UffGeometry back;
    for (const UffDataset& dataset : split_uff(text, "g.uff")) {
      add_geometry(dataset, back);
    }
    ASSERT_EQ(back.nodes.size(), geometry.nodes.size());
    for (const auto& [label, x] : geometry.nodes) {
      // 2411 has all digits, 15 six.
      const double off = as == UffNodes::D15 ? 5e-6 * x.norm() : 0.0;
      EXPECT_LE((back.nodes.at(label) - x).norm(), off) << label;
    }
    EXPECT_EQ(back.trace_lines, geometry.trace_lines);
  }
}

// 4I10,1P3E13.5, column by column, whatever the numbers.
TEST(WriteGeometry, Dataset15KeepsItsColumns) {
  UffGeometry geometry;
  geometry.nodes[2147483647] = {-1.0 / 3.0, -2e-105, 1e100};
  std::ostringstream out;
  write_geometry(geometry, UffNodes::D15, out);
  EXPECT_EQ(out.str(),
            "    -1\n"
            "    15\n"
            "2147483647         0         0        11"
            " -3.33333E-01-2.00000E-105 1.00000E+100\n"
            "    -1\n");
}

}  // namespace
}  // namespace tapfit::acquisition
