// Small HDF5 files written by the library itself, for tests.
#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <hdf5.h>
#include <string>
#include <vector>

namespace tapfit::testing {

class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path& file)
      : file_(
            H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  ~Hdf5Writer() { H5Fclose(file_); }
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void group(const std::string& name) {
    H5Gclose(
        H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  /// Rows together, as HDF5 keeps them; packed in chunks where asked for. A
  /// matrix of one column has one dimension.
  void numbers(const std::string& name,
               const Eigen::MatrixXd& values,
               bool packed = false,
               hid_t type = H5T_IEEE_F64LE) {
    const hsize_t dims[] = {static_cast<hsize_t>(values.rows()),
                            static_cast<hsize_t>(values.cols())};
    const int rank = values.cols() == 1 ? 1 : 2;
    const hid_t space = H5Screate_simple(rank, dims, nullptr);
    const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
    if (packed) {
      H5Pset_chunk(list, rank, dims);
      H5Pset_shuffle(list);
      H5Pset_deflate(list, 6);
    }
    const hid_t set = H5Dcreate2(
        file_, name.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT);
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>
        rows = values;
    H5Dwrite(
        set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data());
    H5Dclose(set);
    H5Pclose(list);
    H5Sclose(space);
  }

  /// A list of texts of varying length.
  void texts(const std::string& name, const std::vector<std::string>& list) {
    const hsize_t count = list.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t type = varying_text();
    const hid_t set = H5Dcreate2(file_,
                                 name.c_str(),
                                 type,
                                 space,
                                 H5P_DEFAULT,
                                 H5P_DEFAULT,
                                 H5P_DEFAULT);
    std::vector<const char*> pointers;
    for (const std::string& text : list) pointers.push_back(text.c_str());
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data());
    H5Dclose(set);
    H5Tclose(type);
    H5Sclose(space);
  }

  void attribute(const std::string& object,
                 const std::string& name,
                 double value) {
    attribute(object, name, H5T_IEEE_F64BE, H5T_NATIVE_DOUBLE, &value);
  }
  /// Of fixed length.
  void attribute(const std::string& object,
                 const std::string& name,
                 const std::string& text) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, text.size());
    attribute(object, name, type, type, text.data());
    H5Tclose(type);
  }

  void link_outside(const std::string& name,
                    const std::string& file,
                    const std::string& object) {
    H5Lcreate_external(file.c_str(),
                       object.c_str(),
                       file_,
                       name.c_str(),
                       H5P_DEFAULT,
                       H5P_DEFAULT);
  }
  /// A group in itself.
  void link_back(const std::string& name) {
    H5Lcreate_hard(file_, "/", file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }

 private:
  static hid_t varying_text() {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
  }
  void attribute(const std::string& object,
                 const std::string& name,
                 hid_t type,
                 hid_t memory,
                 const void* value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t made = H5Acreate_by_name(file_,
                                         object.c_str(),
                                         name.c_str(),
                                         type,
                                         space,
                                         H5P_DEFAULT,
                                         H5P_DEFAULT,
                                         H5P_DEFAULT);
    H5Awrite(made, memory, value);
    H5Aclose(made);
    H5Sclose(space);
  }

  hid_t file_;
};

}  // namespace tapfit::testing
