// Files of instruments with bytes changed, cut, doubled: each is read or
// refused with an InputError that names the file. TAPFIT_FUZZ_ROUNDS=100000
// looks longer.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/read_time_records.hpp"
#include "acquisition/instruments/instrument_file.hpp"
#include "tests/acquisition/support/hdf5_writer.hpp"
#include "tests/acquisition/support/mutation.hpp"
#include "tests/acquisition/support/npy_text.hpp"
#include "tests/acquisition/support/tdms_text.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <matio.h>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

class DamagedInstruments : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;

  // Reads as import does; how often that went well.
  void survive_one(const fs::path& file, const std::string& what) {
    try {
      (void)read_time_records(file, {});
      ++accepted_;
    } catch (const InputError& error) {
      EXPECT_FALSE(error.remedy().empty());
      EXPECT_NE(error.where().find(file.filename().string()), std::string::npos)
          << what << ": " << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << what << ": " << error.what();
    }
  }

  void survive(const std::string& name, const std::string& good, int rounds) {
    std::mt19937_64 random(11);
    for (int k = 0; k < rounds && !HasFailure(); ++k) {
      const fs::path file = folder_.write(name, testing::mutated(good, random));
      survive_one(file, name + ", round " + std::to_string(k));
    }
  }

  void survive_cuts(const std::string& name,
                    const std::string& good,
                    std::size_t step) {
    for (std::size_t size = 0; size < good.size(); size += step) {
      const fs::path file = folder_.write(name, good.substr(0, size));
      survive_one(file, name + ", cut at " + std::to_string(size));
    }
  }

  int accepted_ = 0;
};

TEST_F(DamagedInstruments, Tdms) {
  for (const bool big : {false, true}) {
    const std::string good =
        testing::tdms_hammer_test({0, 7, -1, 3}, {1, 5, 2, 4}, big);
    survive("a.tdms", good + good, testing::fuzz_rounds(400));
    survive_cuts("a.tdms", good, 1);
  }
  EXPECT_GT(accepted_, 0) << "where samples alone are changed";
}

TEST_F(DamagedInstruments, Numpy) {
  const std::string array = testing::npy({0, 7, -1, 3, 5, 1, 2});
  survive("a.npy", array, testing::fuzz_rounds(300));
  survive_cuts("a.npy", array, 1);
  for (const bool deflated : {false, true}) {
    const std::string good = testing::zip(
        {{"force.npy", array}, {"fs.npy", testing::npy({512.0})}}, deflated);
    survive("a.npz", good, testing::fuzz_rounds(300));
    survive_cuts("a.npz", good, 7);
  }
}

// Where the library comes down, its own process does.
TEST_F(DamagedInstruments, Hdf5) {
  const fs::path file = folder_.path() / "good.h5";
  {
    testing::Hdf5Writer writer(file);
    writer.attribute("/", "fs", 512.0);
    writer.group("run");
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(20, 2);
    values(3, 0) = 5.0;
    writer.numbers("run/acc", values, true);
    writer.attribute("run/acc", "unit", "m/s^2");
    writer.texts("run/names", {"left", "right"});
  }
  const std::string plain = testing::bytes_of(file);
  const std::string netcdf = testing::bytes_of(
      TAPFIT_SOURCE_DIR "/tests/acquisition/instruments/files/rattlesnake.nc");
  ASSERT_GT(netcdf.size(), 1000U);
  survive("a.h5", plain, testing::fuzz_rounds(150));
  survive("a.nc", netcdf, testing::fuzz_rounds(100));
  survive_cuts("a.nc", netcdf, 997);
}

// Version 7.3 is HDF5 behind a header of MATLAB's.
TEST_F(DamagedInstruments, MatlabFilesOfVersion73) {
  const fs::path file = folder_.path() / "good.mat";
  mat_t* made = Mat_CreateVer(file.c_str(), nullptr, MAT_FT_MAT73);
  ASSERT_NE(made, nullptr);
  double samples[] = {0, 7, -1, 3};
  std::size_t dims[] = {4, 1};
  matvar_t* variable =
      Mat_VarCreate("acc", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, samples, 0);
  EXPECT_EQ(Mat_VarWrite(made, variable, MAT_COMPRESSION_NONE), 0);
  Mat_VarFree(variable);
  Mat_Close(made);
  const std::string good = testing::bytes_of(file);
  survive("a.mat", good, testing::fuzz_rounds(100));
  survive_cuts("a.mat", good, 211);
}

}  // namespace
}  // namespace tapfit::acquisition
