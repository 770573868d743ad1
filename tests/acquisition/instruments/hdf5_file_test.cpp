// HDF5 files, written by the library through hdf5_writer.hpp, and netCDF4 of
// rattlesnake's form: files/rattlesnake.nc, written by
//
//   import netCDF4, numpy as np
//   h = netCDF4.Dataset('rattlesnake.nc', 'w', format='NETCDF4')
//   h.createDimension('response_channels', 4)
//   h.createDimension('time_samples', None)
//   h.createDimension('num_environments', 1)
//   h.sample_rate = 2048; h.time_per_read = 0.25; h.hardware_file = 'None'
//   h.createVariable('time_data', 'f8', ('response_channels', 'time_samples'),
//                    chunksizes=(4, 256))
//   h.createVariable('environment_names', str, ('num_environments',))[0] = 'M'
//   table = dict(node_number=['3', '12', '12', ''],
//                node_direction=['Z+', 'X+', 'Z-', ''],
//                comment=['', '', 'glued', ''],
//                sensitivity=['2.25', '100', '98.5', '1000'],
//                unit=['N', 'g', 'g', 'V'],
//                channel_type=['Force', 'Acceleration', 'Acceleration',
//                              'Voltage'])
//   for key, column in table.items():
//     v = h.createVariable('/channels/' + key, str, ('response_channels',))
//     for i, text in enumerate(column): v[i] = text
//   x = np.zeros((4, 512)); n = np.arange(312)
//   x[0, 200:204] = [10, 40, 30, 5]
//   x[1, 200:] = 0.5 * np.exp(-n / 60) * np.sin(0.3 * n)
//   x[2, 200:] = 0.8 * np.exp(-n / 80) * np.sin(0.2 * n)
//   x[3] = 0.1 * np.sin(np.arange(512))
//   h.variables['time_data'][:, 0:256] = x[:, :256]
//   h.variables['time_data'][:, 256:512] = x[:, 256:]
//   h.createGroup('M').samples_per_frame = 512
//   h.close()
#include "acquisition/instruments/hdf5_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/units.hpp"
#include "acquisition/instruments/instrument_file.hpp"
#include "tests/acquisition/support/hdf5_writer.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

class Hdf5 : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "run.h5";
};

TEST_F(Hdf5, DatasetsAndAttributesComeByTheirPaths) {
  Eigen::MatrixXd table(3, 2);
  table << 1, 2, 7, 9, 5, 4;
  {
    testing::Hdf5Writer writer(file_);
    writer.attribute("/", "fs", 512.0);
    writer.group("run");
    writer.numbers("run/acc", table, true);
    writer.numbers("run/raw", table.col(1), false, H5T_STD_I16BE);
    writer.attribute("run/acc", "unit", "m/s^2");
    writer.texts("run/names", {"left", "right"});
  }
  const auto arrays = read_hdf5_arrays(file_);
  EXPECT_EQ(columns_of(arrays, {"run/acc:1", "run/acc:2", "run/raw"}, file_),
            (Eigen::MatrixXd(3, 3) << table, table.col(1)).finished());
  EXPECT_EQ(number_of(arrays, "fs", file_), 512.0);
  const NamedArray* unit = find_array(arrays, "run/acc@unit");
  ASSERT_NE(unit, nullptr);
  EXPECT_EQ(unit->texts, std::vector<std::string>{"m/s^2"});
  const InstrumentFile read = read_instrument_file(file_);
  ASSERT_EQ(read.records.size(), 3U);
  EXPECT_EQ(read.records[0].name, "left");
  EXPECT_EQ(read.records[1].name, "right");
  EXPECT_EQ(read.records[1].unit, "m/s^2");
  EXPECT_EQ(read.records[1].rate_hz, 512.0);
  EXPECT_EQ(read.records[2].name, "raw");
  EXPECT_EQ(read.records[2].unit, "");
}

TEST_F(Hdf5, NothingFromOtherFilesIsRead) {
  {
    testing::Hdf5Writer other(folder_.path() / "other.h5");
    other.numbers("secret", Eigen::VectorXd::Ones(5));
    testing::Hdf5Writer writer(file_);
    writer.numbers("own", Eigen::Vector3d(1, 5, 2));
    writer.link_outside("linked", "other.h5", "secret");
    writer.link_back("itself");
  }
  const auto arrays = read_hdf5_arrays(file_);
  EXPECT_NE(find_array(arrays, "own"), nullptr);
  EXPECT_EQ(find_array(arrays, "linked"), nullptr);
}

TEST_F(Hdf5, ADatasetLargerThanMemoryIsRefused) {
  {
    testing::Hdf5Writer writer(file_);
    writer.numbers("small", Eigen::Vector3d(1, 5, 2));
  }
  // Announced and never written: it takes no room in the file.
  const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hsize_t dims[] = {hsize_t{1} << 50U};
  const hsize_t chunk[] = {1024};
  const hid_t space = H5Screate_simple(1, dims, nullptr);
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(list, 1, chunk);
  H5Dclose(H5Dcreate2(
      file, "vast", H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT));
  H5Pclose(list);
  H5Sclose(space);
  H5Fclose(file);
  try {
    (void)read_hdf5_arrays(file_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"vast\" has 1.13e+15 values"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(Hdf5, RattlesnakesRecordsComeWithAllThatItsTableSays) {
  const InstrumentFile read = read_instrument_file(
      TAPFIT_SOURCE_DIR "/tests/acquisition/instruments/files/rattlesnake.nc");
  ASSERT_EQ(read.records.size(), 4U);
  const TimeRecord& hammer = read.records[0];
  EXPECT_EQ(hammer.name, "Force 3 Z+");
  EXPECT_EQ(hammer.unit, "N");
  EXPECT_EQ(hammer.rate_hz, 2048.0);
  EXPECT_EQ(hammer.dof, (Dof{3, 3, 1}));
  ASSERT_TRUE(hammer.volts_per_unit);
  EXPECT_DOUBLE_EQ(*hammer.volts_per_unit, 0.00225);
  ASSERT_EQ(hammer.values.size(), 512);
  EXPECT_EQ(hammer.values[201], 40.0);
  EXPECT_EQ(hammer.values[199], 0.0);
  EXPECT_EQ(read.records[2].name, "Acceleration 12 Z-");
  EXPECT_EQ(read.records[2].dof, (Dof{12, 3, -1}));
  EXPECT_DOUBLE_EQ(read.records[2].values[210],
                   0.8 * std::exp(-0.125) * std::sin(2.0));
  EXPECT_EQ(read.records[3].unit, "V");
  EXPECT_EQ(read.records[3].volts_per_unit, std::nullopt);
  EXPECT_EQ(read.frame, 0) << "a stream, not frames";
}

// netCDF4 keeps each length as an empty dataset beside the variables.
TEST_F(Hdf5, LengthsOfNetcdfAreNoRecords) {
  {
    testing::Hdf5Writer writer(file_);
    writer.numbers("acc", Eigen::Vector4d(1, 5, 2, 3));
    writer.numbers("samples", Eigen::Vector4d::Zero());
    writer.attribute("samples",
                     "NAME",
                     "This is a netCDF dimension but not a netCDF variable.");
    // Packed as netCDF packs numbers.
    writer.attribute("acc", "scale_factor", 0.5);
    writer.attribute("acc", "add_offset", 1.0);
    writer.attribute("acc", "units", "mV");
  }
  const InstrumentFile read = read_instrument_file(file_);
  ASSERT_EQ(read.records.size(), 1U);
  EXPECT_EQ(read.records[0].unit, "V");
  EXPECT_DOUBLE_EQ(read.records[0].values[1], 3.5e-3);
}

TEST_F(Hdf5, NetcdfOfVersion3IsRefusedWithAWay) {
  const fs::path file =
      folder_.write("old.nc", std::string("CDF\x01\0\0\0\0", 8));
  try {
    (void)read_instrument_file(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.remedy().find("nccopy -k nc4"), std::string::npos);
  }
}

}  // namespace
}  // namespace tapfit::acquisition
