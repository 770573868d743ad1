// Arrays of a file under the names that they have there, which is what MATLAB,
// numpy, HDF5 and TDMS files have in common.
//
//   acc         a variable, dataset or channel
//   run.acc     a field of a structure; run/acc, a dataset of a group
//   acc@unit    an attribute or property of it
//   acc:2       its second column (row, where those are longer)
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tapfit::acquisition {

struct NamedArray {
  enum class Kind {
    Numbers,
    Text,
    Other,   ///< neither: complex numbers, tables, more than two dimensions
    Damaged  ///< the file lists it and it cannot be read
  };
  std::string name;
  Kind kind = Kind::Other;
  /// Of Numbers. Files that keep rows together give rows for columns.
  Eigen::MatrixXd values = {};
  std::vector<std::string> texts = {};  ///< of Text: one, or a list

  /// Samples along the longer side.
  [[nodiscard]] Eigen::Index samples() const {
    return std::max(values.rows(), values.cols());
  }
  [[nodiscard]] Eigen::Index columns() const {
    return std::min(values.rows(), values.cols());
  }
  /// The k-th column, from 0 on, of the samples along the longer side.
  [[nodiscard]] Eigen::VectorXd column(Eigen::Index k) const;
};

/// Null where there is none of that name.
[[nodiscard]] const NamedArray* find_array(const std::vector<NamedArray>& all,
                                           std::string_view name);

/// The samples of "acc", or of a column "acc:2".
/// @throws InputError for a name that is not there (and which ones are), for
///   what is no real numbers, for a number that is not finite
[[nodiscard]] Eigen::VectorXd samples_of(const std::vector<NamedArray>& all,
                                         const std::string& text,
                                         const std::filesystem::path& file);

/// Several of them side by side, n_samples x names.size().
/// @throws InputError as samples_of, and for differing lengths
[[nodiscard]] Eigen::MatrixXd columns_of(const std::vector<NamedArray>& all,
                                         const std::vector<std::string>& names,
                                         const std::filesystem::path& file);

/// An array of one value.
/// @throws InputError as samples_of, and for more values
[[nodiscard]] double number_of(const std::vector<NamedArray>& all,
                               const std::string& name,
                               const std::filesystem::path& file);

/// What the arrays of one file may take of memory, all together.
class ArrayRoom {
 public:
  explicit ArrayRoom(std::filesystem::path file) : file_(std::move(file)) {}

  /// To be asked before an array is made.
  /// @param name empty: of whatever array
  /// @param values how many numbers it has, of how many dimensions whatever
  /// @throws InputError where memory does not hold them and those before
  void take(const std::string& name, double values);

 private:
  std::filesystem::path file_;
  double values_ = 0.0;
};

/// What to say of an array that is listed and does not come.
[[noreturn]] void throw_damaged(const std::filesystem::path& file,
                                const std::string& what);

/// One array to a stream, and all of a stream up to its end, wherever that is.
void send_array(const NamedArray& array, std::FILE* out);
[[nodiscard]] std::vector<NamedArray> receive_arrays(std::FILE* in);

}  // namespace tapfit::acquisition
